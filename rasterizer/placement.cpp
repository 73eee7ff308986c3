#include "rasterizer/placement.h"

#include "rasterizer/span_math.h"

namespace scanlit {

namespace {

/// V at the pixels of a span.
class PixelDirections {
 public:
  explicit PixelDirections(const Viewer& viewer)
      : first_(broadcast(viewer.first)),
        right_(broadcast(viewer.right)),
        below_(broadcast(viewer.below)) {}

  /// Unit. At packed pixels.
  Vec3<Batch> operator()(const std::uint32_t* pixel) const {
    const hn::RebindToUnsigned<Batch::Tag> unsigneds;
    const auto packed = hn::LoadU(unsigneds, pixel);
    const Batch x = hn::ConvertTo(Batch::tag, hn::And(packed, hn::Set(unsigneds, 0xffff)));
    const Batch y = hn::ConvertTo(Batch::tag, hn::ShiftRight<16>(packed));
    const auto along = [&](Batch first, Batch right, Batch below) {
      return mul_add(y, below, mul_add(x, right, first));
    };
    const Vec3<Batch> towards{along(first_.x, right_.x, below_.x),
                              along(first_.y, right_.y, below_.y),
                              along(first_.z, right_.z, below_.z)};
    return towards * inverse_sqrt(dot(towards, towards));
  }

 private:
  Vec3<Batch> first_, right_, below_;
};

}  // namespace

void place(const Frame& frame, const Draw& draw, SurfaceSpan& surface, Places& places) {
  const Viewer viewer = frame.viewer;
  const bool each = !viewer.far || !frame.settings.skips.far_directions;
  const bool keep_positions = places_positions(frame, draw);
  // With several samples a fragment may lie beside its pixel's centre.
  const bool by_pixel = !viewer.far && surface.pixel && frame.settings.samples == 1;
  const bool positions = keep_positions || (!viewer.far && !by_pixel);
  const PixelDirections seen_from(viewer);
  const Vec3<Batch> eye = broadcast(viewer.eye), far_direction = broadcast(viewer.direction);
  const glm::mat4& m = draw.object->world_from_object;
  const glm::mat3 linear(m);
  const glm::mat3 normal_from_object = draw.normal_from_object;
  const Vec3<Batch> origin = broadcast(m[3]);

  for (int i = 0; i < surface.size; i += Batch::lanes) {
    Vec3<Batch> to_viewer = far_direction;
    if (positions) {
      const Vec3<Batch> position = transform(linear, load(surface.position, i)) + origin;
      if (!viewer.far) to_viewer = normalize_or(eye - position, far_direction);
      if (keep_positions) store(position, places.position, i);
    }
    if (by_pixel) to_viewer = seen_from(surface.pixel + i);
    if (each) store(to_viewer, places.to_viewer, i);
    store(normalize_or(transform(normal_from_object, load(surface.normal, i)), to_viewer),
          surface.normal, i);
  }
}

}  // namespace scanlit

// A1.6: whole pictures, right to the pixel.
#include <algorithm>

#include "lessons/assignments/A1_scan_conversion/parts.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "models/registry.h"
#include "rasterizer/shapes.h"

namespace scanlit::assignments::scan {

using namespace a1;

namespace {

constexpr int picture_width = 160, picture_height = 120;

Scene teapot_scene() {
  Scene scene;
  Object& teapot = scene.objects.emplace_back();
  teapot.mesh = std::make_shared<const Mesh>(make_shape("teapot:4"));
  teapot.material.model = models::make("blinn-phong:kd=.55/.35/.2,ks=.4,n=30").model;
  teapot.shading = Shading::gouraud;
  teapot.sides = Sides::both;
  scene.lights.emplace_back().direction = {1, 2, 3};
  scene.background = {0.02, 0.03, 0.06};
  return scene;
}

Framebuffer teapot_by(decltype(StageFunctions::spans) spans) {
  const Scene scene = teapot_scene();
  Camera camera;
  camera.eye = {1.5, 3, 6};
  camera = framed(camera, bounding_sphere(scene), double(picture_width) / picture_height);
  camera.fov_deg = 25;  // the handle and the spout leave the picture
  StageFunctions stages;
  stages.spans = std::move(spans);
  RenderSettings settings;
  settings.stages = &stages;
  Framebuffer framebuffer(picture_width, picture_height, {.ids = true});
  render(scene, camera, settings, framebuffer);
  return framebuffer;
}

std::string what_is_there(const Framebuffer& picture, std::size_t pixel) {
  return picture.triangle_id[pixel] == no_id
             ? "the background"
             : "triangle " + std::to_string(picture.triangle_id[pixel]);
}

}  // namespace

Framebuffer right_teapot(const ScanVariant& variant) {
  return teapot_by([&](const ScreenTriangle& t, const Rect&, const EmitSpan& emit) {
    for (const Fragment& f : right_fragments(variant, in_variant(variant, t, picture_height),
                                             {picture_width, picture_height}))
      emit(engine_row(variant, f.row, picture_height), f.column, f.column + 1);
  });
}

Framebuffer box_teapot() {
  return teapot_by([](const ScreenTriangle& t, const Rect& picture, const EmitSpan& emit) {
    const auto& [a, b, c] = t.vertices;
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    for (int y = std::max(top >> 8, 0); y <= std::min(bottom >> 8, picture.y_end - 1); ++y)
      emit(y, left >> 8, (right >> 8) + 1);
  });
}

namespace {

struct Asked {
  Triangle triangle;
  std::vector<Fragment> fragments;  // the student's
};

/// How the variant decides at a pixel, edge by edge.
std::string derivation(const ScanVariant& variant, const Triangle& t, int column, int row) {
  Edge edges[3];
  if (!right_edges(variant, t, edges)) return "has no area";
  std::string text;
  for (const Edge& edge : edges) {
    const std::int64_t value = value_at(variant, edge, column, row);
    text += (text.empty() ? "E = " : ", ") + std::to_string(value);
    if (value == 0) text += edge.owned ? " (on an edge that is owned)" : " (on one that is not)";
  }
  return text;
}

bool holds(const std::vector<Fragment>& fragments, int column, int row) {
  return std::ranges::any_of(fragments,
                             [&](const Fragment& f) { return f.column == column && f.row == row; });
}

/// Where yours and the right coverage of a pixel part, for the first triangle of which they do.
std::string explain(const ScanVariant& variant, const std::vector<Asked>& all,
                    const Picture& picture, int column, int row) {
  for (const Asked& asked : all) {
    const bool yours = holds(asked.fragments, column, row);
    const bool right = holds(right_fragments(variant, asked.triangle, picture), column, row);
    if (yours == right) continue;
    return std::string("\n  there the triangle ") + words(asked.triangle) + "\n  " +
           (yours ? "is covered by yours, and should not be: "
                  : "is not covered by yours, and should be: ") +
           derivation(variant, asked.triangle, column, row);
  }
  return "";
}

/// Emits fragments as the engine wants them, in spans.
void emit_runs(const ScanVariant& variant, const std::vector<Fragment>& fragments,
               const EmitSpan& emit) {
  for (std::size_t i = 0, end; i < fragments.size(); i = end) {
    const Fragment& first = fragments[i];
    for (end = i + 1; end < fragments.size() && fragments[end].row == first.row &&
                      fragments[end].column == first.column + int(end - i);)
      ++end;
    emit(engine_row(variant, first.row, picture_height), first.column, first.column + int(end - i));
  }
}

/// The engine's teapot, of the student's fragments.
Finding test_teapot(Examination& e, const ScanVariant& variant) {
  const Picture picture{picture_width, picture_height};
  std::string complaint;
  std::vector<Asked> all;
  const Framebuffer fresh =
      teapot_by([&](const ScreenTriangle& screen, const Rect&, const EmitSpan& emit) {
        const Triangle t = in_variant(variant, screen, picture_height);
        all.push_back({t, ask_fragments(e.student, variant, t, picture, false)});
        for (const Fragment& f : all.back().fragments)
          if (complaint.empty() && !outside(f, picture).empty())
            complaint = "The triangle " + words(t) + ": " + outside(f, picture) + ".";
        emit_runs(variant, all.back().fragments, emit);
      });
  const Framebuffer reference = right_teapot(variant);
  e.pictures.push_back(judged("A1.6-teapot", "A teapot of your fragments", fresh, reference));
  if (const auto off = first_difference(e.pictures.back(), 0)) {
    const auto pixel = std::size_t(off->y * picture_width + off->x);
    const int row = engine_row(variant, off->y, picture_height);
    complaint = "The teapot: " + std::to_string(off->count) +
                " pixels differ, first that at column " + std::to_string(off->x) + ", row " +
                std::to_string(row) + ":\n  yours:     " + what_is_there(fresh, pixel) +
                "\n  should be: " + what_is_there(reference, pixel) +
                explain(variant, all, picture, off->x, row) +
                (complaint.empty() ? "" : "\n" + complaint);
  }
  return complaint.empty() ? Finding() : Finding::wrong(complaint);
}

/// Triangles that fill the picture and meet at pixel centres and between them, clockwise and
/// counter-clockwise.
std::vector<Triangle> mosaic(Dice& dice, const Picture& picture) {
  constexpr int columns = 6, rows = 5;
  Point corners[rows + 1][columns + 1];
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      corners[j][i] = {128 * (2 * picture.width * i / columns + dice.between(-3, 3)),
                       128 * (2 * picture.height * j / rows + dice.between(-3, 3))};
  std::vector<Triangle> all;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const Point &a = corners[j][i], &b = corners[j][i + 1], &c = corners[j + 1][i],
                  &d = corners[j + 1][i + 1];
      all.push_back(dice.coin() ? Triangle{{a, b, c}} : Triangle{{a, c, b}});
      all.push_back(dice.coin() ? Triangle{{d, c, b}} : Triangle{{d, b, c}});
    }
  return all;
}

/// What is covered once has its triangle's colour, what is covered more often is white.
class MosaicPainter {
 public:
  explicit MosaicPainter(const Picture& picture)
      : framebuffer(picture.width, picture.height),
        counts(std::size_t(picture.width * picture.height)) {}

  void paint(int column, int row, std::size_t triangle) {
    const auto at = std::size_t(row * framebuffer.width + column);
    const bool again = counts[at]++ != 0;
    Dice dice(triangle, "colour");
    for (std::size_t c = 0; c < 3; ++c)
      framebuffer.colour[4 * at + c] = again ? 1.0f : float(dice.real(0.05, 0.5));
  }

  Framebuffer framebuffer;
  std::vector<int> counts;
};

Finding test_mosaic(Examination& e, const ScanVariant& variant) {
  Dice dice(e.questions, "A1.6");
  const Picture picture{48, 36};
  MosaicPainter fresh(picture), reference(picture);
  std::string complaint;
  const std::vector<Triangle> all = mosaic(dice, picture);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const Fragment& f : right_fragments(variant, all[i], picture))
      reference.paint(f.column, engine_row(variant, f.row, picture.height), i);
    for (const Fragment& f : ask_fragments(e.student, variant, all[i], picture, false)) {
      const std::string where = outside(f, picture);
      if (where.empty())
        fresh.paint(f.column, engine_row(variant, f.row, picture.height), i);
      else if (complaint.empty())
        complaint = "The triangle " + words(all[i]) + ": " + where + ".\n";
    }
  }
  e.pictures.push_back(judged("A1.6-mosaic", "Triangles that share edges; white where two overlap",
                              fresh.framebuffer, reference.framebuffer));
  const auto off = first_difference(e.pictures.back(), 0);
  if (!off && complaint.empty()) return {};
  complaint += "Triangles that share edges and fill the picture:\n";
  CoverageGrid grid(picture.width, picture.height);
  grid.covered = fresh.counts, grid.expected = reference.counts;
  const std::string faults = draw_faults(grid, variant.y_up);
  if (!faults.empty() || !off) return Finding::wrong(complaint + faults);
  return Finding::wrong(complaint + std::to_string(off->count) +
                        " pixels belong to another triangle, first that at column " +
                        std::to_string(off->x) + ", row " +
                        std::to_string(engine_row(variant, off->y, picture.height)));
}

}  // namespace

Finding test_picture(Examination& e) {
  const ScanVariant variant = scan_variant(e.variant);
  const Finding of_mosaic = test_mosaic(e, variant);
  const Finding of_teapot = test_teapot(e, variant);
  if (of_mosaic.share == 1 || of_teapot.share == 1)
    return of_mosaic.share < 1 ? of_mosaic : of_teapot;
  return Finding::wrong(of_mosaic.message + "\n" + of_teapot.message);
}

}  // namespace scanlit::assignments::scan

#include "embree_peer.h"

#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <glm/trigonometric.hpp>

#include "rasterizer/batch.h"
#include "rasterizer/error.h"
#include "timing.h"

namespace scanlit::bench {

namespace {

constexpr int tile_size = 32;
constexpr int packet_width = Batch::lanes == 16 ? 16 : 8;

using Packet = std::conditional_t<packet_width == 16, RTCRayHit16, RTCRayHit8>;

[[maybe_unused]] void intersect(const int* valid, RTCScene scene, RTCIntersectContext& context,
                                RTCRayHit16& packet) {
  rtcIntersect16(valid, scene, &context, &packet);
}
[[maybe_unused]] void intersect(const int* valid, RTCScene scene, RTCIntersectContext& context,
                                RTCRayHit8& packet) {
  rtcIntersect8(valid, scene, &context, &packet);
}

void fill(RTCGeometry geometry, const Mesh& mesh, const glm::mat4& world_from_object) {
  auto* const positions = static_cast<glm::vec3*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              sizeof(glm::vec3), mesh.positions.size()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    positions[i] = glm::vec3(world_from_object * glm::vec4(mesh.positions[i], 1));
  void* const indices =
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), mesh.triangle_count());
  std::memcpy(indices, mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
}

}  // namespace

EmbreePeer::EmbreePeer(int threads) : threads_(threads) {
  // The same vectors for both: Embree looks at the processor, Scanlit was built for them.
  const char* const level = Batch::lanes == 16  ? ""
                            : Batch::lanes == 8 ? ",isa=avx2"
                                                : ",isa=sse4.2";
  device_ = rtcNewDevice(("threads=" + std::to_string(threads) + level).c_str());
  if (!device_) throw Error("Embree gives no device");
}

EmbreePeer::~EmbreePeer() {
  if (scene_) rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void EmbreePeer::prepare(const BenchScene& scene) {
  if (scene_) rtcReleaseScene(scene_);
  scene_ = rtcNewScene(device_);
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
  for (const Placement& placement : scene.placements) {
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    fill(geometry, *placement.mesh, world_from_object(scene, placement, 0));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);  // numbered from 0, as draws are
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene_);
  eye_ = scene.eye;
  if (const RTCError error = rtcGetDeviceError(device_); error != RTC_ERROR_NONE)
    throw Error(scene.name, "Embree error " + std::to_string(error));
}

void EmbreePeer::trace_tile(const Rect& tile, Hits& hits) const {
  constexpr int columns = 4, rows = packet_width / columns;
  // Directions of depth 1, so that a ray's parameter is the distance along the viewing direction.
  const auto pixel = float(2 * std::tan(glm::radians(fov_deg) / 2) / picture_height);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (int y0 = tile.y_begin; y0 < tile.y_end; y0 += rows)
    for (int x0 = tile.x_begin; x0 < tile.x_end; x0 += columns) {
      Packet packet;
      alignas(64) int valid[packet_width];
      for (int i = 0; i < packet_width; ++i) {
        const int x = x0 + i % columns, y = y0 + i / columns;
        valid[i] = x < tile.x_end && y < tile.y_end ? -1 : 0;
        packet.ray.org_x[i] = float(eye_.x);
        packet.ray.org_y[i] = float(eye_.y);
        packet.ray.org_z[i] = float(eye_.z);
        packet.ray.dir_x[i] = (float(x) + .5f - .5f * float(picture_width)) * pixel;
        packet.ray.dir_y[i] = (.5f * float(picture_height) - float(y) - .5f) * pixel;
        packet.ray.dir_z[i] = -1;
        packet.ray.tnear[i] = float(near_distance);
        packet.ray.tfar[i] = float(far_distance);
        packet.ray.time[i] = 0;
        packet.ray.mask[i] = ~0u;
        packet.ray.flags[i] = 0;
        packet.hit.geomID[i] = packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
      }
      intersect(valid, scene_, context, packet);
      for (int i = 0; i < packet_width; ++i) {
        if (!valid[i]) continue;
        const auto at =
            std::size_t(y0 + i / columns) * picture_width + std::size_t(x0 + i % columns);
        hits.object[at] = packet.hit.geomID[i];
        hits.triangle[at] = packet.hit.primID[i];
        hits.distance[at] = packet.ray.tfar[i];
      }
    }
}

double EmbreePeer::trace(const Rect& rect, Hits& hits) const {
  const int columns = (rect.x_end - rect.x_begin + tile_size - 1) / tile_size;
  const int rows = (rect.y_end - rect.y_begin + tile_size - 1) / tile_size;
  tbb::combinable<double> busy_ms([] { return 0.0; });
  tbb::task_arena arena(threads_);
  arena.execute([&] {
    tbb::parallel_for(0, columns * rows, [&](int i) {
      const auto start = Clock::now();
      _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);  // as Embree asks for
      _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
      const int x = rect.x_begin + i % columns * tile_size,
                y = rect.y_begin + i / columns * tile_size;
      trace_tile({x, y, std::min(x + tile_size, rect.x_end), std::min(y + tile_size, rect.y_end)},
                 hits);
      busy_ms.local() += ms_since(start);
    });
  });
  return busy_ms.combine(std::plus<>());
}

std::string EmbreePeer::version() const {
  const auto number = rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_VERSION);
  const bool native =
      rtcGetDeviceProperty(device_, packet_width == 16 ? RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED
                                                       : RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED);
  return "Embree " + std::to_string(number / 10000) + "." + std::to_string(number / 100 % 100) +
         "." + std::to_string(number % 100) + ", " + std::to_string(packet_width) +
         " rays a packet" + (native ? ", native" : ", not native");
}

}  // namespace scanlit::bench

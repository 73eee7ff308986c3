// Runs the stages of pipeline.h, in parallel where the order of work cannot be seen in the picture.
#include "rasterizer/render.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <xmmintrin.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include "rasterizer/cluster_culling.h"
#include "rasterizer/error.h"
#include "rasterizer/stage_timer.h"
#include "rasterizer/tile.h"

namespace scanlit {

namespace {

using Clock = std::chrono::steady_clock;

/// Subnormal results become 0 for as long as it lives: the tails of sharp lobes are subnormal, and
/// cost many times a normal number's time.
class FlushSubnormals {
 public:
  FlushSubnormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040); }
  FlushSubnormals(const FlushSubnormals&) = delete;
  FlushSubnormals& operator=(const FlushSubnormals&) = delete;
  ~FlushSubnormals() { _mm_setcsr(saved_); }

 private:
  unsigned saved_;
};

void validate(const RenderSettings& settings) {
  const int s = settings.samples;
  if (s != 1 && s != 4 && s != 8 && s != 16)
    throw Error("samples must be 1, 4, 8 or 16, not " + std::to_string(s));
  if (settings.threads < 0 || settings.threads > 1024)
    throw Error("threads must be 0 (all cores) to 1024, not " + std::to_string(settings.threads));
}

Draw make_draw(const Object& object, const glm::dmat4& view_projection, std::uint32_t index,
               ClusterCache& clusters) {
  const glm::dmat4 world_from_object(object.world_from_object);
  const glm::dmat3 linear(world_from_object);
  const double determinant = glm::determinant(linear);
  // The cofactor matrix is the inverse transpose times the determinant, and exists where the
  // inverse does not. Scaled to about 1, so that no length of a normal leaves float's range.
  glm::dmat3 cofactor(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                      glm::cross(linear[0], linear[1]));
  double largest = 0;
  for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(cofactor[i / 3][i % 3]));
  if (largest > 0) cofactor *= (determinant < 0 ? -1 : 1) / largest;

  const bool both =
      object.sides == Sides::both || (object.sides == Sides::automatic && !object.mesh->closed);
  return {.object = &object,
          .mesh = object.mesh.get(),
          .clusters = clusters.of(object.mesh),
          .index = index,
          .clip_from_object = glm::mat4(view_projection * world_from_object),
          .normal_from_object = glm::mat3(cofactor),
          .draw_back_faces = both,
          .mirrored = determinant < 0};
}

/// Runs work(i) for each i below count, in parallel.
template <class Work>
void parallel(std::size_t count, const Work& work) {
  tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
    const FlushSubnormals flush;
    work(i);
  });
}

using Workers = tbb::enumerable_thread_specific<Worker>;

void add(const FrameStats& part, FrameStats& sum) {
  for (const auto member :
       {&FrameStats::vertices, &FrameStats::objects_outside, &FrameStats::clusters,
        &FrameStats::clusters_outside, &FrameStats::clusters_back_facing, &FrameStats::triangles,
        &FrameStats::outside, &FrameStats::back_facing, &FrameStats::no_pixel, &FrameStats::drawn,
        &FrameStats::clipped, &FrameStats::hidden, &FrameStats::fragments,
        &FrameStats::covered_pixels, &FrameStats::evaluations, &FrameStats::evaluations_skipped,
        &FrameStats::spans})
    sum.*member += part.*member;
  for (std::size_t i = 0; i < sum.seconds.size(); ++i) sum.seconds[i] += part.seconds[i];
}

}  // namespace

/// What is kept from frame to frame: memory, and the clusters of the meshes.
struct Renderer::State {
  ClusterCache clusters;
  Workers workers;
  std::vector<Draw> draws;
  std::vector<Chunk> chunks;
  std::unique_ptr<tbb::task_arena> arena;
  std::unique_ptr<tbb::global_control> limit;
  int threads = 0;

  /// More threads than cores are made only on demand.
  void use_threads(int count) {
    if (count == threads) return;
    threads = count;
    const int cores = tbb::info::default_concurrency();
    limit.reset();
    if (count > cores)
      limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    std::size_t(count));
    arena = std::make_unique<tbb::task_arena>(count);
  }

  void make_draws(Frame& frame, FrameStats& stats);
  FrameStats run_stages(Frame& frame, Framebuffer& framebuffer);
};

/// Fills draws and chunks; objects outside of the view have none.
void Renderer::State::make_draws(Frame& frame, FrameStats& stats) {
  constexpr std::uint32_t clusters_in_chunk = 64;
  const Viewport& viewport = frame.viewport;
  const glm::dmat4 view_projection =
      clip_from_world(frame.camera, double(viewport.width) / viewport.height);
  frame.draws.clear();
  for (const Object& object : frame.scene.objects)
    frame.draws.push_back(
        make_draw(object, view_projection, std::uint32_t(frame.draws.size()), clusters));
  for (Draw& draw : frame.draws) draw.illumination = illuminate(frame, draw);
  std::uint32_t count = 0;
  for (const Draw& draw : frame.draws) {
    const MeshClusters& all = *draw.clusters;
    if (frame.settings.skips.outside_objects &&
        ClusterCuller(draw, viewport).view(all.bounds) == ClusterView::outside) {
      ++stats.objects_outside;
      stats.triangles += std::int64_t(all.triangles.size());
      stats.outside += std::int64_t(all.triangles.size());
      continue;
    }
    const auto end = std::uint32_t(all.clusters.size());
    for (std::uint32_t first = 0; first < end; first += clusters_in_chunk, ++count) {
      if (count == frame.chunks.size()) frame.chunks.emplace_back();
      Chunk& chunk = frame.chunks[count];
      chunk.draw = &draw;
      chunk.index = count;
      chunk.first_cluster = first;
      chunk.end_cluster = std::min(first + clusters_in_chunk, end);
    }
  }
  frame.chunks.resize(count);
}

FrameStats Renderer::State::run_stages(Frame& frame, Framebuffer& framebuffer) {
  FrameStats total;
  for (Worker& worker : workers) worker.shader.stats = {};
  make_draws(frame, total);                           // (2)
  parallel(frame.chunks.size(), [&](std::size_t i) {  // (3) to (6), (9) at faces and vertices
    assemble(frame, frame.chunks[i], workers.local().shader.stats);
  });
  std::mutex progress_mutex;
  int finished = 0;
  parallel(std::size_t(frame.grid.count()), [&](std::size_t tile) {  // (7) to (10)
    draw_tile(frame, int(tile), workers.local(), framebuffer);
    if (!frame.settings.progress) return;
    const std::lock_guard lock(progress_mutex);
    frame.settings.progress(double(++finished) / frame.grid.count());
  });
  for (const Chunk& chunk : frame.chunks) add(chunk.counts, total);
  for (const Worker& worker : workers) add(worker.shader.stats, total);
  return total;
}

const char* name(Stage stage) {
  static constexpr const char* names[] = {"assembly", "light sites", "scan conversion", "resolve",
                                          "shading"};
  return names[std::size_t(stage)];
}

std::span<const SkipSwitch> skip_switches() {
  static constexpr SkipSwitch switches[] = {{"outside-objects", &Skips::outside_objects},
                                            {"outside-clusters", &Skips::outside_clusters},
                                            {"back-facing-clusters", &Skips::back_facing_clusters},
                                            {"unseen-triangles", &Skips::unseen_triangles},
                                            {"clip-tests", &Skips::clip_tests},
                                            {"hidden-triangles", &Skips::hidden_triangles},
                                            {"hidden-fragments", &Skips::hidden_fragments},
                                            {"empty-pixels", &Skips::empty_pixels},
                                            {"dark-lights", &Skips::dark_lights},
                                            {"far-directions", &Skips::far_directions},
                                            {"unused-attributes", &Skips::unused_attributes}};
  return switches;
}

Renderer::Renderer() : state_(std::make_unique<State>()) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

FrameStats render(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                  Framebuffer& framebuffer) {
  return Renderer().render(scene, camera, settings, framebuffer);
}

FrameStats Renderer::render(const Scene& scene, const Camera& camera,
                            const RenderSettings& settings, Framebuffer& framebuffer) {
  const auto start = Clock::now();
  validate(scene);
  validate(camera);
  validate(settings);
  validate_size(framebuffer.width, framebuffer.height);
  const Viewport viewport{framebuffer.width, framebuffer.height};

  State& state = *state_;
  Frame frame{.scene = scene,
              .camera = camera,
              .settings = settings,
              .viewport = viewport,
              .grid = make_tile_grid(viewport, settings.samples),
              .draws = std::move(state.draws),
              .chunks = std::move(state.chunks),
              .with_parts = !framebuffer.ambient.empty()};
  const int threads = settings.threads > 0 ? settings.threads : tbb::info::default_concurrency();
  state.use_threads(threads);
  FrameStats stats;
  state.arena->execute([&] { stats = state.run_stages(frame, framebuffer); });
  state.draws = std::move(frame.draws);
  state.chunks = std::move(frame.chunks);
  stats.threads = threads;
  stats.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return stats;
}

}  // namespace scanlit

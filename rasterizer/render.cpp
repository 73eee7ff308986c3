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

std::vector<Draw> make_draws(const Scene& scene, const Camera& camera, double aspect) {
  const glm::dmat4 view_projection = clip_from_world(camera, aspect);
  std::vector<Draw> draws;
  std::uint32_t first_vertex = 0, first_triangle = 0;
  for (const Object& object : scene.objects) {
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
    draws.push_back({.object = &object,
                     .mesh = object.mesh.get(),
                     .index = std::uint32_t(draws.size()),
                     .first_vertex = first_vertex,
                     .first_triangle = first_triangle,
                     .clip_from_object = glm::mat4(view_projection * world_from_object),
                     .normal_from_object = glm::mat3(cofactor),
                     .draw_back_faces = both,
                     .mirrored = determinant < 0});
    first_vertex += std::uint32_t(object.mesh->positions.size());
    first_triangle += std::uint32_t(object.mesh->triangle_count());
  }
  return draws;
}

/// Runs work(begin, end) over [0, count) in pieces of at most `grain`, in parallel.
template <class Work>
void parallel_pieces(std::size_t count, std::size_t grain, const Work& work) {
  const std::size_t pieces = (count + grain - 1) / grain;
  tbb::parallel_for(std::size_t(0), pieces, [&](std::size_t i) {
    const FlushSubnormals flush;
    work(i * grain, std::min(count, (i + 1) * grain));
  });
}

using Workers = tbb::enumerable_thread_specific<Worker>;

void transform_all(Frame& frame, Workers& workers) {
  const std::size_t grain = 4096;
  for (const Draw& draw : frame.draws)
    parallel_pieces(draw.mesh->positions.size(), grain, [&](std::size_t begin, std::size_t end) {
      const StageTimer timer(workers.local().shader.stats, Stage::vertices);
      transform_vertices(draw, begin, end, frame);
    });
}

void assemble_all(Frame& frame, std::uint32_t triangle_count, Workers& workers) {
  const std::uint32_t grain = 16384;
  frame.chunks.resize((triangle_count + grain - 1) / grain);
  parallel_pieces(triangle_count, grain, [&](std::size_t begin, std::size_t end) {
    const StageTimer timer(workers.local().shader.stats, Stage::assembly);
    assemble(std::uint32_t(begin), std::uint32_t(end), frame, frame.chunks[begin / grain]);
  });
  for (Chunk& chunk : frame.chunks) {
    chunk.first_piece = std::uint32_t(frame.pieces.size());
    frame.pieces.insert(frame.pieces.end(), chunk.pieces.begin(), chunk.pieces.end());
  }
}

void light_all_sites(Frame& frame, Workers& workers) {
  const std::size_t grain = 4096;
  for (const Draw& draw : frame.draws) {
    LitSites& sites = frame.lit_sites[draw.index];
    parallel_pieces(sites.needed.size(), grain, [&](std::size_t begin, std::size_t end) {
      FrameStats& stats = workers.local().shader.stats;
      const StageTimer timer(stats, Stage::light_vertices);
      light_sites(frame, draw, begin, end, sites, stats);
    });
  }
}

void draw_all_tiles(const Frame& frame, Workers& workers, Framebuffer& framebuffer) {
  std::mutex progress_mutex;
  int finished = 0;
  parallel_pieces(std::size_t(frame.grid.count()), 1, [&](std::size_t tile, std::size_t) {
    draw_tile(frame, int(tile), workers.local(), framebuffer);
    if (!frame.settings.progress) return;
    const std::lock_guard lock(progress_mutex);
    frame.settings.progress(double(++finished) / frame.grid.count());
  });
}

void add(const FrameStats& part, FrameStats& sum) {
  for (const auto member :
       {&FrameStats::triangles, &FrameStats::outside, &FrameStats::back_facing,
        &FrameStats::no_pixel, &FrameStats::drawn, &FrameStats::clipped, &FrameStats::fragments,
        &FrameStats::covered_pixels, &FrameStats::evaluations, &FrameStats::evaluations_skipped,
        &FrameStats::spans})
    sum.*member += part.*member;
  for (std::size_t i = 0; i < sum.seconds.size(); ++i) sum.seconds[i] += part.seconds[i];
}

FrameStats run_stages(Frame& frame, Framebuffer& framebuffer) {
  Workers workers;
  FrameStats total;
  std::size_t vertex_count = 0, triangle_count = 0;
  const bool parts = !framebuffer.ambient.empty();
  for (Draw& draw : frame.draws) {
    draw.illumination = illuminate(frame, draw);
    vertex_count += draw.mesh->positions.size();
    triangle_count += draw.mesh->triangle_count();
    frame.lit_sites.push_back(make_sites(draw, parts));
  }
  frame.screen_vertices.resize(vertex_count);
  frame.outcodes.resize(vertex_count);

  transform_all(frame, workers);                                // (3), (5)
  assemble_all(frame, std::uint32_t(triangle_count), workers);  // (4), (5), (6)
  light_all_sites(frame, workers);                              // (9) at faces and vertices
  draw_all_tiles(frame, workers, framebuffer);                  // (7), (8), (9), (10)

  total.vertices = std::int64_t(vertex_count);
  for (const Chunk& chunk : frame.chunks) add(chunk.counts, total);
  for (const Worker& worker : workers) add(worker.shader.stats, total);
  return total;
}

}  // namespace

const char* name(Stage stage) {
  static constexpr const char* names[] = {"vertices",        "assembly", "light sites",
                                          "scan conversion", "resolve",  "shading"};
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

struct Renderer::State {};

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

  Frame frame{.scene = scene,
              .camera = camera,
              .settings = settings,
              .viewport = viewport,
              .grid = make_tile_grid(viewport, settings.samples),
              .draws = make_draws(scene, camera, double(viewport.width) / viewport.height),
              .screen_vertices = {},
              .outcodes = {},
              .chunks = {},
              .pieces = {},
              .lit_sites = {}};
  const int threads = settings.threads > 0 ? settings.threads : tbb::info::default_concurrency();
  // More threads than cores are made only on demand.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  std::size_t(std::max(threads, tbb::info::default_concurrency())));
  tbb::task_arena arena(threads);
  FrameStats stats;
  arena.execute([&] { stats = run_stages(frame, framebuffer); });
  stats.threads = threads;
  stats.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return stats;
}

}  // namespace scanlit

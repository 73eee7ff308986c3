// Runs the stages of pipeline.h, in parallel where the order of work cannot be seen in the picture.
#include "rasterizer/render.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <mutex>
#include <numeric>

#include "rasterizer/cluster_culling.h"
#include "rasterizer/draw.h"
#include "rasterizer/error.h"
#include "rasterizer/lighting.h"
#include "rasterizer/occlusion.h"
#include "rasterizer/parallel.h"
#include "rasterizer/reuse.h"
#include "rasterizer/stage_timer.h"
#include "rasterizer/stages.h"
#include "rasterizer/tile.h"

namespace scanlit {

namespace {

using Clock = std::chrono::steady_clock;

void validate(const RenderSettings& settings) {
  const int s = settings.samples;
  if (s != 1 && s != 4 && s != 8 && s != 16)
    throw Error("samples must be 1, 4, 8 or 16, not " + std::to_string(s));
  if (settings.threads < 0 || settings.threads > 1024)
    throw Error("threads must be 0 (all cores) to 1024, not " + std::to_string(settings.threads));
  if (!(settings.tolerance >= 0 && settings.tolerance <= 255))
    throw Error("tolerance must be 0 to 255, not " + std::to_string(settings.tolerance));
}

void add(const FrameStats& part, FrameStats& sum) {
  for (const auto member :
       {&FrameStats::vertices, &FrameStats::clusters, &FrameStats::clusters_outside,
        &FrameStats::clusters_back_facing, &FrameStats::clusters_hidden, &FrameStats::triangles,
        &FrameStats::outside, &FrameStats::behind, &FrameStats::back_facing, &FrameStats::no_pixel,
        &FrameStats::drawn, &FrameStats::clipped, &FrameStats::hidden, &FrameStats::fragments,
        &FrameStats::covered_pixels, &FrameStats::evaluations, &FrameStats::evaluations_skipped,
        &FrameStats::spans})
    sum.*member += part.*member;
  for (std::size_t i = 0; i < sum.seconds.size(); ++i) sum.seconds[i] += part.seconds[i];
}

}  // namespace

/// What is kept from frame to frame: memory, the clusters of meshes, and with `reuse` results.
struct Renderer::State {
  ClusterCache clusters;
  Workers workers;
  std::vector<Draw> draws;
  std::vector<Chunk> chunks;  // of all objects' clusters, in order
  LastFrame last;
  std::vector<VisibilityTile> kept_tiles;  // only with `reuse`
  Occlusion occlusion;
  std::unique_ptr<tbb::task_arena> arena;
  std::unique_ptr<tbb::global_control> limit;
  int threads = 0;

  void use_threads(int count);
  FrameStats run_stages(Frame& frame, const Changes& changes, Framebuffer& framebuffer);
  void make_draws(Frame& frame, const Changes& changes);
  void assemble_all(Frame& frame, const Changes& changes);
  std::vector<Redo> find_tiles(const Frame& frame, const Changes& changes) const;
};

/// More threads than cores are made only on demand.
void Renderer::State::use_threads(int count) {
  if (count == threads) return;
  threads = count;
  limit.reset();
  if (count > tbb::info::default_concurrency())
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  std::size_t(count));
  arena = std::make_unique<tbb::task_arena>(count);
}

constexpr std::uint32_t most_clusters_in_chunk = 64;
static_assert(2 * ClusterVertices::capacity * most_clusters_in_chunk <= 1 << 16,
              "LitSites::corners holds the sites of a chunk's vertices, of either side");

/// Measured on a million triangles: chunks of 8 take 8 % longer a frame than chunks of 64, which
/// take 50 microseconds to assemble. Of few clusters they are smaller all the same, for up to eight
/// threads to have some; not by how many there are, for strides are decided chunk by chunk.
std::uint32_t clusters_in_chunk(const std::vector<Draw>& draws) {
  std::size_t count = 0;
  for (const Draw& draw : draws) count += draw.clusters->clusters.size();
  return std::clamp(std::uint32_t(count / 8), 8u, most_clusters_in_chunk);
}

/// Also cuts all their clusters into chunks.
void Renderer::State::make_draws(Frame& frame, const Changes& changes) {
  const Viewport& viewport = frame.viewport;
  const glm::dmat4 view_projection =
      clip_from_world(frame.camera, double(viewport.width) / viewport.height);
  frame.draws.clear();
  for (const Object& object : frame.scene.objects) {
    const auto index = std::uint32_t(frame.draws.size());
    frame.draws.push_back(make_draw(object, index, view_projection, clusters));
  }
  const std::uint32_t chunk_size = clusters_in_chunk(frame.draws);
  std::uint32_t count = 0;
  for (Draw& draw : frame.draws) {
    const MeshClusters& all = *draw.clusters;
    draw.outside = frame.settings.skips.outside_objects &&
                   ClusterCuller(draw, viewport).view(all.bounds) == ClusterView::outside;
    if (!draw.outside) draw.illumination = illuminate(frame, draw);
    const auto end = std::uint32_t(all.clusters.size());
    for (std::uint32_t first = 0; first < end; first += chunk_size, ++count) {
      if (count == frame.chunks.size()) frame.chunks.emplace_back();
      Chunk& chunk = frame.chunks[count];
      chunk.draw = &draw;
      chunk.index = count;
      chunk.first_cluster = first;
      chunk.end_cluster = std::min(first + chunk_size, end);
    }
  }
  if (changes.everything) frame.chunks.resize(count);
}

/// (3) to (6), and (9) at faces and vertices, of what changed and is not there already.
void Renderer::State::assemble_all(Frame& frame, const Changes& changes) {
  parallel(frame.chunks.size(), [&](std::size_t i) {
    Chunk& chunk = frame.chunks[i];
    FrameStats& stats = workers.local().shader.stats;
    if (chunk.draw->occluder) return;
    if (changes.object(chunk.draw->index)) {
      assemble(frame, chunk, stats);
    } else {
      chunk.counts = {};
      if (changes.lighting) light_chunk(frame, chunk, stats);
    }
  });
}

/// What must be done in each tile. Asked before assembly, it knows where changed objects were, and
/// after it, where they are.
std::vector<Redo> Renderer::State::find_tiles(const Frame& frame, const Changes& changes) const {
  const Redo least = changes.everything ? Redo::all
                     : changes.lighting ? Redo::shading
                                        : Redo::nothing;
  std::vector<Redo> tiles(std::size_t(frame.grid.count()), least);
  if (changes.everything) return tiles;
  for (const Chunk& chunk : frame.chunks)
    for (std::size_t i = 0; i < chunk.bins.size() && changes.object(chunk.draw->index); ++i)
      if (chunk.bins[i].begin != chunk.bins[i].end)
        tiles[std::size_t(chunk.first_tile) + i] = Redo::all;
  return tiles;
}

/// The tiles in the order to draw them. One that is full takes a twentieth of a frame's time or
/// more: drawn last, all threads but one would wait for it. Among tiles that are nearly alike the
/// order stays, for neighbours have clusters in common.
std::vector<int> largest_first(const Frame& frame) {
  std::vector<std::uint64_t> pixels(std::size_t(frame.grid.count()));  // of boxes, chunk by chunk
  for (const Chunk& chunk : frame.chunks)
    for (std::size_t i = 0; i < chunk.bins.size(); ++i)
      if (const Bin& bin = chunk.bins[i]; bin.begin != bin.end)
        pixels[std::size_t(chunk.first_tile) + i] += std::uint64_t(area(bin.touched));
  std::vector<int> order(pixels.size());
  std::iota(order.begin(), order.end(), 0);
  const auto size = [&](int tile) { return std::bit_width(pixels[std::size_t(tile)]); };
  std::ranges::stable_sort(order, std::ranges::greater(), size);
  return order;
}

FrameStats Renderer::State::run_stages(Frame& frame, const Changes& changes,
                                       Framebuffer& framebuffer) {
  for (Worker& worker : workers) worker.shader.stats = {};
  make_draws(frame, changes);
  std::vector<Redo> tiles = find_tiles(frame, changes);
  // With `reuse`, what stands from the last frame may be seen in this one.
  if (frame.settings.skips.hidden_clusters && !frame.settings.reuse)
    find_hidden(frame, workers, occlusion);
  assemble_all(frame, changes);
  if (frame.settings.tolerance > 0) try_all_strides(frame);
  const std::vector<Redo> tiles_now = find_tiles(frame, changes);
  for (std::size_t i = 0; i < tiles.size(); ++i) tiles[i] = std::max(tiles[i], tiles_now[i]);

  const bool keep = frame.settings.reuse;
  if (keep) kept_tiles.resize(tiles.size());
  std::mutex progress_mutex;
  std::size_t finished = 0;
  const std::vector<int> order = largest_first(frame);
  parallel(order.size(), [&](std::size_t turn) {  // (7) to (10)
    const auto i = std::size_t(order[turn]);
    Worker& worker = workers.local();
    VisibilityTile& visibility = keep ? kept_tiles[i] : worker.visibility;
    if (tiles[i] != Redo::nothing)
      draw_tile(frame, int(i), tiles[i], worker, visibility, framebuffer);
    if (!frame.settings.progress) return;
    const std::lock_guard lock(progress_mutex);
    frame.settings.progress(double(++finished) / double(tiles.size()));
  });

  FrameStats total;
  total.tiles_kept = std::ranges::count(tiles, Redo::nothing);
  for (const Draw& draw : frame.draws)
    total.objects_outside += draw.outside, total.objects_hidden += draw.hidden;
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
                                            {"hidden-clusters", &Skips::hidden_clusters},
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
  const std::uint64_t start_tick = StageTimer::now();
  validate(scene);
  validate(camera);
  validate(settings);
  validate_size(framebuffer.width, framebuffer.height);
  const Viewport viewport{framebuffer.width, framebuffer.height};

  State& state = *state_;
  const Changes changes =
      settings.reuse ? state.last.until(scene, camera, settings, framebuffer) : Changes();
  state.last.forget();  // unless this frame ends as it should
  framebuffer.frame = 0;
  const auto timed = [&](FrameStats stats) {  // StageTimer left ticks in it
    stats.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const double seconds_per_tick = stats.wall_seconds / double(StageTimer::now() - start_tick);
    for (double& stage : stats.seconds) stage *= seconds_per_tick;
    return stats;
  };
  if (settings.stages) return timed(render_staged(scene, camera, settings, framebuffer));
  Frame frame{.scene = scene,
              .camera = camera,
              .settings = settings,
              .viewport = viewport,
              .grid = make_tile_grid(viewport, settings.samples),
              .draws = std::move(state.draws),
              .chunks = std::move(state.chunks),
              .with_parts = !framebuffer.ambient.empty(),
              .format = framebuffer.format,
              .colour_alone = framebuffer.ambient.empty() && framebuffer.normal.empty() &&
                              framebuffer.cost.empty()};
  const int threads = settings.threads > 0 ? settings.threads : tbb::info::default_concurrency();
  state.use_threads(threads);
  // Threads that sleep are woken while the draws are made: they take as long to wake as a tile.
  if (threads > 1) state.arena->enqueue([] {});
  FrameStats stats;
  state.arena->execute([&] { stats = state.run_stages(frame, changes, framebuffer); });
  state.draws = std::move(frame.draws);
  state.chunks = std::move(frame.chunks);
  static std::atomic<std::uint64_t> frames{0};
  framebuffer.frame = ++frames;
  if (settings.reuse) state.last.keep(scene, camera, settings, framebuffer);
  stats.threads = threads;
  return timed(stats);
}

}  // namespace scanlit

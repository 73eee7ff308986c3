// The picture is the same to the bit whatever its making depends on and should not.
#include <algorithm>
#include <cstring>
#include <numeric>

#include "rasterizer/draw.h"
#include "rasterizer/lighting.h"
#include "rasterizer/tile.h"
#include "tests/stress/random_scene.h"

namespace scanlit::stress {
namespace {

template <class T>
std::int64_t bytes_that_differ(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return 1;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += std::memcmp(&a[i], &b[i], sizeof(T)) != 0;
  return count;
}

std::int64_t differences(const Framebuffer& a, const Framebuffer& b) {
  return bytes_that_differ(a.colour, b.colour) + bytes_that_differ(a.depth, b.depth) +
         bytes_that_differ(a.normal, b.normal) + bytes_that_differ(a.object_id, b.object_id) +
         bytes_that_differ(a.triangle_id, b.triangle_id) + bytes_that_differ(a.ambient, b.ambient) +
         bytes_that_differ(a.diffuse, b.diffuse) + bytes_that_differ(a.glossy, b.glossy);
}

TEST(Identity, ThreadsAndRepetition) {
  Property property{"the picture is the same to the bit on any number of threads, run after run",
                    "random scenes; 1, 2, 3, 8 and 16 threads, a Renderer of its own and one used "
                    "before, with reuse and without",
                    "numbers differ", 60};
  Renderer used;
  while (property.next()) {
    RandomScene all = random_scene(property);
    all.settings.threads = 1;
    const Framebuffer one = draw(all);
    for (const int threads : {2, 3, 8, 16}) {
      all.settings.threads = threads;
      property.measure(double(differences(one, draw(all))), threads, " threads");
    }
    Framebuffer again(all.width, all.height, one.planes());
    for (const bool reuse : {false, true, true}) {
      all.settings.reuse = reuse;
      used.render(all.scene, all.camera, all.settings, again);
      property.measure(double(differences(one, again)), "used before, reuse ", reuse);
    }
    EXPECT_EQ(property.worst(), 0);
  }
}

/// As Renderer::render(), on this thread, with tiles of any size.
Framebuffer draw_in_tiles(const RandomScene& all, int width_shift, int height_shift) {
  Framebuffer framebuffer(all.width, all.height, all.planes);
  const Viewport viewport{all.width, all.height};
  TileGrid grid{width_shift, height_shift, 0, 0, viewport};
  grid.columns = grid.column(all.width - 1) + 1;
  grid.rows = grid.row(all.height - 1) + 1;
  Frame frame{.scene = all.scene,
              .camera = all.camera,
              .settings = all.settings,
              .viewport = viewport,
              .grid = grid,
              .draws = {},
              .chunks = {},
              .with_parts = all.planes.parts,
              .colour_alone = !all.planes.parts};
  ClusterCache clusters;
  const glm::dmat4 view = clip_from_world(all.camera, double(all.width) / all.height);
  for (const Object& object : all.scene.objects)
    frame.draws.push_back(make_draw(object, std::uint32_t(frame.draws.size()), view, clusters));
  FrameStats stats;
  frame.chunks.resize(frame.draws.size());
  for (Draw& d : frame.draws) {
    d.illumination = illuminate(frame, d);
    Chunk& chunk = frame.chunks[d.index];
    chunk.draw = &d, chunk.index = d.index;
    chunk.end_cluster = std::uint32_t(d.clusters->clusters.size());
    assemble(frame, chunk, stats);
  }
  Worker worker;
  for (int tile = 0; tile < grid.count(); ++tile)
    draw_tile(frame, tile, Redo::all, worker, worker.visibility, framebuffer);
  return framebuffer;
}

TEST(Identity, Tiles) {
  Property property{"the picture is the same to the bit however it is cut into tiles",
                    "random scenes, 1 to 16 samples a pixel; tiles of 4 x 1 to 1024 x 64 pixels",
                    "numbers differ", 60};
  while (property.next()) {
    const RandomScene all = random_scene(property);
    const int width_shift = property.whole(2, 10), height_shift = property.whole(0, 6);
    // Not in draw(): what Renderer flushes to zero this thread does not.
    const Framebuffer whole = draw_in_tiles(all, 8, 6);
    property.measure(double(differences(whole, draw_in_tiles(all, width_shift, height_shift))),
                     "tiles of ", 1 << width_shift, " x ", 1 << height_shift);
    EXPECT_EQ(property.worst(), 0);
  }
}

std::vector<std::uint32_t> shuffled(std::size_t size, Property& property) {
  std::vector<std::uint32_t> order(size);
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), property.random());
  return order;
}

TEST(Identity, OrderOfObjectsAndTriangles) {
  Property property{
      "the order of objects and of triangles changes nothing but which of two stays "
      "at equal depth",
      "random scenes, one sample a pixel; each pixel that sees the same triangle has "
      "the same bits, any other the same depth",
      "pixels differ", 80};
  while (property.next()) {
    RandomScene all = random_scene(property), other = all;
    all.settings.samples = other.settings.samples = 1;
    const std::vector<std::uint32_t> objects = shuffled(all.scene.objects.size(), property);
    std::vector<std::vector<std::uint32_t>> triangles;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      Object& object = other.scene.objects[i] = all.scene.objects[objects[i]];
      auto mesh = std::make_shared<Mesh>(*object.mesh);
      triangles.push_back(shuffled(mesh->triangle_count(), property));
      for (std::size_t t = 0; t < mesh->indices.size(); ++t)
        mesh->indices[t] = object.mesh->indices[3 * triangles[i][t / 3] + t % 3];
      object.mesh = mesh;
    }
    const Framebuffer a = draw(all), b = draw(other);
    std::int64_t differ = 0;
    for (std::size_t i = 0; i < a.pixel_count(); ++i) {
      const bool covered = b.object_id[i] != no_id;
      const bool same = covered
                            ? a.object_id[i] == objects[b.object_id[i]] &&
                                  a.triangle_id[i] == triangles[b.object_id[i]][b.triangle_id[i]]
                            : a.object_id[i] == no_id;
      bool fine = a.depth[i] == b.depth[i];
      if (same)
        fine &= !std::memcmp(&a.colour[4 * i], &b.colour[4 * i], 16) &&
                (a.normal.empty() || !std::memcmp(&a.normal[3 * i], &b.normal[3 * i], 12));
      differ += !fine;
    }
    property.checked(std::int64_t(a.pixel_count()));
    property.measure(double(differ), all.width, " x ", all.height);
    EXPECT_EQ(property.worst(), 0);
  }
}

}  // namespace
}  // namespace scanlit::stress

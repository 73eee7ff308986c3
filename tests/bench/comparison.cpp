#include "comparison.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>
#include <vector>

#include "rasterizer/error.h"

namespace scanlit::bench {

namespace {

using Clock = std::chrono::steady_clock;

double cpu_seconds() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// One renderer's frames.
struct Times {
  std::vector<double> wall_ms, cpu_ms;

  template <class Draw>
  void measure(const Draw& draw) {
    // So that the other renderer's worker threads, which look for work a while longer, are asleep.
    std::this_thread::sleep_for(std::chrono::microseconds(500));
    const double cpu = cpu_seconds();
    const auto start = Clock::now();
    draw();
    wall_ms.push_back(1e3 * std::chrono::duration<double>(Clock::now() - start).count());
    cpu_ms.push_back(1e3 * (cpu_seconds() - cpu));
  }

  FrameTime summary() const {
    return {median(wall_ms), *std::ranges::min_element(wall_ms), median(cpu_ms)};
  }
};

struct StageTimes {
  std::map<std::string, std::vector<double>> ms;

  void add(const ScanlitSide& scanlit, int threads) {
    const FrameStats& stats = scanlit.stats();
    double other = stats.wall_seconds * threads;
    for (int s = 0; s < int(Stage::count); ++s) {
      ms[name(Stage(s))].push_back(1e3 * stats.seconds[std::size_t(s)]);
      other -= stats.seconds[std::size_t(s)];
    }
    ms["other"].push_back(1e3 * other);
    ms["to rgba8"].push_back(1e3 * threads * scanlit.conversion_seconds());
  }
};

PictureDifference compare_frame(const BenchScene& scene, int frame, ScanlitSide& scanlit,
                                OsmesaPeer& peer) {
  scanlit.draw(scene, frame);
  peer.draw(scene, frame, Target::buffer);
  const PictureDifference difference = compare(scanlit.picture(), peer.picture());
  const Picture direct = peer.picture();
  peer.draw(scene, frame, Target::framebuffer_object);
  // Ties of the fill rule lie on the other side there: the picture's rows run upwards.
  if (!compare(direct, peer.upside_down()).same())
    throw Error(scene.name, "llvmpipe draws another picture into a framebuffer object");
  return difference;
}

}  // namespace

SceneResult compare_scene(const BenchScene& scene, int threads, const Effort& effort,
                          ScanlitSide& scanlit, OsmesaPeer& peer) {
  scanlit.prepare(scene);
  peer.prepare(scene);
  PictureDifference difference;
  for (int frame = 0; frame < 2; ++frame)
    difference.take_worse(compare_frame(scene, frame, scanlit, peer));

  Times scanlit_times, buffer_times, object_times;
  StageTimes stages;
  const auto measure = [&](int renderer, int frame) {
    if (renderer == 0) {
      scanlit_times.measure([&] { scanlit.draw(scene, frame); });
      stages.add(scanlit, threads);
    } else if (renderer == 1) {
      buffer_times.measure([&] { peer.draw(scene, frame, Target::buffer); });
    } else {
      object_times.measure([&] { peer.draw(scene, frame, Target::framebuffer_object); });
    }
  };
  const auto start = Clock::now();
  int frames = 0;
  const auto goes_on = [&] {
    const bool in_time = Clock::now() - start < std::chrono::duration<double>(effort.seconds);
    return frames < effort.min_frames || (frames < effort.max_frames && in_time);
  };
  // None of the three always comes first.
  for (; goes_on(); ++frames)
    for (int turn = 0; turn < 3; ++turn) measure((turn + frames) % 3, 2 + frames);

  difference.take_worse(compare_frame(scene, 2 + frames, scanlit, peer));
  SceneResult result{.scene = scene.name,
                     .peer = OsmesaPeer::version(),
                     .threads = threads,
                     .frames = frames,
                     .scanlit = scanlit_times.summary(),
                     .buffer = buffer_times.summary(),
                     .framebuffer_object = object_times.summary(),
                     .max_difference = double(difference.max),
                     .mean_difference = difference.mean,
                     .covered = {difference.covered[0], difference.covered[1]},
                     .same = difference.same(),
                     .difference = difference.words(),
                     .stages = {}};
  for (const auto& [stage, ms] : stages.ms) result.stages[stage] = median(ms);
  return result;
}

// -------------------------------------------------------------------------------------------------

namespace {

nlohmann::json as_json(const FrameTime& time) {
  return {{"median", time.median_ms}, {"min", time.min_ms}, {"cpu", time.cpu_ms}};
}

FrameTime frame_time(const nlohmann::json& json) {
  return {json.at("median"), json.at("min"), json.at("cpu")};
}

}  // namespace

void to_json(nlohmann::json& json, const SceneResult& r) {
  const auto if_same = [&](double ratio) { return r.same ? nlohmann::json(ratio) : nullptr; };
  json = {{"scene", r.scene},
          {"threads", r.threads},
          {"scanlit_ms", r.scanlit.median_ms},
          {"peer_ms", r.buffer.median_ms},
          {"ratio", if_same(r.ratio())},
          {"max_difference", r.max_difference},
          {"mean_difference", r.mean_difference},
          {"peer", r.peer},
          {"frames", r.frames},
          {"min_ratio", if_same(r.min_ratio())},
          {"cpu_ratio", if_same(r.cpu_ratio())},
          {"same_picture", r.same},
          {"difference", r.difference},
          {"covered", r.covered},
          {"scanlit", as_json(r.scanlit)},
          {"llvmpipe_buffer", as_json(r.buffer)},
          {"llvmpipe_framebuffer_object", as_json(r.framebuffer_object)},
          {"scanlit_stages_ms", r.stages}};
}

void from_json(const nlohmann::json& json, SceneResult& r) {
  r.scene = json.at("scene");
  r.peer = json.at("peer");
  r.threads = json.at("threads");
  r.frames = json.at("frames");
  r.scanlit = frame_time(json.at("scanlit"));
  r.buffer = frame_time(json.at("llvmpipe_buffer"));
  r.framebuffer_object = frame_time(json.at("llvmpipe_framebuffer_object"));
  r.max_difference = json.at("max_difference");
  r.mean_difference = json.at("mean_difference");
  json.at("covered").at(0).get_to(r.covered[0]);
  json.at("covered").at(1).get_to(r.covered[1]);
  r.same = json.at("same_picture");
  r.difference = json.at("difference");
  json.at("scanlit_stages_ms").get_to(r.stages);
}

}  // namespace scanlit::bench

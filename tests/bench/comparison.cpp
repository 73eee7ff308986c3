#include "comparison.h"

#include <cstring>
#include <functional>
#include <vector>

#include "rasterizer/error.h"

namespace scanlit::bench {

namespace {

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
  }
};

/// One of those who draw the same frame in turn.
struct Contender {
  std::function<void(int frame)> draw;
  std::function<void()> afterwards = [] {};  // not timed
  Times times{};
};

}  // namespace

PictureDifference Comparison::compare_frame(const BenchScene& scene, int frame) {
  scanlit_.draw(scene, frame);
  peer_.draw(scene, frame, Target::buffer);
  const PictureDifference difference = compare(scanlit_.picture(), peer_.picture());
  const Picture direct = peer_.picture();
  peer_.draw(scene, frame, Target::framebuffer_object);
  // Ties of the fill rule lie on the other side there: the picture's rows run upwards.
  if (!compare(direct, peer_.upside_down()).same())
    throw Error(scene.name, "llvmpipe draws another picture into a framebuffer object");
  return difference;
}

/// Whether the picture that was drawn with reuse, frame by frame, is another.
bool Comparison::reuse_shows(const BenchScene& scene) {
  bool differs = false;
  for (int frame = 0; frame < 5; ++frame) {
    scanlit_.draw(scene, frame);
    without_reuse_.draw(scene, frame);
    differs |= scanlit_.picture() != without_reuse_.picture();
  }
  return differs;
}

SceneResult Comparison::run(const BenchScene& scene) {
  scanlit_.prepare(scene, scene.reuse);
  peer_.prepare(scene);
  PictureDifference difference;
  for (int frame = 0; frame < 2; ++frame) difference.take_worse(compare_frame(scene, frame));

  StageTimes stages;
  std::vector<Contender> contenders = {
      {[&](int frame) { scanlit_.draw(scene, frame); }, [&] { stages.add(scanlit_, threads_); }},
      {[&](int frame) { peer_.draw(scene, frame, Target::buffer); }},
      {[&](int frame) { peer_.draw(scene, frame, Target::framebuffer_object); }}};
  Picture cleared(4 * std::size_t(picture_width) * picture_height);
  if (scene.placements.empty())
    contenders.push_back({[&](int frame) { std::memset(cleared.data(), frame, cleared.size()); }});
  bool other_picture = false;
  if (scene.reuse) {
    without_reuse_.prepare(scene);
    other_picture = reuse_shows(scene);
    contenders.push_back({[&](int frame) { without_reuse_.draw(scene, frame); }});
  }

  const int first = 5;  // after those that were drawn to compare
  const int frames = repeat(effort_, [&](int round) {
    for (std::size_t turn = 0; turn < contenders.size(); ++turn) {  // none always comes first
      Contender& contender = contenders[(turn + std::size_t(round)) % contenders.size()];
      contender.times.measure([&] { contender.draw(first + round); });
      contender.afterwards();
    }
  });
  difference.take_worse(compare_frame(scene, first + frames));

  SceneResult result{.scene = scene.name,
                     .peer = OsmesaPeer::version(),
                     .threads = threads_,
                     .frames = frames,
                     .scanlit = contenders[0].times.summary(),
                     .buffer = contenders[1].times.summary(),
                     .framebuffer_object = contenders[2].times.summary(),
                     .yardstick = {},
                     .max_difference = double(difference.max),
                     .mean_difference = difference.mean,
                     .covered = {difference.covered[0], difference.covered[1]},
                     .same = difference.same() && !other_picture,
                     .difference = difference.words(),
                     .stages = {}};
  if (contenders.size() > 3) result.yardstick = contenders[3].times.summary();
  if (other_picture) result.difference = "reuse changes the picture; " + result.difference;
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

const char* yardstick_name(const std::string& scene) {
  return scene == "S0" ? "memset" : "scanlit_without_reuse";
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
  if (r.yardstick) json[yardstick_name(r.scene)] = as_json(*r.yardstick);
}

void from_json(const nlohmann::json& json, SceneResult& r) {
  r.scene = json.at("scene");
  r.peer = json.at("peer");
  r.threads = json.at("threads");
  r.frames = json.at("frames");
  r.scanlit = frame_time(json.at("scanlit"));
  r.buffer = frame_time(json.at("llvmpipe_buffer"));
  r.framebuffer_object = frame_time(json.at("llvmpipe_framebuffer_object"));
  if (json.contains(yardstick_name(r.scene)))
    r.yardstick = frame_time(json.at(yardstick_name(r.scene)));
  r.max_difference = json.at("max_difference");
  r.mean_difference = json.at("mean_difference");
  json.at("covered").at(0).get_to(r.covered[0]);
  json.at("covered").at(1).get_to(r.covered[1]);
  r.same = json.at("same_picture");
  r.difference = json.at("difference");
  json.at("scanlit_stages_ms").get_to(r.stages);
}

}  // namespace scanlit::bench

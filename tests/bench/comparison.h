// Times a scene in both renderers, frame by frame in turn, and compares their pictures.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "osmesa_peer.h"
#include "scanlit_side.h"
#include "timing.h"

namespace scanlit::bench {

struct SceneResult {
  std::string scene, peer;  // peer: the other renderer's name and version
  int threads = 0, frames = 0;
  FrameTime scanlit, buffer, framebuffer_object;  // the latter two: llvmpipe's Target
  // S0: one memset of the colour buffer. S10: Scanlit's whole frame, nothing reused.
  std::optional<FrameTime> yardstick;
  double max_difference = 0, mean_difference = 0;
  std::int64_t covered[2] = {};  // by Scanlit, by llvmpipe
  bool same = false;
  std::string difference;
  // Of Scanlit's frame, milliseconds summed over the threads, medians; "other" is what of wall time
  // times threads no stage accounts for: waiting, allocating.
  std::map<std::string, double> stages;

  /// llvmpipe's time over Scanlit's, medians.
  double ratio() const { return buffer.median_ms / scanlit.median_ms; }
  /// The same of least times and of processor time: what others do on the machine at the same time
  /// changes them little; the latter does not show what a second thread brings.
  double min_ratio() const { return buffer.min_ms / scanlit.min_ms; }
  double cpu_ratio() const { return buffer.cpu_ms / scanlit.cpu_ms; }
};
void to_json(nlohmann::json& json, const SceneResult& result);
void from_json(const nlohmann::json& json, SceneResult& result);

/// Draws on so many threads; llvmpipe's number is in this process's environment.
class Comparison {
 public:
  Comparison(int threads, const Effort& effort) : threads_(threads), effort_(effort) {}

  SceneResult run(const BenchScene& scene);

 private:
  PictureDifference compare_frame(const BenchScene& scene, int frame);
  bool reuse_shows(const BenchScene& scene);

  int threads_;
  Effort effort_;
  ScanlitSide scanlit_{threads_}, without_reuse_{threads_};
  OsmesaPeer peer_;
};

}  // namespace scanlit::bench

// The folder that a sequence is drawn into: its frames, and frames.json, which says of what job
// they are, so that a job goes on with its own frames and never with those of another.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lessons/studio/frames/sequence.h"
#include "rasterizer/framebuffer.h"

namespace scanlit::studio {

/// What the frames depend on: input and options as they were given, and the content of every file
/// that the scene names. As JSON with one level of keys, for comparison and for people.
nlohmann::json describe_job(const std::string& input, const std::vector<GivenEdit>& edits,
                            const nlohmann::json& options, const Description& first);

class FrameFolder {
 public:
  /// `suffix` is the frames' format: "png". Numbers have as many digits as the last one, at
  /// least 4.
  FrameFolder(std::filesystem::path folder, int frames, std::string suffix);

  std::filesystem::path file(int frame) const;  // folder/frame_0000.png
  std::filesystem::path name() const { return folder_; }

  /// Makes the folder and its frames.json, unless they are there. `begin_anew` removes frames that
  /// are there, whatever their job. Throws Error: the folder holds frames of another job or of an
  /// unknown one, or cannot be made or written to.
  void prepare(const nlohmann::json& job, bool begin_anew) const;

  /// Whether the frame is there, whole, and of that size.
  bool finished(int frame, int width, int height) const;

 private:
  std::filesystem::path folder_;
  std::string suffix_;
  std::size_t digits_;
};

}  // namespace scanlit::studio

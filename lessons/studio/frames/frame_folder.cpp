#include "lessons/studio/frames/frame_folder.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lessons/studio/fingerprint.h"
#include "lessons/studio/program.h"
#include "rasterizer/error.h"
#include "rasterizer/image.h"
#include "rasterizer/image/output_file.h"
#include "rasterizer/shapes.h"

namespace scanlit::studio {
namespace {

constexpr const char* frame_prefix = "frame_";

/// Under the name by which the scene knows it: the job may go on from another folder or machine.
void add_file(nlohmann::json& job, const std::filesystem::path& folder, std::string_view name) {
  std::error_code none;
  if (std::filesystem::is_regular_file(folder / name, none))
    job["content of " + std::string(name)] = Fingerprint().add_file(folder / name).text();
}

/// Images and tables that a model's specification names, in whichever argument.
void add_files_of(nlohmann::json& job, std::string_view specification,
                  const std::filesystem::path& folder) {
  while (!specification.empty()) {
    const std::size_t end = std::min(specification.find_first_of(":=,()"), specification.size());
    if (end > 0) add_file(job, folder, specification.substr(0, end));
    specification.remove_prefix(std::min(end + 1, specification.size()));
  }
}

bool is_frame(const std::filesystem::path& file) {
  const std::string stem = file.stem().string(), prefix = frame_prefix;
  return stem.starts_with(prefix) && stem.size() > prefix.size() &&
         std::all_of(stem.begin() + std::ptrdiff_t(prefix.size()), stem.end(),
                     [](unsigned char c) { return std::isdigit(c); });
}

std::vector<std::filesystem::path> frames_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> frames;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file() && is_frame(entry.path())) frames.push_back(entry.path());
  std::ranges::sort(frames);
  return frames;
}

/// The first key in which two jobs differ; both are objects of one level.
std::string difference(const nlohmann::json& there, const nlohmann::json& here) {
  for (const auto& [key, value] : here.items())
    if (!there.contains(key) || there[key] != value) return key;
  for (const auto& [key, value] : there.items())
    if (!here.contains(key)) return key;
  return "nothing";
}

constexpr const char* ways_out = "; take another folder, or draw all anew with --force";

void check_same_job(const std::filesystem::path& manifest, const nlohmann::json& job) {
  std::ifstream stream(manifest);
  const nlohmann::json there = nlohmann::json::parse(stream, nullptr, false);
  if (!there.is_object())
    throw Error(manifest.string(),
                std::string("does not say of what job the frames are") + ways_out);
  if (there != job)
    throw Error(manifest.string(), "the frames there are of another job: '" +
                                       difference(there, job) + "' differs" + ways_out);
}

}  // namespace

nlohmann::json describe_job(const std::string& input, const std::vector<GivenEdit>& edits,
                            const nlohmann::json& options, const Description& first) {
  nlohmann::json job = options;
  const std::filesystem::path file(input);
  job["INPUT"] = file.filename().string();
  for (const auto& [edit, text] : edits) {
    if (edit->option == std::string_view("--threads")) continue;  // no picture depends on them
    job[edit->option] = text;
  }
  if (is_scene(input)) add_file(job, file.parent_path(), file.filename().string());
  for (const ObjectDescription& object : first.objects) {
    if (!is_shape(object.mesh)) add_file(job, object.folder, object.mesh);
    add_files_of(job, object.material.model.specification, object.folder);
  }
  // Names need not be UTF-8, which JSON has to be.
  return nlohmann::json::parse(job.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

FrameFolder::FrameFolder(std::filesystem::path folder, int frames, std::string suffix)
    : folder_(std::move(folder)),
      suffix_(std::move(suffix)),
      digits_(std::max<std::size_t>(4, std::to_string(frames - 1).size())) {}

std::filesystem::path FrameFolder::file(int frame) const {
  std::string number = std::to_string(frame);
  number.insert(0, digits_ - number.size(), '0');
  return folder_ / (frame_prefix + number + '.' + suffix_);
}

void FrameFolder::prepare(const nlohmann::json& job, bool begin_anew) const {
  std::filesystem::create_directories(folder_);
  const std::filesystem::path manifest = folder_ / "frames.json";
  // Frames before the manifest: it was there before the first of them, whoever draws them now.
  const auto frames = frames_in(folder_);
  if (begin_anew) {
    // The manifest goes first: frames without one are nobody's, but not another's.
    std::filesystem::remove(manifest);
    for (const auto& frame : frames) std::filesystem::remove(frame);
  } else if (std::filesystem::is_regular_file(manifest)) {
    return check_same_job(manifest, job);
  } else if (!frames.empty()) {
    throw Error(folder_.string(), "holds " + frames.front().filename().string() +
                                      " and no frames.json that says of what job it is" + ways_out);
  }
  const HoldInterrupts until_written;
  OutputFile file(manifest);
  const std::string text = job.dump(2) + '\n';
  std::fwrite(text.data(), 1, text.size(), file.stream());
  file.commit();
}

bool FrameFolder::finished(int frame, int width, int height) const {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file(frame), none)) return false;
  try {
    const Framebuffer picture = read_image(file(frame), Encoding::linear);  // srgb takes longer
    return picture.width == width && picture.height == height;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace scanlit::studio

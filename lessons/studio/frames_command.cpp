// scanlit frames
#include <algorithm>
#include <exception>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "lessons/studio/commands.h"
#include "lessons/studio/frames/frame_folder.h"
#include "lessons/studio/frames/ranks.h"
#include "lessons/studio/frames/sequence.h"
#include "lessons/studio/program.h"
#include "lessons/studio/progress_bar.h"
#include "lessons/studio/text.h"
#include "rasterizer/error.h"
#include "rasterizer/image/animation.h"
#include "rasterizer/image/output_file.h"

namespace scanlit::studio {
namespace {

struct FramesOptions : SceneOptions {
  std::string output, count = "36", orbit, axis, range, format = "png", gif, fps = "12.5";
  std::vector<std::string> sweeps;
  bool slurm = false, force = false;
};

constexpr Range count_range{1, 100'000};

bool sweeps_an_option(const std::vector<GivenEdit>& edits) {
  return std::ranges::any_of(edits, [](const GivenEdit& given) {
    return text_at(given.edit->option, given.text, 0) != text_at(given.edit->option, given.text, 1);
  });
}

Motion motion_of(const FramesOptions& options) {
  Motion motion;
  motion.frames = parse_integer("--count", options.count, count_range);
  for (const std::string& sweep : options.sweeps) motion.sweeps.push_back(parse_path_sweep(sweep));
  if (!options.orbit.empty())
    motion.orbit = choose("--orbit", "orbit", options.orbit, orbits);
  else if (motion.sweeps.empty() && !sweeps_an_option(options.given()))
    motion.orbit = Orbit::camera;
  if (options.axis.empty()) return motion;
  if (motion.orbit == Orbit::none) throw Error("--axis", "nothing goes around it; see --orbit");
  motion.axis = parse_vector("--axis", options.axis);
  return motion;
}

/// --range FIRST:LAST, --slurm, and a rank's part of what they leave.
Share share_of(const FramesOptions& options, int frames, const Ranks& ranks) {
  Share share{.first = 0, .last = frames - 1};
  if (!options.range.empty()) {
    const std::string where = "--range";
    const auto colon = options.range.find(':');
    if (colon == std::string::npos)
      throw Error(where, "'" + options.range + "' is no FIRST:LAST, as in 0:11");
    const Range allowed{0, double(frames - 1)};
    share.first = parse_integer(where, options.range.substr(0, colon), allowed);
    share.last = parse_integer(where, options.range.substr(colon + 1), allowed);
    if (share.first > share.last) throw Error(where, "the last frame comes before the first");
  }
  if (options.slurm) share = slurm_share(share);
  share.index = share.index * ranks.count() + ranks.rank();
  share.count *= ranks.count();
  return share;
}

/// What the options ask of this process.
struct Job {
  Motion motion;
  Share share;
  FrameFolder folder;
  double frames_per_second;
};

const Choices<std::string> formats{{"png", "png"}, {"exr", "exr"}};

Job job_of(const FramesOptions& options, const Ranks& ranks) {
  const Motion motion = motion_of(options);
  const std::string format = choose("--format", "format", options.format, formats);
  if (options.slurm && options.force)
    throw Error("--force",
                "tasks of an array job would remove each other's frames; remove the "
                "folder before the job");
  return {motion, share_of(options, motion.frames, ranks),
          FrameFolder(options.output, motion.frames, format),
          parse_number("--fps", options.fps, {min_frames_per_second, max_frames_per_second})};
}

/// All that is done once, whatever the number of ranks: every check, the folder, and its manifest.
Sequence prepare(const FramesOptions& options, const Job& job) {
  Sequence sequence(options.input, options.given(), job.motion);
  const Picture& picture = sequence.first().picture;
  validate_size(picture.width, picture.height);
  if (!options.gif.empty()) {
    check_animation(options.gif, picture.width, picture.height, job.motion.frames);
    // Its folder may be that of the frames, which is not there yet.
    const auto folder = std::filesystem::weakly_canonical(options.gif).parent_path();
    if (folder != std::filesystem::weakly_canonical(options.output)) OutputFile{options.gif};
  }
  const nlohmann::json rest{{"scanlit", SCANLIT_VERSION}, {"--count", job.motion.frames},
                            {"--orbit", options.orbit},   {"--axis", options.axis},
                            {"--sweep", options.sweeps},  {"--format", options.format}};
  job.folder.prepare(describe_job(options.input, options.given(), rest, sequence.first()),
                     options.force);
  return sequence;
}

struct Counts {
  long drawn = 0, kept = 0;
};

/// Draws those of the process's frames that are missing or damaged.
Counts draw(const Job& job, Sequence& sequence) {
  const Picture& picture = sequence.first().picture;
  Counts counts;
  std::vector<int> missing;
  for (int frame = job.share.first; frame <= job.share.last; ++frame) {
    if (!job.share.has(frame)) continue;
    const bool finished = job.folder.finished(frame, picture.width, picture.height);
    counts.kept += finished;
    if (!finished) missing.push_back(frame);
  }
  Framebuffer framebuffer(picture.width, picture.height);
  Renderer renderer;
  ProgressBar bar;
  for (const int index : missing) {
    FrameScene frame = sequence.frame(index);
    RenderSettings settings = frame.picture.render_settings();
    settings.progress = [&](double done) {
      bar.show((double(counts.drawn) + done) / double(missing.size()));
    };
    renderer.render(frame.scene, frame.camera, settings, framebuffer);
    const HoldInterrupts until_written;
    write_image(job.folder.file(index), framebuffer, frame.picture.image);
    ++counts.drawn;
  }
  return counts;
}

/// By whichever process finds all frames there.
void write_gif(const FramesOptions& options, const Job& job, const Picture& picture) {
  for (int frame = 0; frame < job.motion.frames; ++frame)
    if (!job.folder.finished(frame, picture.width, picture.height))
      return note(options.gif + " is made by whoever draws the last frame; " +
                  job.folder.file(frame).filename().string() + " is not there yet");
  // 8-bit frames are taken code by code.
  const Encoding encoding = options.format == "exr" ? picture.image.encoding : Encoding::linear;
  ProgressBar bar("joining");
  const HoldInterrupts until_written;
  write_animation(
      options.gif, job.motion.frames,
      [&](int frame) {
        bar.show(double(frame) / job.motion.frames);
        return read_image(job.folder.file(frame), Encoding::linear);
      },
      job.frames_per_second, encoding);
  std::cout << options.gif << ": " << job.motion.frames << " frames\n";
}

void report(const Job& job, long drawn, long kept) {
  const long frames = job.motion.frames;
  std::cout << job.folder.name().string() << ": " << drawn + kept << " of " << frames
            << (frames == 1 ? " frame, " : " frames, ") << drawn << " drawn, " << kept << " kept\n";
}

void make_frames(const FramesOptions& options) {
  const Ranks ranks;
  // A rank that left without the others would keep them waiting: each hears of each failure.
  std::exception_ptr failure;
  const auto attempt = [&](const auto& work) {
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
    }
  };
  std::optional<Sequence> sequence;
  if (ranks.rank() == 0) attempt([&] { sequence = prepare(options, job_of(options, ranks)); });
  if (!ranks.agreed(!failure)) {
    if (failure) std::rethrow_exception(failure);
    return;
  }
  const Job job = job_of(options, ranks);
  Counts counts;
  attempt([&] {
    if (!sequence) sequence.emplace(options.input, options.given(), job.motion);
    counts = draw(job, *sequence);
  });
  const auto [drawn, kept, failures] = ranks.summed({counts.drawn, counts.kept, failure ? 1 : 0});
  if (failure) std::rethrow_exception(failure);
  if (ranks.rank() > 0 || failures > 0) return;
  report(job, drawn, kept);
  if (!options.gif.empty()) write_gif(options, job, sequence->first().picture);
}

}  // namespace

Command add_frames_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("frames", "Draws a numbered sequence of pictures");
  app->footer(
      "Examples:\n"
      "  scanlit frames teapot:16 -o turn --gif turn.gif\n"
      "  scanlit frames teapot:16 --model cook-torrance:m=.05:.6 -o roughness\n"
      "  scanlit frames scene.toml --sweep light.0.intensity=0:2 --orbit object -o dawn\n"
      "  mpirun -n 4 scanlit frames scene.toml --count 360 -o turn\n"
      "\n"
      "Where an option takes a number or a list of them, FROM:TO goes from one in the first frame\n"
      "to the other in the last. --sweep does the same to what a scene file says, by its path:\n"
      "  camera.fov=20:60  light.0.direction=1,1,0:-1,1,0  material.copper.model.n=5:200\n"
      "Nothing to sweep and no --orbit: the camera goes once around.\n"
      "Repeated, a command keeps the frames that are whole and draws the rest.");
  const auto options = std::make_shared<FramesOptions>();
  const auto add = [&](const char* name, auto& variable, const char* type, const char* help) {
    return app->add_option(name, variable, help)->type_name(type);
  };
  add("-o,--output", options->output, "DIR", "folder of frame_0000.png, ... and frames.json")
      ->required();
  add("--count", options->count, "N", "frames of the whole sequence (36)");
  add("--orbit", options->orbit, "WHAT", "camera, object or light goes once around the middle");
  add("--axis", options->axis, "X,Y,Z", "of the orbit (the camera's up)");
  add("--sweep", options->sweeps, "PATH=FROM:TO", "changes what the scene file says; repeatable")
      ->allow_extra_args(false);
  add("--range", options->range, "FIRST:LAST", "draw only these; the first of all is 0");
  app->add_flag("--slurm", options->slurm, "draw only this array task's part of the frames");
  add("--format", options->format, "NAME", "png or exr (png)");
  add("--gif", options->gif, "FILE", "an animation of all frames, once they are there");
  add("--fps", options->fps, "RATE", "of the animation, frames a second, 1 to 50 (12.5)");
  app->add_flag("--force", options->force, "remove the folder's frames and begin anew");
  add_scene_options(*app, *options);
  return {app, [options] { make_frames(*options); }};
}

}  // namespace scanlit::studio

// What every lesson does around its one new idea: --help, --size, -o and its own knobs, errors,
// figures, writing the picture.
//
// How a lesson is added:
//  1. lessons/NN_name.cpp, a main() like that of 01_pixels.cpp. Three lines head it (New idea,
//     Builds on, Try). About 80 lines; the idea, about 25, stands between the lines `// new idea`
//     and `// end of new idea`. What another lesson teaches is an engine call, not written again.
//     drawing/ has what pictures are made of: Canvas (lines, dots, words), panels, Chart (curves).
//  2. lessons/NN_name.md: a copy of 01_pixels.md with its own text. What stands between
//     `<!-- made: ... -->` and `<!-- end -->` is made by lessons/pages: run it. Bold numbers are
//     figures: the lesson has to print them. Add the page to the table in lessons/README.md.
//  3. `add_lesson(NN_name)` in lessons/CMakeLists.txt. Its golden image is then `lesson_NN_name`:
//     look at lessons/NN_name.png at full size, then tests/bless lesson_NN_name.
// tests/lessons holds lessons and pages to all this, and pictures to a checklist.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lessons/studio/program.h"
#include "lessons/studio/text.h"
#include "rasterizer/framebuffer.h"

namespace scanlit::studio {

class Lesson {
 public:
  /// `idea`: one line, for --help. The picture is width x height pixels unless --size says
  /// otherwise, and goes to lessons/out/NAME.png, NAME being the program's, unless -o does.
  Lesson(std::string idea, int width, int height);

  /// An option of the lesson's own; its default is what `value` holds.
  void knob(const std::string& option, int& value, const Range& range, const std::string& what);
  void knob(const std::string& option, double& value, const Range& range, const std::string& what);
  void knob(const std::string& option, std::string& value, const std::string& what);

  /// The lesson's main(): reads the command line, draws, writes, prints. Returns the exit code.
  int run(int argc, char** argv, const std::function<Framebuffer()>& draw);

  // Known while it draws.
  int width() const { return width_; }
  int height() const { return height_; }
  double aspect() const { return double(width_) / height_; }

  /// "name: value", one of the two or three figures that make the lesson's point. The page may
  /// state it; a time (in milliseconds) may not stand there, since it is another one each time.
  void figure(const std::string& name, const std::string& value);
  void time(const std::string& name, double milliseconds);

 private:
  struct Knob {
    std::string option, what, shown;
    std::function<void(const std::string& text)> read;
    std::string text{};
  };
  void knob(const std::string& option, const std::string& shown, const std::string& what,
            const std::function<void(const std::string& text)>& read);
  void read_size(const std::string& text);
  void finish(const std::string& output, const std::function<Framebuffer()>& draw);

  std::string idea_, name_;
  int width_, height_;
  std::vector<Knob> knobs_;
  std::string figures_;
};

}  // namespace scanlit::studio

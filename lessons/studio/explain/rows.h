// Lines of a label, up to three numbers below one another, and a remark.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "rasterizer/vec.h"

namespace scanlit::studio {

std::string short_text(double value, int digits = 6);
/// "1 light", "2 lights".
std::string plural(std::size_t count, const std::string& word);

class Rows {
 public:
  explicit Rows(std::ostream& out) : out_(out) {}

  void title(const std::string& text, const std::vector<std::string>& columns = {}) const;
  void text(const std::string& label, const std::string& words) const;
  void numbers(const std::string& label, const std::vector<double>& values,
               const std::string& remark = "", int decimals = 6) const;
  void colour(const std::string& label, const Rgb<float>& c, const std::string& remark = "",
              int decimals = 6) const {
    numbers(label, {double(c.r), double(c.g), double(c.b)}, remark, decimals);
  }
  void vector(const std::string& label, const Vec3<float>& v,
              const std::string& remark = "") const {
    numbers(label, {double(v.x), double(v.y), double(v.z)}, remark);
  }

 private:
  void line(const std::string& label, const std::vector<std::string>& cells,
            const std::string& remark) const;

  std::ostream& out_;
};

const std::vector<std::string> xyz{"x", "y", "z"}, rgb{"red", "green", "blue"};

}  // namespace scanlit::studio

// From text to numbers, vectors and choices, checked, for the command line and for scene files.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rasterizer/error.h"
#include "rasterizer/image.h"
#include "rasterizer/mesh.h"
#include "rasterizer/scene.h"
#include "rasterizer/vec.h"

namespace scanlit::studio {

/// What a number may be, both ends included; NaN and infinity never are.
struct Range {
  double min, max;
};
constexpr Range any_coordinate{-1e12, 1e12};  // squares and products stay finite as floats
constexpr Range any_length{1e-12, 1e12};
constexpr Range any_angle_deg{-3600, 3600};
constexpr Range elevation_range_deg{-89.9, 89.9};  // at 90 the viewer looks along `up`
constexpr Range fov_range_deg{0.1, 179};
constexpr Range crease_range_deg{0, 180};
constexpr Range exposure_range_ev{-100, 100};
constexpr Range light_range{0, 1e6};
constexpr Range reflectance_range{0, 1};

/// Words and what they stand for.
template <class E>
using Choices = std::vector<std::pair<std::string, E>>;
extern const Choices<Shading> shadings;
extern const Choices<Sides> all_sides;
extern const Choices<NormalWeight> normal_weights;
extern const Choices<Encoding> encodings;
extern const Choices<Projection> projections;
extern const Choices<LightKind> light_kinds;
extern const Choices<TangentField> tangent_fields;
extern const Choices<Tangents> brushes;  // fields and axes: "around y"

/// The shortest text that reads back as `value`.
std::string text_of(double value);
/// "0.5", or "0.5/0.4/0.3" where the channels differ: as models::make() reads it.
std::string text_of(const Rgb<double>& colour);
/// So many decimals, also where they are zeros.
std::string fixed(double value, int decimals);
/// "1,234,567".
std::string grouped(std::int64_t count);

/// `where` names the option or place in a file, for the Error that each of these throws where the
/// text or value is not what it should be.
double in_range(const std::string& where, double value, const Range& range);
double parse_number(const std::string& where, std::string_view text, const Range& range);
int parse_integer(const std::string& where, std::string_view text, const Range& range);
glm::dvec3 parse_vector(const std::string& where, std::string_view text);                 // "x,y,z"
Rgb<double> parse_colour(const std::string& where, std::string_view text, const Range&);  // "r,g,b"
std::pair<int, int> parse_size(const std::string& where, std::string_view text);          // "WxH"
int check_samples(const std::string& where, int samples);

template <class E>
E choose(const std::string& where, const std::string& kind, const std::string& word,
         const Choices<E>& choices) {
  std::vector<std::string> words;
  for (const auto& [name, value] : choices) {
    if (name == word) return value;
    words.push_back(name);
  }
  throw Error(where, "unknown " + kind + " '" + word + "'" + did_you_mean(word, words));
}

}  // namespace scanlit::studio

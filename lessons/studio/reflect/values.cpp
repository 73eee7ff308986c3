#include "lessons/studio/reflect/values.h"

#include <algorithm>

namespace scanlit::studio {
namespace {

template <class T>
Rgb<double> evaluate_row(const ReflectionModel& model, const DirectionRow& row) {
  const auto rounded = [](const Vec3<double>& a) { return Vec3<T>{T(a.x), T(a.y), T(a.z)}; };
  const Reflection<T> value = model.evaluate(rounded(row.l), rounded(row.v), SurfacePoint<T>{});
  const Rgb<T> sum = value.diffuse + value.glossy;
  return {sum.r, sum.g, sum.b};
}

/// Arrays for one span, as the renderer has them.
class RowSpan {
 public:
  static constexpr std::size_t capacity = 256;

  explicit RowSpan(const ReflectionModel& model)
      : model_(model), parameters_(model.needs().parameters) {
    for (auto& array : parameters_) array.resize(capacity);
    std::fill_n(normal_[2], capacity, 1.0f);
    std::fill_n(tangent_[0], capacity, 1.0f);
    for (auto& array : colour_) std::fill_n(array, capacity, 1.0f);
  }

  void evaluate(std::span<const DirectionRow> rows, std::vector<Rgb<double>>& values) {
    for (std::size_t i = 0; i < capacity; ++i) {
      const DirectionRow& row = rows[std::min(i, rows.size() - 1)];  // whole vectors are read
      to_light_[0][i] = float(row.l.x), to_viewer_[0][i] = float(row.v.x);
      to_light_[1][i] = float(row.l.y), to_viewer_[1][i] = float(row.v.y);
      to_light_[2][i] = float(row.l.z), to_viewer_[2][i] = float(row.v.z);
    }
    evaluate(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto sum = [&](int c) { return double(diffuse_[c][i] + glossy_[c][i]); };
      // A span's points are visible by definition, and a viewer below the horizon is raised to it.
      values.push_back(to_viewer_[2][i] > 0 ? Rgb<double>(sum(0), sum(1), sum(2)) : Rgb<double>());
    }
  }

 private:
  using Array = float[capacity];

  void evaluate(std::size_t size) {
    PointSpan points{.size = size};
    DirectionSpan in{.size = size, .points = &points};
    ReflectionSpan out;
    for (int c = 0; c < 3; ++c) {
      in.normal[c] = points.normal[c] = normal_[c];
      in.tangent[c] = points.tangent[c] = tangent_[c];
      in.to_light[c] = to_light_[c], in.to_viewer[c] = to_viewer_[c];
      points.object_position[c] = position_[c], points.vertex_colour[c] = colour_[c];
      out.diffuse[c] = diffuse_[c], out.glossy[c] = glossy_[c];
      if (c < 2) points.texcoord[c] = texcoord_[c];
    }
    std::vector<float*> parameters;
    for (auto& array : parameters_) parameters.push_back(array.data());
    if (!parameters.empty()) {
      model_.evaluate_parameters(points, parameters.data());
      in.parameters = parameters.data();
    }
    model_.evaluate(in, out);
  }

  const ReflectionModel& model_;
  std::vector<std::vector<float>> parameters_;
  Array normal_[3]{}, tangent_[3]{}, position_[3]{}, texcoord_[2]{}, colour_[3]{};
  Array to_light_[3], to_viewer_[3], diffuse_[3], glossy_[3];
};

}  // namespace

std::vector<Rgb<double>> evaluate_rows(const ReflectionModel& model,
                                       std::span<const DirectionRow> rows, Precision precision) {
  std::vector<Rgb<double>> values;
  values.reserve(rows.size());
  if (precision == Precision::batch) {
    RowSpan span(model);
    for (; !rows.empty(); rows = rows.subspan(std::min(rows.size(), RowSpan::capacity)))
      span.evaluate(rows.first(std::min(rows.size(), RowSpan::capacity)), values);
    return values;
  }
  for (const DirectionRow& row : rows)
    values.push_back(precision == Precision::double_ ? evaluate_row<double>(model, row)
                                                     : evaluate_row<float>(model, row));
  return values;
}

}  // namespace scanlit::studio

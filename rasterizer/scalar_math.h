// What a formula template calls, for the scalars double and float; batch.h and
// batch_trigonometry.h have the same for Batch.
#pragma once

#include <cmath>

namespace scanlit {

using std::abs;
using std::atan2;
using std::cos;
using std::exp;
using std::floor;
using std::log;
using std::pow;
using std::sin;
using std::sqrt;

inline double select(bool condition, double a, double b) { return condition ? a : b; }
inline float select(bool condition, float a, float b) { return condition ? a : b; }
inline double min(double a, double b) { return a < b ? a : b; }
inline float min(float a, float b) { return a < b ? a : b; }
inline double max(double a, double b) { return a > b ? a : b; }
inline float max(float a, float b) { return a > b ? a : b; }
inline double mul_add(double a, double b, double c) { return a * b + c; }
inline float mul_add(float a, float b, float c) { return a * b + c; }
inline double reciprocal(double x) { return 1 / x; }
inline float reciprocal(float x) { return 1 / x; }
inline double inverse_sqrt(double x) { return 1 / sqrt(x); }
inline float inverse_sqrt(float x) { return 1 / sqrt(x); }
inline double log_sum(double x, double low) { return log(x) + low / x; }
inline float log_sum(float x, float low) { return log(x) + low / x; }
// x is clamped to [-1, 1]: see batch_trigonometry.h.
inline double acos(double x) { return std::acos(min(max(x, -1.0), 1.0)); }
inline float acos(float x) { return std::acos(min(max(x, -1.0f), 1.0f)); }
inline double asin(double x) { return std::asin(min(max(x, -1.0), 1.0)); }
inline float asin(float x) { return std::asin(min(max(x, -1.0f), 1.0f)); }

}  // namespace scanlit

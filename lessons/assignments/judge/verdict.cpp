#include "lessons/assignments/judge/verdict.h"

namespace scanlit::assignments {

double points(const Verdict& verdict) {
  double sum = 0;
  for (const TestScore& test : verdict.tests) sum += test.points;
  return sum;
}

double max_points(const Verdict& verdict) {
  double sum = 0;
  for (const TestScore& test : verdict.tests) sum += test.max_points;
  return sum;
}

}  // namespace scanlit::assignments

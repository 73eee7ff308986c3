// The stage under test: three right implementations of different design, and the faults.
#pragma once

#include <cstdint>
#include <vector>

#include "lessons/assignments/A1_scan_conversion/reference.h"

namespace scanlit::assignments::mutants {

/// What a test asks for.
struct Request {
  a1::Triangle triangle;
  int width, height;
};
using Fragments = std::vector<a1::Fragment>;

constexpr int right_designs = 3;

/// Row by row in spans; column by column, backwards; by quarters of the picture.
Fragments right(int design, const scan::ScanVariant& variant, const Request& request);

constexpr int faults = 10;

/// What a fault has to do with.
const char* hint(int fault);

/// A stage with a fault, drawn from a pool by the variant's seed. It may remember what it was asked
/// before: one for each run of a test.
class Mutant {
 public:
  Mutant(int fault, std::uint64_t seed);
  Fragments operator()(const Request& request);

 private:
  int fault_, choice_, amount_;
  scan::ScanVariant variant_;
  int calls_ = 0;
};

}  // namespace scanlit::assignments::mutants

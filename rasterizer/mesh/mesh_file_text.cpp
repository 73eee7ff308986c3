#include <algorithm>
#include <charconv>
#include <cmath>

#include "rasterizer/error.h"
#include "rasterizer/mesh/mesh_file.h"

namespace scanlit::detail {
namespace {

constexpr std::string_view blanks = " \t\v\f";

std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 40;
  return "'" + std::string(word.substr(0, longest)) + (word.size() > longest ? "...'" : "'");
}

template <class T>
void append(std::string& text, T value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  text += ' ';
}

}  // namespace

void append_number(std::string& text, float value) { append(text, value); }
void append_number(std::string& text, std::int64_t value) { append(text, value); }

std::string printable(std::string_view text) {
  std::string result(text);
  std::ranges::replace_if(
      result, [](char c) { return c < ' ' || c > '~'; }, '?');
  return result;
}

void expect_text(const std::string& name, std::string_view text) {
  if (text.find('\0') != std::string_view::npos)
    throw Error(name, "not plain text (it holds zero bytes; save UTF-16 as UTF-8)");
}

Lines::Lines(std::string name, std::string_view text, bool continued)
    : name_(std::move(name)), text_(text), continued_(continued) {
  if (text.starts_with("\xef\xbb\xbf")) position_ = 3;
}

bool Lines::next() {
  words_.clear();
  while (words_.empty() && position_ < text_.size()) {
    line_ = next_line_;
    while (split_line() && position_ < text_.size()) {
    }
  }
  return !words_.empty();
}

/// Adds the words of the line at position_; true where the next line belongs to it.
bool Lines::split_line() {
  const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
  std::string_view line = text_.substr(position_, end - position_);
  position_ = std::min(end + (text_.substr(end, 2) == "\r\n" ? 2 : 1), text_.size());
  ++next_line_;

  const bool goes_on = continued_ && line.ends_with('\\');
  if (goes_on) line.remove_suffix(1);
  while (true) {
    const std::size_t start = line.find_first_not_of(blanks);
    if (start == std::string_view::npos || line[start] == '#') return goes_on;
    line.remove_prefix(start);
    words_.push_back(line.substr(0, line.find_first_of(blanks)));
    line.remove_prefix(words_.back().size());
  }
}

void Lines::fail(const std::string& what) const {
  throw Error(name_ + ":" + std::to_string(line_), printable(what));
}

void Lines::expect_words(std::size_t at_least, const std::string& what) const {
  if (words_.size() < at_least) fail(what);
}

double Lines::any_number(std::size_t word, const char* what) const {
  std::string_view digits = words_[word];
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size() ||
      (digits.size() < words_[word].size() && digits.starts_with('-')))
    fail(std::string(what) + " " + quoted(words_[word]) + " is not a number");
  // from_chars says no more than that a double cannot hold it; what it is, the exponent's sign
  // says.
  if (error == std::errc::result_out_of_range)
    value = digits.find("e-") == digits.npos && digits.find("E-") == digits.npos ? INFINITY : 0;
  return value;
}

float Lines::finite(std::size_t word, const char* what) const {
  const auto value = float(any_number(word, what));
  if (!std::isfinite(value))
    fail(std::string(what) + " " + quoted(words_[word]) + " is not a finite float");
  return value;
}

std::int64_t Lines::integer(std::string_view word, const char* what) const {
  std::string_view digits = word;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size())
    fail(std::string(what) + " " + quoted(word) + " is not a whole number");
  return value;
}

}  // namespace scanlit::detail

#include "tests/mutation/faults.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace scanlit::mutation {

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) throw std::runtime_error(file.string() + " cannot be read");
  return text.str();
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  if (!(out << text << std::flush)) throw std::runtime_error(file.string() + " cannot be written");
}

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0, end;
  while ((end = text.find(separator, begin)) != text.npos) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + separator.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

void read_table(const fs::path& file, std::vector<Fault>& faults) {
  const std::vector<std::string> lines = split(read(file), "\n");
  fs::path source;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const auto require = [&](bool holds, const char* wanted) {
      if (!holds)
        throw std::runtime_error(file.filename().string() + ":" + std::to_string(i + 1) +
                                 ": wanted " + wanted);
    };
    if (line.empty() || line[0] == '#') continue;
    if (line.starts_with("in ")) {
      source = line.substr(3);
    } else if (line.starts_with("= ")) {
      require(!faults.empty(), "a fault before");
      faults.back().equivalent = line.substr(2);
    } else {
      require(line.starts_with("- ") || line.starts_with("* "), "in, -, *, = or #");
      const auto parts = split(line.substr(2), " | ");
      require(parts.size() == 3 && !source.empty(), "KIND | MEANING | TESTS, in a file");
      require(i + 2 < lines.size() && lines[i + 1].starts_with("  ") &&
                  lines[i + 2].starts_with("  ") && lines[i + 1] != lines[i + 2],
              "two different texts in the lines below");
      Fault fault{source, parts[0], parts[1], lines[i + 1].substr(2), lines[i + 2].substr(2), {}};
      for (const std::string& test : split(parts[2], " ")) {
        const auto colon = test.find(':');
        fault.catchers.push_back(
            {test.substr(0, colon), colon == test.npos ? "*" : test.substr(colon + 1)});
      }
      fault.in_sample = line[0] == '*';
      faults.push_back(std::move(fault));
      i += 2;
    }
  }
}

}  // namespace

std::vector<Fault> read_faults(const fs::path& folder) {
  std::set<fs::path> tables;
  for (const auto& entry : fs::directory_iterator(folder)) tables.insert(entry.path());
  std::vector<Fault> faults;
  for (const fs::path& table : tables) read_table(table, faults);
  return faults;
}

std::string with_fault(const Fault& fault, const fs::path& tree) {
  std::string text = read(tree / fault.file);
  const auto at = text.find(fault.original);
  if (at == text.npos || text.find(fault.original, at + 1) != text.npos)
    throw std::runtime_error(fault.file.string() + " has " +
                             (at == text.npos ? "no text" : "more than one text") + " '" +
                             fault.original + "'");
  return text.replace(at, fault.original.size(), fault.replacement);
}

Planted::Planted(const Fault& fault, const fs::path& tree)
    : file_(tree / fault.file), text_(read(file_)) {
  write(file_, with_fault(fault, tree));
}

Planted::~Planted() { write(file_, text_); }

}  // namespace scanlit::mutation

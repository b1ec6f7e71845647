// SPDX-License-Identifier: MIT
#include "tests/sets/nist/nist_set.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace camlaw::sets {
namespace {

/// All numbers of a line up to the first word that is none.
std::vector<double> numbers(const std::string& text) {
  std::vector<double> result;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    std::size_t used = 0;
    try {
      result.push_back(std::stod(word, &used));
    } catch (const std::logic_error&) {
      break;
    }
    if (used != word.size()) break;
  }
  return result;
}

bool starts_with(const std::string& text, const std::string& begin) {
  return text.compare(0, begin.size(), begin) == 0;
}

/// Copies of Roszman1.dat are about in which the last digit of b1, 2.0196866396E-01, has come to
/// its front. It gives a sum of squares of 25, that of the file itself is 4.9E-04.
constexpr char kMisprint[] = "1.20196866396E-0";
constexpr double kMisprinted = 2.0196866396E-01;

/// "b1 = start1 start2 certified deviation"; other lines are passed over.
void read_parameter(const std::string& line, NistSet& set) {
  const std::size_t first = line.find_first_not_of(' '), equals = line.find('=');
  if (first == std::string::npos || line[first] != 'b' || equals == std::string::npos) return;
  const std::vector<double> row = numbers(line.substr(equals + 1));
  if (row.size() != 4) return;
  set.starts[0].push_back(row[0]);
  set.starts[1].push_back(row[1]);
  const bool misprint = line.find(kMisprint) != std::string::npos;
  set.certified.push_back(misprint ? kMisprinted : row[2]);
  set.deviations.push_back(row[3]);
}

void read_point(const std::string& line, NistSet& set) {
  const std::vector<double> row = numbers(line);
  if (row.size() < 2) return;
  set.y.push_back(row[0]);
  set.x.resize(row.size() - 1);
  for (std::size_t k = 1; k < row.size(); ++k) set.x[k - 1].push_back(row[k]);
}

}  // namespace

const std::vector<std::string>& nist_names() {
  static const std::vector<std::string> names{
      "Bennett5", "BoxBOD", "Chwirut1", "Chwirut2", "DanWood",  "ENSO",     "Eckerle4",
      "Gauss1",   "Gauss2", "Gauss3",   "Hahn1",    "Kirby2",   "Lanczos1", "Lanczos2",
      "Lanczos3", "MGH09",  "MGH10",    "MGH17",    "Misra1a",  "Misra1b",  "Misra1c",
      "Misra1d",  "Nelson", "Rat42",    "Rat43",    "Roszman1", "Thurber"};
  return names;
}

NistSet read_nist(const std::filesystem::path& file) {
  const std::string sum = "Residual Sum of Squares:";
  std::ifstream stream(file);
  if (!stream) throw std::invalid_argument(fmt::format("cannot read {}", file.string()));
  NistSet set;
  set.name = file.stem().string();
  // The second line that begins with "Data:" heads the columns; the first describes them.
  int heads = 0;
  for (std::string line; std::getline(stream, line);) {
    if (heads == 2) read_point(line, set);
    if (starts_with(line, "Data:")) ++heads;
    if (heads == 1) read_parameter(line, set);
    if (starts_with(line, sum)) {
      const auto value = numbers(line.substr(sum.size()));
      if (!value.empty()) set.sum_of_squares = value[0];
    }
  }
  if (set.certified.empty() || set.y.empty() || !(set.sum_of_squares > 0)) {
    throw std::invalid_argument(
        fmt::format("{} lacks parameters, data or the sum of squares", file.string()));
  }
  return set;
}

}  // namespace camlaw::sets

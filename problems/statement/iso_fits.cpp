// SPDX-License-Identifier: MIT
#include "problems/statement/iso_fits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace camlaw::problems {
namespace {

constexpr int kLeastGrade = 5, kLargestGrade = 11;
constexpr std::size_t kSteps = 13;  // of nominal sizes in ISO 286-1, up to 500 mm
/// Sizes up to these, mm.
constexpr std::array<double, kSteps> kUpTo{3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500};
using Micrometres = std::array<int, kSteps>;

/// ISO 286-1, table 1, as printed in Narayana, Kannaiah and Venkata Reddy, Machine Drawing, table
/// 15.1, and by makers of bar (h6 to h11); IT5 to IT11 are 7, 10, 16, 25, 40, 64 and 100 times
/// 0.45 D^(1/3) + 0.001 D, D the geometric mean of the step, and rounded.
constexpr std::array<Micrometres, kLargestGrade - kLeastGrade + 1> kGrades{{
    {4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27},
    {6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40},
    {10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63},
    {14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97},
    {25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155},
    {40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250},
    {60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400},
}};

/// A shaft's deviation that is nearest to zero: its upper one for d to h, its lower one for k to p.
/// Read in the same book, table 15.2 and the formulae of table 15.4, and in JIS B 0401-2 (shafts,
/// up to 120 mm); between 120 and 180 mm g and k are those of the formulae.
struct Letter {
  std::string_view letter;
  bool is_upper;
  Micrometres deviation;
};
constexpr std::array<Letter, 9> kLetters{{
    {"d", true, {-20, -30, -40, -50, -65, -80, -100, -120, -145, -170, -190, -210, -230}},
    {"e", true, {-14, -20, -25, -32, -40, -50, -60, -72, -85, -100, -110, -125, -135}},
    {"f", true, {-6, -10, -13, -16, -20, -25, -30, -36, -43, -50, -56, -62, -68}},
    {"g", true, {-2, -4, -5, -6, -7, -9, -10, -12, -14, -15, -17, -18, -20}},
    {"h", true, {}},
    {"k", false, {0, 1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 4, 5}},
    {"m", false, {2, 4, 6, 7, 8, 9, 11, 13, 15, 17, 20, 21, 23}},
    {"n", false, {4, 8, 10, 12, 15, 17, 20, 23, 27, 31, 34, 37, 40}},
    {"p", false, {6, 12, 15, 18, 22, 26, 32, 37, 43, 50, 56, 62, 68}},
}};
/// Those whose hole is the shaft's mirror image. Of holes K to P the standard adds a step of the
/// tolerance, which is left out here.
constexpr std::array<std::string_view, 5> kHoles{"D", "E", "F", "G", "H"};
constexpr int kLastOfK = 7;  // from grade 8 on k is 0

std::size_t step_of(double size) {
  if (!(size > 0 && size <= kUpTo.back())) {
    throw std::invalid_argument(
        fmt::format("{:.6g} mm: fits of ISO 286 are for sizes above 0 and up to 500 mm", size));
  }
  return static_cast<std::size_t>(std::lower_bound(kUpTo.begin(), kUpTo.end(), size) -
                                  kUpTo.begin());
}

int tolerance_at(int grade, std::size_t step) {
  return kGrades[static_cast<std::size_t>(grade - kLeastGrade)][step];
}

const Letter* shaft_of(char letter) {
  const auto found = std::find_if(kLetters.begin(), kLetters.end(),
                                  [&](const Letter& l) { return l.letter.front() == letter; });
  return found == kLetters.end() ? nullptr : &*found;
}

bool is_hole(std::string_view letter) {
  return std::find(kHoles.begin(), kHoles.end(), letter) != kHoles.end();
}

/// The letter as it is kept; empty where it is not known.
std::string_view known_letter(std::string_view text) {
  for (const std::string_view both : {"js", "JS"}) {
    if (text == both) return both;
  }
  for (const Letter& letter : kLetters) {
    if (letter.letter == text) return letter.letter;
  }
  for (const std::string_view hole : kHoles) {
    if (hole == text) return hole;
  }
  return {};
}

constexpr double kMillimetre = 1e-3;

}  // namespace

Fit parse_fit(std::string_view text) {
  const std::size_t digits = std::min(text.find_first_of("0123456789"), text.size());
  const std::string_view letter = known_letter(text.substr(0, digits));
  const std::string_view grade = text.substr(digits);
  for (int known = kLeastGrade; known <= kLargestGrade && !letter.empty(); ++known) {
    if (grade == std::to_string(known)) return {letter, known};
  }
  throw std::invalid_argument(
      fmt::format("'{}' is not a known fit; use the letters d, e, f, g, h, js, k, m, n, p of "
                  "shafts and D, E, F, G, H, JS of holes with a grade from {} to {}, such as h7",
                  text, kLeastGrade, kLargestGrade));
}

double standard_tolerance(int grade, double size) {
  return kMillimetre * tolerance_at(grade, step_of(size));
}

FitDeviations fit_deviations(const Fit& fit, double size) {
  const std::size_t step = step_of(size);
  const double width = tolerance_at(fit.grade, step);
  if (fit.letter == "js" || fit.letter == "JS") {
    return {-kMillimetre * width / 2, kMillimetre * width / 2};
  }
  if (is_hole(fit.letter)) {
    const Letter& shaft = *shaft_of(static_cast<char>(fit.letter.front() - 'A' + 'a'));
    const double least = -shaft.deviation[step];
    return {kMillimetre * least, kMillimetre * (least + width)};
  }
  const Letter& shaft = *shaft_of(fit.letter.front());
  if (shaft.is_upper) {
    const double most = shaft.deviation[step];
    return {kMillimetre * (most - width), kMillimetre * most};
  }
  const bool is_zero = fit.letter == "k" && fit.grade > kLastOfK;
  const double least = is_zero ? 0 : shaft.deviation[step];
  return {kMillimetre * least, kMillimetre * (least + width)};
}

}  // namespace camlaw::problems

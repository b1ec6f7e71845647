// SPDX-License-Identifier: MIT
#include "tests/sets/nist/nist_models.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace camlaw::sets {
namespace {

using Made = std::unique_ptr<const optim::Residuals>;
using Make = Made (*)(const NistSet&);

// The models as NIST writes them: b[0] is its b1, x[k] predictor k of one observation.

constexpr auto kBennett5 = [](const auto& b, const auto& x) {
  return b[0] * pow(b[1] + x[0], -1.0 / b[2]);
};
constexpr auto kBoxBod = [](const auto& b, const auto& x) {
  return b[0] * (1.0 - exp(-b[1] * x[0]));
};
constexpr auto kChwirut = [](const auto& b, const auto& x) {
  return exp(-b[0] * x[0]) / (b[1] + b[2] * x[0]);
};
constexpr auto kDanWood = [](const auto& b, const auto& x) { return b[0] * pow(x[0], b[1]); };
constexpr auto kEnso = [](const auto& b, const auto& x) {
  const double turn = 2 * std::numbers::pi * x[0];
  const auto second = turn / b[3], third = turn / b[6];
  return b[0] + b[1] * std::cos(turn / 12) + b[2] * std::sin(turn / 12) + b[4] * cos(second) +
         b[5] * sin(second) + b[7] * cos(third) + b[8] * sin(third);
};
constexpr auto kEckerle4 = [](const auto& b, const auto& x) {
  const auto t = (x[0] - b[2]) / b[1];
  return b[0] / b[1] * exp(-0.5 * t * t);
};
constexpr auto kGauss = [](const auto& b, const auto& x) {
  const auto first = (x[0] - b[3]) / b[4], second = (x[0] - b[6]) / b[7];
  return b[0] * exp(-b[1] * x[0]) + b[2] * exp(-first * first) + b[5] * exp(-second * second);
};
constexpr auto kCubics = [](const auto& b, const auto& x) {
  const double t = x[0];
  return (b[0] + t * (b[1] + t * (b[2] + t * b[3]))) / (1.0 + t * (b[4] + t * (b[5] + t * b[6])));
};
constexpr auto kKirby2 = [](const auto& b, const auto& x) {
  const double t = x[0];
  return (b[0] + t * (b[1] + t * b[2])) / (1.0 + t * (b[3] + t * b[4]));
};
constexpr auto kLanczos = [](const auto& b, const auto& x) {
  return b[0] * exp(-b[1] * x[0]) + b[2] * exp(-b[3] * x[0]) + b[4] * exp(-b[5] * x[0]);
};
constexpr auto kMgh09 = [](const auto& b, const auto& x) {
  const double t = x[0];
  return b[0] * (t * t + t * b[1]) / (t * t + t * b[2] + b[3]);
};
constexpr auto kMgh10 = [](const auto& b, const auto& x) {
  return b[0] * exp(b[1] / (x[0] + b[2]));
};
constexpr auto kMgh17 = [](const auto& b, const auto& x) {
  return b[0] + b[1] * exp(-x[0] * b[3]) + b[2] * exp(-x[0] * b[4]);
};
constexpr auto kMisra1b = [](const auto& b, const auto& x) {
  return b[0] * (1.0 - pow(1.0 + b[1] * x[0] / 2.0, -2.0));
};
constexpr auto kMisra1c = [](const auto& b, const auto& x) {
  return b[0] * (1.0 - pow(1.0 + 2.0 * b[1] * x[0], -0.5));
};
constexpr auto kMisra1d = [](const auto& b, const auto& x) {
  return b[0] * b[1] * x[0] / (1.0 + b[1] * x[0]);
};
/// Of the logarithm of y.
constexpr auto kNelson = [](const auto& b, const auto& x) {
  return b[0] - b[1] * x[0] * exp(-b[2] * x[1]);
};
constexpr auto kRat42 = [](const auto& b, const auto& x) {
  return b[0] / (1.0 + exp(b[1] - b[2] * x[0]));
};
constexpr auto kRat43 = [](const auto& b, const auto& x) {
  return b[0] / pow(1.0 + exp(b[1] - b[2] * x[0]), 1.0 / b[3]);
};
constexpr auto kRoszman1 = [](const auto& b, const auto& x) {
  return b[0] - b[1] * x[0] - atan(b[2] / (x[0] - b[3])) / std::numbers::pi;
};

/// Model minus data.
template <auto model>
Made residuals(const NistSet& set) {
  std::vector<double> y = set.y;
  if (set.name == "Nelson") {
    for (double& value : y) value = std::log(value);
  }
  std::vector<std::vector<double>> points(y.size());
  for (const std::vector<double>& predictor : set.x) {
    for (std::size_t i = 0; i < y.size(); ++i) points[i].push_back(predictor[i]);
  }
  const std::size_t n = y.size();
  const auto f = [y = std::move(y), points = std::move(points)](const auto& b, const auto& r) {
    for (std::size_t i = 0; i < y.size(); ++i) r[i] = model(b, points[i]) - y[i];
    return true;
  };
  return std::make_unique<const optim::AutomaticResiduals<decltype(f)>>(n, f);
}

const std::map<std::string, Make>& makers() {
  static const std::map<std::string, Make> all{
      {"Bennett5", residuals<kBennett5>}, {"BoxBOD", residuals<kBoxBod>},
      {"Chwirut1", residuals<kChwirut>},  {"Chwirut2", residuals<kChwirut>},
      {"DanWood", residuals<kDanWood>},   {"ENSO", residuals<kEnso>},
      {"Eckerle4", residuals<kEckerle4>}, {"Gauss1", residuals<kGauss>},
      {"Gauss2", residuals<kGauss>},      {"Gauss3", residuals<kGauss>},
      {"Hahn1", residuals<kCubics>},      {"Kirby2", residuals<kKirby2>},
      {"Lanczos1", residuals<kLanczos>},  {"Lanczos2", residuals<kLanczos>},
      {"Lanczos3", residuals<kLanczos>},  {"MGH09", residuals<kMgh09>},
      {"MGH10", residuals<kMgh10>},       {"MGH17", residuals<kMgh17>},
      {"Misra1a", residuals<kBoxBod>},    {"Misra1b", residuals<kMisra1b>},
      {"Misra1c", residuals<kMisra1c>},   {"Misra1d", residuals<kMisra1d>},
      {"Nelson", residuals<kNelson>},     {"Rat42", residuals<kRat42>},
      {"Rat43", residuals<kRat43>},       {"Roszman1", residuals<kRoszman1>},
      {"Thurber", residuals<kCubics>}};
  return all;
}

}  // namespace

std::unique_ptr<const optim::Residuals> nist_residuals(const NistSet& set) {
  const auto found = makers().find(set.name);
  if (found == makers().end()) {
    throw std::invalid_argument(fmt::format("'{}' is none of NIST's sets", set.name));
  }
  return found->second(set);
}

}  // namespace camlaw::sets

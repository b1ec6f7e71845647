// SPDX-License-Identifier: MIT
#include "machines/model/affine_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "machines/model/affine_row.h"
#include "machines/model/linear_law.h"
#include "machines/model/pulse.h"

namespace camlaw::problems {
namespace {

using optim::Shape;

bool is_polynomial(const LinearLaw& law) {
  return std::all_of(law.parts.begin(), law.parts.end(), [](const auto& parts) {
    return std::all_of(parts.begin(), parts.end(), [](const LinearLaw::Part& part) {
      return part.piece.harmonics.empty() && part.piece.curves.empty();
    });
  });
}

/// Whether no design has a pulse on the curve. A jump is affine in the design too: where neither
/// the own law nor some others have one, none has.
bool has_no_pulse(const CurveParts& parts, const LawBinding& law, const LinearLaw& linear) {
  // A jump hardly vanishes by chance at three designs that differ in all numbers.
  constexpr std::size_t kOthers = 3;
  if (!parts.uses[2] && !parts.uses[3]) return true;
  if (pulse_place(parts.cycle, *linear.law, parts.uses)) return false;
  for (std::size_t n = 0; n < kOthers; ++n) {
    std::vector<double> values = linear.own;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double golden = 0.6180339887498949 * static_cast<double>(n * values.size() + i + 1);
      values[i] += 0.1 * (1 + std::abs(values[i])) * (2 * (golden - std::floor(golden)) - 1);
    }
    const auto other = law.possible_law_of<double>(std::span<const double>(values));
    if (!other || pulse_place(parts.cycle, *other, parts.uses)) return false;
  }
  return true;
}

}  // namespace

/// constant + gain[0] s + gain[1] v + gain[2] a + gain[3] j.
struct AffineCurve::Gains {
  double constant = 0;
  std::array<double, 4> gain{};

  /// For the follower of a stretch: returning, it moves as (1 - s, -v, -a, -j).
  Gains in_stretch(const Stretch& stretch) const {
    Gains result = *this;
    if (!stretch.returning) return result;
    result.constant += result.gain[0];
    for (double& one : result.gain) one = -one;
    return result;
  }
  /// The coefficient of t^k of the motion's part, from those of s, of which there are so many.
  template <class Coefficient>
  double combined(std::size_t k, std::size_t terms, const Coefficient& of_s) const {
    double sum = 0, falling = 1;
    for (std::size_t m = 0; m < 4 && k + m < terms; ++m) {
      if (m > 0) falling *= static_cast<double>(k + m);
      if (gain[m] != 0) sum += gain[m] * falling * of_s(k + m);
    }
    return sum;
  }
};

std::optional<AffineCurve::Gains> AffineCurve::gains_of(const optim::Kernel& point) {
  // An affine formula rounds by a few units of the last place of its terms.
  constexpr double kSame = 1e-12;
  constexpr std::array<double, 4> kSome{0.37, 1.21, -3.7, 17.3};
  const std::array<double, 4> none{};
  std::array<double, 4> elsewhere{};
  Gains gains;
  gains.constant = point.gradient(none, gains.gain);
  const double there = point.gradient(kSome, elsewhere);
  double expected = gains.constant, terms = std::abs(gains.constant);
  for (std::size_t m = 0; m < 4; ++m) {
    const double largest = std::max(std::abs(gains.gain[m]), std::abs(elsewhere[m]));
    if (!(std::abs(gains.gain[m] - elsewhere[m]) <= kSame * largest)) return {};
    expected += gains.gain[m] * kSome[m];
    terms += std::abs(gains.gain[m] * kSome[m]);
  }
  if (!(std::abs(expected - there) <= kSame * terms) || !std::isfinite(terms)) return {};
  return gains;
}

struct AffineCurve::Input {
  std::size_t variable;
  double own;
  const LinearLaw::Part* part;
  int lane;

  /// A law leaves out a power whose coefficient happens to be 0, together with its slopes.
  double slope(std::size_t power) const {
    const auto& polynomial = part->piece.polynomial;
    return power < polynomial.size() ? polynomial[power].v[lane] : 0;
  }
};

std::vector<AffineCurve::Input> AffineCurve::inputs_of(const LawBinding& law,
                                                       const LinearLaw& linear, std::size_t piece) {
  std::vector<Input> inputs;
  for (const LinearLaw::Part& part : linear.parts[piece]) {
    for (std::size_t k = 0; k < part.count; ++k) {
      const int lane = static_cast<int>(k);
      const auto& polynomial = part.piece.polynomial;
      const bool moves = std::any_of(polynomial.begin(), polynomial.end(),
                                     [&](const Dual& c) { return c.v[lane] != 0; });
      if (!moves) continue;
      const std::size_t input = part.inputs[k];
      inputs.push_back({law.variables()[input].variable, linear.own[input], &part, lane});
    }
  }
  std::sort(inputs.begin(), inputs.end(),
            [](const Input& one, const Input& other) { return one.variable < other.variable; });
  return inputs;
}

void AffineCurve::add_section(Section section, const Gains& gains,
                              const std::vector<LinearLaw::Part>& parts,
                              const std::vector<Input>& inputs) {
  const auto longest =
      std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
        return a.piece.polynomial.size() < b.piece.polynomial.size();
      });
  const auto& polynomial = longest->piece.polynomial;
  const std::size_t terms = polynomial.size();
  std::size_t least = 0;  // of the derivatives that count
  while (least < 3 && gains.gain[least] == 0) ++least;
  section.first = constants_.size();
  section.count = terms > least ? terms - least : 1;
  for (const Input& input : inputs) section.inputs.push_back(input.variable);
  std::vector<double> slope_terms(inputs.size(), 0.0);  // |t| is at most 1
  for (std::size_t k = 0; k < section.count; ++k) {
    double constant = gains.combined(k, terms, [&](std::size_t n) { return polynomial[n].a; });
    if (k == 0) constant += gains.constant;
    section.terms += std::abs(constant);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const double slope =
          gains.combined(k, terms, [&](std::size_t power) { return inputs[i].slope(power); });
      section.slopes.push_back(slope);
      slope_terms[i] += std::abs(slope);
      section.terms += std::abs(slope * inputs[i].own);
      constant -= slope * inputs[i].own;
    }
    constants_.push_back(constant);
  }
  for (const double sum : slope_terms) section.slope_terms = std::max(section.slope_terms, sum);
  breaks_.push_back(section.begin);
  sections_.push_back(std::move(section));
}

std::shared_ptr<const AffineCurve> AffineCurve::of(
    const CurveParts& parts, const std::vector<std::size_t>& machine_variables,
    const LawBinding& law, Shape shape) {
  // Machines that vary may be impossible, and a curve is then no number.
  if (shape != Shape::Linear || parts.uses_place || !machine_variables.empty()) return nullptr;
  const LinearLaw* linear = law.linear_law();
  if (linear == nullptr || !linear->law || !is_polynomial(*linear)) return nullptr;
  const auto gains = gains_of(*parts.point);
  if (!gains || !has_no_pulse(parts, law, *linear)) return nullptr;
  auto curve = std::shared_ptr<AffineCurve>(new AffineCurve);
  const auto& pieces = linear->law->pieces();
  for (const Stretch& stretch : parts.cycle.stretches) {
    const Gains own = gains->in_stretch(stretch);
    double begin = stretch.begin;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const double end =
          i + 1 == pieces.size() ? stretch.end : stretch.begin + stretch.length() * pieces[i].end;
      if (!(end > begin)) continue;
      Section section{begin, end, stretch.begin, stretch.length(), pieces[i].origin, 0, 0};
      curve->add_section(std::move(section), own, linear->parts[i], inputs_of(law, *linear, i));
      begin = end;
    }
  }
  curve->breaks_.push_back(curve->sections_.back().end);
  return curve;
}

const AffineCurve::Section& AffineCurve::section_at(optim::Place place) const {
  const auto after =
      std::partition_point(sections_.begin(), sections_.end() - 1, [&](const Section& section) {
        return section.end < place.angle || (section.end == place.angle && !place.from_left);
      });
  return *after;
}

void AffineCurve::slopes_at(const Section& section, double t, std::vector<double>& slopes) {
  const std::size_t inputs = section.inputs.size();
  slopes.assign(inputs, 0.0);
  for (std::size_t k = section.count; k-- > 0;) {
    for (std::size_t i = 0; i < inputs; ++i) {
      slopes[i] = slopes[i] * t + section.slopes[k * inputs + i];
    }
  }
}

optim::Function AffineCurve::at(optim::Place place) const {
  const Section& section = section_at(place);
  const double t = section.t(place.angle);
  const double constant = value_at(section, t, constants_);
  std::vector<double> slopes;
  slopes_at(section, t, slopes);
  std::vector<std::size_t> inputs;
  std::vector<double> kept;
  inputs.reserve(slopes.size());
  kept.reserve(slopes.size());
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (slopes[i] == 0) continue;
    inputs.push_back(section.inputs[i]);
    kept.push_back(slopes[i]);
  }
  return {
      std::move(inputs),
      std::make_shared<AffineRow>(constant, std::move(kept), section.terms, section.slope_terms),
      Shape::Linear};
}

double AffineCurve::largest_change(const std::vector<double>& scales, int places,
                                   double shortest) const {
  const double least = shortest * (breaks_.back() - breaks_.front());
  double largest = 0;
  std::vector<double> slopes;
  for (const Section& section : sections_) {
    if (section.end - section.begin < least) continue;
    for (int i = 0; i < places; ++i) {
      const double angle = section.begin + (section.end - section.begin) * (i + 0.5) / places;
      slopes_at(section, section.t(angle), slopes);
      for (std::size_t k = 0; k < slopes.size(); ++k) {
        const double change = std::abs(slopes[k]) * scales[section.inputs[k]];
        if (std::isfinite(change)) largest = std::max(largest, change);
      }
    }
  }
  return largest;
}

std::vector<double> AffineCurve::coefficients_at(optim::Design x) const {
  std::vector<double> result = constants_;
  for (const Section& section : sections_) {
    const std::size_t inputs = section.inputs.size();
    for (std::size_t k = 0; k < section.count; ++k) {
      double sum = result[section.first + k];
      for (std::size_t i = 0; i < inputs; ++i) {
        sum += section.slopes[k * inputs + i] * x[section.inputs[i]];
      }
      result[section.first + k] = sum;
    }
  }
  return result;
}

double AffineCurve::value_at(const Section& section, double t,
                             const std::vector<double>& coefficients) const {
  double value = 0;
  for (std::size_t k = section.count; k-- > 0;) value = value * t + coefficients[section.first + k];
  return value;
}

double AffineCurve::largest(optim::Design x) const {
  const std::vector<double> coefficients = coefficients_at(x);
  double largest = 0;
  for (const Section& section : sections_) {
    const int steps = section.count <= 2 ? 1 : 8;  // what is straight is largest at an end
    for (int i = 0; i <= steps; ++i) {
      const double angle = section.begin + (section.end - section.begin) * i / steps;
      const double t = section.t(angle);
      const double value = value_at(section, t, coefficients);
      if (std::isnan(value)) return value;
      largest = std::max(largest, std::abs(value));
    }
  }
  return largest;
}

bool AffineCurve::may_rest(double bound, optim::Design x) const {
  constexpr double kNear = 1e-9;  // more than rests_of() takes for rounding
  const std::vector<double> coefficients = coefficients_at(x);
  const double whole = std::max(std::abs(bound), largest(x));
  std::vector<double> slopes;
  for (const Section& section : sections_) {
    for (const double angle : {section.begin, section.end}) {
      const double t = section.t(angle);
      const double value = value_at(section, t, coefficients);
      if (std::abs(value - bound) > kNear * whole) continue;
      slopes_at(section, t, slopes);
      double moves = 0, terms = 0;  // at this place; by the coefficients of the section
      for (std::size_t i = 0; i < slopes.size(); ++i) {
        moves = std::max(moves, std::abs(slopes[i]));
        for (std::size_t k = 0; k < section.count; ++k) {
          const double power =
              std::pow(section.end - section.begin, k) / std::pow(section.length, k);
          terms = std::max(terms, std::abs(section.slopes[k * slopes.size() + i]) * power);
        }
      }
      if (moves <= kNear * terms) return true;
    }
  }
  return false;
}

/// The curve of one design.
class AffineTrace final : public optim::Trace {
 public:
  AffineTrace(std::shared_ptr<const AffineCurve> curve, optim::Design x,
              std::function<std::unique_ptr<optim::Trace>()> whole)
      : curve_(std::move(curve)),
        whole_(std::move(whole)),
        coefficients_(curve_->coefficients_at(x)) {}

  std::vector<double> breaks() const override { return curve_->breaks_; }
  std::array<double, 3> at(optim::Place place) const override {
    return in(curve_->section_at(place), place.angle);
  }
  std::vector<std::array<double, 3>> even(double from, double to, int count) const override {
    const auto& section = curve_->section_at({std::midpoint(from, to)});
    std::vector<std::array<double, 3>> result;
    result.reserve(static_cast<std::size_t>(count) + 1);
    for (int i = 0; i <= count; ++i) {
      result.push_back(in(section, optim::even_place(from, to, count, i).angle));
    }
    return result;
  }
  optim::Bounds enclose(double from, double to) const override { return whole().enclose(from, to); }
  std::array<optim::Bounds, 3> expand(double from, double to) const override {
    return whole().expand(from, to);
  }

 private:
  std::array<double, 3> in(const AffineCurve::Section& section, double angle) const {
    const double t = section.t(angle);
    double value = 0, slope = 0, bend = 0;
    for (std::size_t k = section.count; k-- > 0;) {
      bend = bend * t + slope;
      slope = slope * t + value;
      value = value * t + coefficients_[section.first + k];
    }
    const double rate = 1 / section.length;
    return {value, slope * rate, 2 * bend * rate * rate};
  }
  const optim::Trace& whole() const {
    if (!made_) made_ = whole_();
    return *made_;
  }

  std::shared_ptr<const AffineCurve> curve_;
  std::function<std::unique_ptr<optim::Trace>()> whole_;
  std::vector<double> coefficients_;
  mutable std::unique_ptr<optim::Trace> made_;
};

std::unique_ptr<optim::Trace> AffineCurve::trace(
    optim::Design x, std::function<std::unique_ptr<optim::Trace>()> whole) const {
  return std::make_unique<AffineTrace>(shared_from_this(), x, std::move(whole));
}

}  // namespace camlaw::problems

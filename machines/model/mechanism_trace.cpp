// SPDX-License-Identifier: MIT
#include "machines/model/mechanism_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "machines/model/enclosed.h"
#include "machines/model/jumps.h"
#include "machines/model/not_a_number.h"
#include "machines/model/pulse.h"
#include "machines/model/rest_velocity.h"

namespace camlaw::problems {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

MechanismTrace::MechanismTrace(Cycle cycle, const std::array<bool, 4>& uses,
                               std::optional<Law<double>> law,
                               std::function<std::optional<Law<Interval>>()> enclosing,
                               std::unique_ptr<const CurveFormula> formula,
                               const std::optional<std::vector<double>>& jumps)
    : cycle_(std::move(cycle)),
      law_(std::move(law)),
      enclosing_(std::move(enclosing)),
      formula_(std::move(formula)),
      uses_displacement_(uses[0]),
      may_jump_(jumps.has_value()) {
  for (std::size_t i = 0; i < cycle_.stretches.size(); ++i) add_sections(i);
  if (law_ && uses[1]) still_ = velocity_rounding(*law_);
  if (law_) pulse_ = pulse_place(cycle_, *law_, uses);
  if (law_ && may_jump_) keep_jumps(*jumps);
}

/// Where what is chosen between differs, and no less so the nearer one looks: the contact stress of
/// a follower that changes its flank goes through 0 as a root does.
void MechanismTrace::keep_jumps(const std::vector<double>& places) {
  // A jump stays as it is a hundred millionth of the stretch away. A root falls to a hundredth over
  // that, and a cubic root to a twentieth; 0.7 tells them apart.
  constexpr double kSame = 1e-9, kFarther = 1e4 * kBesideJump, kStays = 0.7;
  for (const double angle : places) {
    const double before = at({angle, true})[0], behind = at({angle})[0];
    const double size = std::max(std::abs(before), std::abs(behind));
    if (!(std::abs(before - behind) > kSame * size)) continue;
    const double far = kFarther * cycle_.stretch_at({angle}).length();
    const double around = at({angle - far})[0] - at({angle + far})[0];
    if (std::abs(before - behind) > kStays * std::abs(around)) jumps_.push_back(angle);
  }
}

const std::vector<PieceExpander>& MechanismTrace::expanders() const {
  if (enclosing_) {
    const auto law = law_ ? enclosing_() : std::nullopt;
    if (law && law->pieces().size() == law_->pieces().size()) {
      for (const auto& piece : law->pieces()) expanders_.emplace_back(piece);
    }
    enclosing_ = {};
  }
  return expanders_;
}

void MechanismTrace::add_sections(std::size_t index) {
  const Stretch& stretch = cycle_.stretches[index];
  const std::size_t pieces = law_ ? law_->pieces().size() : 1;
  double begin = stretch.begin;
  for (std::size_t i = 0; i < pieces; ++i) {
    const double end =
        i + 1 == pieces ? stretch.end : stretch.begin + stretch.length() * law_->pieces()[i].end;
    if (end > begin) sections_.push_back({begin, end, index, i});
    begin = end;
  }
}

std::vector<double> MechanismTrace::breaks() const {
  std::vector<double> result;
  for (const Section& section : sections_) result.push_back(section.begin);
  result.push_back(sections_.back().end);
  const auto sections = static_cast<std::ptrdiff_t>(result.size());
  result.insert(result.end(), jumps_.begin(), jumps_.end());
  std::inplace_merge(result.begin(), result.begin() + sections, result.end());
  return result;
}

const MechanismTrace::Section& MechanismTrace::section_at(optim::Place place) const {
  const auto after =
      std::partition_point(sections_.begin(), sections_.end() - 1, [&](const Section& section) {
        return section.end < place.angle || (section.end == place.angle && !place.from_left);
      });
  return *after;
}

/// Of a pulse at one end of the cycle the other end shows the other side.
std::optional<double> MechanismTrace::pulse_at(optim::Place place) const {
  if (!pulse_) return {};
  const double begin = sections_.front().begin, end = sections_.back().end;
  const bool at_ends = *pulse_ == begin || *pulse_ == end;
  const bool there =
      place.angle == *pulse_ || (at_ends && (place.angle == begin || place.angle == end));
  if (!there) return {};
  if (!formula_->follows_pulse()) return kNaN;
  return place.from_left ? -kInfinity : kInfinity;
}

std::array<double, 3> MechanismTrace::at(optim::Place place) const {
  if (!law_) return {kNaN, kNaN, kNaN};
  if (const auto pulse = pulse_at(place)) return {*pulse, 0, 0};
  const Section& section = section_at(place);
  const Stretch& stretch = cycle_.stretches[section.stretch];
  const double x = law_place(stretch, place, may_jump_).x;
  const Piece<double>& piece = law_->pieces()[section.piece];
  auto d = derivatives<6>(piece, x);
  d[1] = velocity_from_within(d[1], piece, x, still_);
  d[0] = onto_ends(d[0]);
  if (may_jump_) d[0] = displacement_from_within(d[0], piece, x);
  const auto f = formula_->plain(
      {follower_motion(stretch, motion_series<3>(d)), place_series<3, double>(section, x)});
  const double rate = 1 / stretch.length();
  return {without_traces(f.c[0]), f.c[1] * rate, 2 * f.c[2] * rate * rate};
}

std::optional<double> MechanismTrace::place_inside(const Section& section,
                                                   optim::Place place) const {
  if (!(place.angle > section.begin && place.angle < section.end) || pulse_at(place)) return {};
  const double x = law_place(cycle_.stretches[section.stretch], place, may_jump_).x;
  const auto& piece = law_->pieces()[section.piece];
  return x > piece.begin && x < piece.end ? std::optional(x) : std::nullopt;
}

/// Where pieces meet the law has two sides, and its loops over many points know one.
std::vector<double> MechanismTrace::values(std::span<const optim::Place> places) const {
  std::vector<double> result(places.size(), kNaN);
  if (!law_) return result;
  std::vector<std::size_t> inside;
  std::vector<const Section*> sections;
  PlaceRows rows;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Section& section = section_at(places[i]);
    if (const auto x = place_inside(section, places[i])) {
      inside.push_back(i);
      sections.push_back(&section);
      rows.x.push_back(*x);
    } else {
      result[i] = at(places[i])[0];
    }
  }
  for (auto* row : {&rows.s, &rows.v, &rows.a, &rows.j}) row->resize(inside.size());
  evaluate(*law_, rows.x, {rows.s, rows.v, rows.a, rows.j});
  for (std::size_t k = 0; k < inside.size(); ++k) {
    const auto& piece = law_->pieces()[sections[k]->piece];
    const double v = velocity_from_within(rows.v[k], piece, rows.x[k], still_);
    double s = onto_ends(rows.s[k]);
    if (may_jump_) s = displacement_from_within(s, piece, rows.x[k]);
    const Motion<double> law{s, v, rows.a[k], rows.j[k]};
    const auto m = follower_motion(cycle_.stretches[sections[k]->stretch], law);
    rows.s[k] = m.s, rows.v[k] = m.v, rows.a[k] = m.a, rows.j[k] = m.j;
  }
  const std::vector<double> values = formula_->values(rows);
  for (std::size_t k = 0; k < inside.size(); ++k) result[inside[k]] = without_traces(values[k]);
  return result;
}

/// The x of a range of places. At the section's ends it reaches over the break as far as that is
/// not known exactly.
Interval MechanismTrace::law_range(const Section& section, double from, double to) const {
  const Stretch& stretch = cycle_.stretches[section.stretch];
  const auto& piece = expanders_[section.piece].piece();
  const Interval begin(stretch.begin);
  const Interval x = (Interval(from, to) - begin) / (Interval(stretch.end) - begin);
  const double low = from <= section.begin ? std::min(x.lower(), piece.begin.lower()) : x.lower();
  const double high = to >= section.end ? std::max(x.upper(), piece.end.upper()) : x.upper();
  return {std::max(low, 0.0), std::min(high, 1.0)};
}

namespace {

/// What s may be, moved onto the ends where it lies beyond them (docs/theory.md, (R4)): there its
/// slope is 0, and where it comes there the slope jumps.
template <std::size_t N>
Series<Interval, N> clamped(Series<Interval, N> s, const Interval& ends) {
  const auto within = [&](double x) { return std::clamp(x, ends.lower(), ends.upper()); };
  s.c[0] = Interval(within(s.c[0].lower()), within(s.c[0].upper()));
  if constexpr (N > 1) s.c[1] = boost::numeric::hull(s.c[1], Interval(0.0));
  for (std::size_t k = 2; k < N; ++k) s.c[k] = Interval::whole();
  return s;
}

}  // namespace

template <std::size_t N>
Series<Interval, N> MechanismTrace::over_motion(const Section& section,
                                                const Expansion::Derivatives& motion,
                                                const Interval& x, const Interval& ends) const {
  auto series = motion_series<N>(motion);
  Interval& s = series.s.c[0];
  if (s.upper() < 0 && s.upper() >= -kBeyondEnds) s = {s.lower(), 0};
  if (s.lower() > 1 && s.lower() <= 1 + kBeyondEnds) s = {1, s.upper()};
  if (!boost::numeric::subset(s, ends)) series.s = clamped(series.s, ends);
  return formula_->enclosed(
      {follower_motion(cycle_.stretches[section.stretch], series), place_series<N>(section, x)});
}

Interval MechanismTrace::value_at(const Section& section, double x, const Interval& ends) const {
  return over_motion<1>(section, expanders_[section.piece](Interval(x)).at, Interval(x), ends).c[0];
}

/// By halving the law's pieces until s is enclosed as no farther beyond an end than rounding.
const Interval& MechanismTrace::proved_ends() const {
  if (ends_) return *ends_;
  constexpr int kMostBoxes = 4000;  // a rest takes some twenty
  int boxes = 0;
  bool low = true, high = true;
  for (const PieceExpander& expander : expanders_) {
    const auto& piece = expander.piece();
    std::vector<Interval> open{Interval(piece.begin.lower(), piece.end.upper())};
    while (!open.empty() && (low || high)) {
      const Interval x = open.back();
      open.pop_back();
      const Expansion e = expander(x);
      const auto at_end = [&](double place) { return expander(Interval(place)).at[0]; };
      const optim::Bounds s = enclosed(
          motion_series<3>(e.over).s, e.radius, [&] { return at_end(x.lower()); },
          [&] { return at_end(x.upper()); }, [&] { return motion_series<2>(e.at).s; });
      const bool is_low = !low || s.lower >= -kBeyondEnds;
      const bool is_high = !high || s.upper <= 1 + kBeyondEnds;
      if (is_low && is_high) continue;
      const double middle = std::midpoint(x.lower(), x.upper());
      const bool divides = x.lower() < middle && middle < x.upper() && ++boxes <= kMostBoxes;
      low = low && (is_low || (divides && e.at[0].upper() >= -kBeyondEnds));
      high = high && (is_high || (divides && e.at[0].lower() <= 1 + kBeyondEnds));
      if (!divides) continue;
      open.emplace_back(middle, x.upper());
      open.emplace_back(x.lower(), middle);
    }
  }
  return ends_.emplace(low ? 0 : -kInfinity, high ? 1 : kInfinity);
}

std::string MechanismTrace::why_unbounded() const {
  if (!pulse_) return {};
  return fmt::format("it has an impulse at {:.6g}{}, where the motion jumps", *pulse_,
                     cycle_.unit == "1" ? "" : " " + cycle_.unit);
}

std::optional<MechanismTrace::Stretched> MechanismTrace::stretched(double from, double to) const {
  if (expanders().empty() || pulse_at({from}) || pulse_at({to, true})) return {};
  const Section& section = section_at({std::midpoint(from, to)});
  const Interval x = law_range(section, from, to);
  Stretched result{section, x, expanders_[section.piece](x), {}};
  result.over = over_motion<3>(section, result.motion.over, x, result.ends);
  // Beyond an end a formula may have no value, where the law never is.
  const Interval& s = result.motion.over[0];
  const Interval& value = result.over.c[0];
  const bool is_bounded = std::isfinite(value.lower()) && std::isfinite(value.upper());
  if (is_bounded || !uses_displacement_ || (s.lower() >= 0 && s.upper() <= 1)) return result;
  result.ends = proved_ends();
  result.over = over_motion<3>(section, result.motion.over, x, result.ends);
  return result;
}

optim::Bounds MechanismTrace::enclose(double from, double to) const {
  const auto known = stretched(from, to);
  if (!known) return {};
  return enclosed(
      known->over, known->motion.radius,
      [&] { return value_at(known->section, known->x.lower(), known->ends); },
      [&] { return value_at(known->section, known->x.upper(), known->ends); },
      [&] {
        return over_motion<2>(known->section, known->motion.at, Interval(known->motion.middle),
                              known->ends);
      });
}

std::array<optim::Bounds, 3> MechanismTrace::expand(double from, double to) const {
  const auto known = stretched(from, to);
  if (!known) return {};
  const Stretch& stretch = cycle_.stretches[known->section.stretch];
  return by_place(known->over, Interval(stretch.end) - Interval(stretch.begin));
}

}  // namespace camlaw::problems

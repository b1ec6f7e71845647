// SPDX-License-Identifier: MIT
#include "python/bindings/curve_blocks.h"

#include <algorithm>

#include "kinematics/peaks.h"
#include "machines/model/jumps.h"
#include "machines/model/law_binding.h"
#include "machines/model/pulse.h"
#include "machines/model/recorded_response.h"
#include "machines/model/rest_velocity.h"

namespace camlaw::python {
namespace {

using problems::Binding, problems::MechanismResponse;

std::vector<problems::Recorded> records_of(const Binding& binding,
                                           const std::vector<const MechanismResponse*>& curves) {
  std::vector<problems::Recorded> records;
  for (const MechanismResponse* curve : curves) {
    records.push_back(problems::recorded_for(binding, curve->write, problems::kOfPlace, {}));
  }
  return records;
}

std::vector<Formula> formulas_of(const std::vector<problems::Recorded>& records) {
  std::vector<Formula> formulas;
  for (const problems::Recorded& record : records) formulas.push_back(record.formula);
  return formulas;
}

/// Every parameter of the machine of a design.
std::vector<double> parameters_at(const Binding& binding, std::span<const double> arguments) {
  std::vector<double> all = binding.constants;
  for (std::size_t k = 0; k < arguments.size(); ++k) all[binding.parameters[k]] = arguments[k];
  return all;
}

bool same_cycle(const problems::Cycle& a, const problems::Cycle& b) {
  return a.unit == b.unit && std::equal(a.stretches.begin(), a.stretches.end(), b.stretches.begin(),
                                        b.stretches.end(), [](const auto& one, const auto& other) {
                                          return one.begin == other.begin && one.end == other.end &&
                                                 one.returning == other.returning;
                                        });
}

}  // namespace

bool CurveBlocks::takes(const MechanismResponse& response) {
  return response.curve && response.write && response.cycle && !response.turn && !response.domain &&
         response.inner.empty() && !response.cam && response.held.empty();
}

std::unique_ptr<const CurveBlocks> CurveBlocks::of(
    const Binding& binding, const std::vector<const MechanismResponse*>& curves) {
  if (curves.empty() || !binding.law || !binding.law->variables().empty()) return nullptr;
  const auto law = binding.law->member().possible_law();
  if (!law) return nullptr;
  const bool one_cycle = std::all_of(curves.begin(), curves.end(), [&](const auto* curve) {
    return same_cycle(*curve->cycle, *curves.front()->cycle);
  });
  const bool pulses =
      problems::pulse_place(*curves.front()->cycle, *law, {true, true, true, true}).has_value();
  if (pulses || !one_cycle) return nullptr;
  return std::unique_ptr<const CurveBlocks>(new CurveBlocks(binding, *law, curves));
}

CurveBlocks::CurveBlocks(const Binding& binding, Law<double> law,
                         const std::vector<const MechanismResponse*>& curves)
    : binding_(binding),
      cycle_(*curves.front()->cycle),
      law_(std::move(law)),
      places_(breaks_of(cycle_, law_)),
      records_(records_of(binding, curves)),
      blocks_(formulas_of(records_), binding.parameters.size()) {
  for (const MechanismResponse* curve : curves) possible_.push_back(curve->is_possible);
  for (std::size_t i = 0; i < cycle_.stretches.size(); ++i) {
    for (std::size_t piece = 0; piece < law_.pieces().size(); ++piece) {
      sections_.push_back({i, piece});
    }
  }
  add_rows();
  const std::vector<double> anything(binding.parameters.size(), 1.0);
  for (const problems::Recorded& record : records_) {
    jumps_.emplace_back(record);
    const problems::FormulaJumps& own = jumps_.back();
    always_jumps_.push_back(own.possible() && own.moved_by().empty() &&
                            !own.places(cycle_, law_, anything).empty());
  }
}

bool CurveBlocks::jumps(std::size_t curve, std::span<const double> arguments) const {
  const problems::FormulaJumps& own = jumps_[curve];
  if (own.moved_by().empty()) return always_jumps_[curve];
  return !own.places(cycle_, law_, arguments).empty();
}

std::vector<double> CurveBlocks::breaks_of(const problems::Cycle& cycle, const Law<double>& law) {
  std::vector<double> breaks{cycle.stretches.front().begin};
  for (const problems::Stretch& stretch : cycle.stretches) {
    for (std::size_t i = 0; i + 1 < law.pieces().size(); ++i) {
      breaks.push_back(stretch.begin + stretch.length() * law.pieces()[i].end);
    }
    breaks.push_back(stretch.end);
  }
  return breaks;
}

problems::PlaceSeries<double, 3> CurveBlocks::place_at(optim::Place place,
                                                       std::size_t section) const {
  const problems::Stretch& stretch = cycle_.stretches[sections_[section].stretch];
  const double x = problems::law_place(stretch, place).x;
  const auto d = derivatives<6>(law_.pieces()[sections_[section].piece], x);
  const problems::Cycle::Part part = cycle_.part_of(stretch);
  Series<double, 3> in_cycle(part.at(x));
  in_cycle.c[1] = part.slope<double>();
  const auto motion = problems::follower_motion(stretch, problems::motion_series<3>(d));
  return {problems::onto_ends(motion), in_cycle};
}

void CurveBlocks::add_rows() {
  for (std::size_t k = 0; k + 1 < places_.begins.size(); ++k) {
    for (std::size_t i = places_.begins[k]; i < places_.begins[k + 1]; ++i) {
      const auto [motion, x] = place_at(places_.places[i], k);
      rows_.s.push_back(motion.s.c[0]);
      rows_.v.push_back(motion.v.c[0]);
      rows_.a.push_back(motion.a.c[0]);
      rows_.j.push_back(motion.j.c[0]);
      rows_.x.push_back(x.c[0]);
    }
  }
}

std::optional<CurveBlocks::At> CurveBlocks::at(optim::Design x) const {
  At result;
  result.blocks_ = this;
  for (const std::size_t variable : binding_.variables) {
    if (x[variable] == 0) return std::nullopt;
    result.arguments_.push_back(x[variable]);
  }
  const std::vector<double> all = parameters_at(binding_, result.arguments_);
  for (const problems::IsPossible& possible : possible_) {
    result.possible_.push_back(!possible || possible(all));
  }
  result.jumps_.resize(records_.size());
  result.values_.assign(records_.size(), std::vector<double>(places_.places.size()));
  std::vector<std::span<double>> values(result.values_.begin(), result.values_.end());
  const std::vector<std::span<const double>> rows{rows_.s, rows_.v, rows_.a, rows_.j, rows_.x};
  blocks_(result.arguments_, rows, values);
  return result;
}

std::optional<double> CurveBlocks::At::extreme(std::size_t curve, optim::Part part) const {
  if (!possible_[curve]) return std::nan("");
  std::optional<bool>& jumps = jumps_[curve];
  if (!jumps) jumps = blocks_->jumps(curve, arguments_);
  if (*jumps) return {};
  const FormulaAlong<double> formula(blocks_->records_[curve].formula, arguments_);
  const auto derivatives = [&](optim::Place place, std::size_t section) {
    const auto [motion, x] = blocks_->place_at(place, section);
    const std::array others{motion.s, motion.v, motion.a, motion.j, x};
    const Series<double, 3> f = formula(std::span<const Series<double, 3>>(others));
    const double rate = 1 / blocks_->cycle_.stretches[blocks_->sections_[section].stretch].length();
    return std::array{f.c[0], f.c[1] * rate, 2 * f.c[2] * rate * rate};
  };
  return Summits(blocks_->places_, values_[curve], derivatives).extreme(part);
}

}  // namespace camlaw::python

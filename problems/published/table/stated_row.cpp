// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "machines/model/recorded_response.h"
#include "machines/registry.h"
#include "numerics/formula/expression.h"
#include "numerics/text/names.h"
#include "numerics/text/units.h"
#include "optim/problem/deadline.h"
#include "problems/published/table/stated_model.h"
#include "problems/statement/curve_places.h"
#include "problems/statement/law_names.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

/// What the rows of a stated table are made of, before any hypothesis.
namespace camlaw::problems::stated {
namespace {

using optim::Part;

Entry text_entry(const Entry& like, const std::string& key, const std::string& text) {
  Entry entry = like;
  entry.items.clear();
  entry.kind = Entry::Kind::Text;
  entry.key = key;
  entry.text = text;
  return entry;
}

bool is_moved_by_law(const Entry& file) {
  if (const Entry* name = find(file, "mechanism")) {
    const std::string& text = text_of(*name);
    return located(*name, [&] { return find_mechanism(text).moved_by == MovedBy::Law; });
  }
  const Entry* machine = find(file, "machine");
  const Entry* moved_by = machine == nullptr ? nullptr : find(*machine, "moved_by");
  return moved_by != nullptr && moved_by->text == "law";
}

/// The file as a problem's: a machine with its sizes, and what moves it. Where rows name their laws
/// it needs none.
Entry problem_part(const StatedTable& table, const StatedRow& row) {
  Entry part = table.file;
  std::erase_if(part.items, [&](const Entry& e) {
    const bool is_machine = e.key == "mechanism" || e.key == "machine";
    if (is_machine && !row.mechanism.empty()) return true;
    return !is_machine && e.key != "responses" && e.key != "constants" && e.key != "law" &&
           e.key != "program";
  });
  if (!row.mechanism.empty()) {
    part.items.push_back(text_entry(*find(row.where, "mechanism"), "mechanism", row.mechanism));
  }
  if (is_moved_by_law(part) && find(part, "law") == nullptr) {
    Entry law = part;
    law.key = law.path = "law";
    law.items = {text_entry(part, "name", "constant-velocity")};
    part.items.push_back(std::move(law));
  }
  return part;
}

/// A curve's formula and cycle, where it follows the motion by one.
std::optional<SampledCurve> sampled_curve(const ProblemStatement& problem,
                                          const MechanismResponse& curve) {
  if (!curve.write || !curve.cycle || curve.turn || !curve.held.empty()) return {};
  return SampledCurve{whole_formula(curve.write, problem.constants.size(), kOfPlace), *curve.cycle};
}

/// The curve and the part of it that a formula holds; null of another number.
std::pair<const MechanismResponse*, Part> held_peak(const Mechanism& mechanism,
                                                    const InnerNumber& inner) {
  for (const MechanismResponse& curve : mechanism.responses) {
    if (!curve.curve) continue;
    for (const Part part : {Part::Highest, Part::Lowest, Part::Magnitude}) {
      if (part_name(part, curve.name) == inner.name) return {&curve, part};
    }
  }
  return {nullptr, Part::Value};
}

/// A number that a formula holds as a whole.
LookedUp held_number(const ProblemStatement& problem, const MechanismResponse& response,
                     const InnerNumber& inner) {
  LookedUp held{.name = {},
                .inner = inner,
                .place = {},
                .sampled = {},
                .uses = inner.uses,
                .sees_law = response.sees_law};
  const auto [curve, part] = held_peak(*problem.mechanism, inner);
  if (curve == nullptr) return held;
  held.sampled = sampled_curve(problem, *curve);
  held.name.part = part;
  held.sees_law = curve->sees_law;
  return held;
}

/// A curve is compared at a place or by a part of it, a number without either.
void check_place(const StatedRow& row, const ResponseName& name, const Entry& where) {
  const bool is_whole_curve = name.response->curve && name.part == Part::Value;
  if (is_whole_curve && !row.at) {
    refuse(where, fmt::format("{0} is a curve over the cycle; write \"peak {0}\", \"highest {0}\" "
                              "or \"lowest {0}\", or give the place, at = \"30 {1}\"",
                              name.response->name, name.response->along));
  }
  if (row.at && !is_whole_curve) {
    refuse(*find(row.where, "at"), name.name + " is a number, which has no place on the cycle");
  }
}

/// Refuses a place that the curve does not have.
void check_within(double place, const MechanismResponse& curve) {
  const std::optional<CurvePlaces> all = places_of(curve);
  if (!all) return;  // what it runs over differs by design
  if (const std::string why = why_outside(place, *all); !why.empty()) {
    throw std::invalid_argument(why);
  }
}

/// From the response's unit into that of the print.
void set_unit(RowResponse& response, PrintedValue& printed, const Entry& where) {
  if (printed.unit.empty()) printed.unit = response.name.unit;
  if (printed.unit == response.name.unit) return;
  located(where, [&] {
    const double one = unit_as_written(printed.unit, response.name.unit);
    if (!(one > 0)) throw std::invalid_argument(printed.unit + " is not a unit");
    response.factor = 1 / one;
  });
}

}  // namespace

std::string name_of_setting(const std::string& setting) {
  return std::string(trimmed(std::string_view(setting).substr(0, setting.find('='))));
}

bool is_about(const StatedHypothesis& hypothesis, const std::string& id) {
  if (hypothesis.rows.empty()) return true;
  return std::any_of(hypothesis.rows.begin(), hypothesis.rows.end(), [&](const std::string& text) {
    const std::string_view wanted = text;
    return wanted.ends_with('*') ? id.starts_with(wanted.substr(0, wanted.size() - 1))
                                 : id == wanted;
  });
}

std::size_t Model::id_of(const std::string& mechanism, const std::string& name) {
  return ids_.emplace(mechanism + "|" + name, ids_.size()).first->second;
}

const ProblemStatement& Model::base_of(const StatedRow& row) {
  const auto known = bases_.find(row.mechanism);
  if (known != bases_.end()) return known->second;
  const Entry part = problem_part(table_, row);
  ProblemStatement problem;
  problem.source = table_.file.place;
  problem.title = table_.title;
  FixedNames fixed;
  read_mechanism(part, problem);
  read_motion(part, problem, fixed);
  if (problem.laws.size() > 1) {
    refuse(*find(part, "law"), "it names several laws; a value has one, which it may name itself");
  }
  problem.stop = stop_;
  return bases_.emplace(row.mechanism, std::move(problem)).first->second;
}

bool Model::is_law_setting(const RowModel& model, const std::string& setting) const {
  const std::string name = name_of_setting(setting);
  const auto& parameters = model.problem->mechanism->parameters;
  return std::none_of(parameters.begin(), parameters.end(), [&](const MechanismParameter& p) {
    return p.name == name || p.symbol == name;
  });
}

RowResponse Model::make_response_of(const RowModel& model, const std::string& name,
                                    const Entry& where) {
  const ProblemStatement& problem = *model.problem;
  const Mechanism& mechanism = *problem.mechanism;
  const std::string& of = model.row->mechanism;
  RowResponse result;
  result.name = located(where, [&] { return find_response(mechanism, name); });
  const MechanismResponse* response = result.name.response;
  if (response == nullptr) {
    result.uses = {result.name.parameter};
    result.formula = Formula::record(problem.constants.size(), [&](std::span<const Expression> u) {
      return u[result.name.parameter];
    });
    return result;
  }
  result.uses = united({response->uses, response->possible_by.parameters});
  result.sees_law = response->sees_law;
  check_place(*model.row, result.name, where);
  if (!response->curve && response->write) {
    result.formula =
        whole_formula(response->write, problem.constants.size(), response->inner.size());
    for (const InnerNumber& inner : response->inner) {
      result.numbers.push_back(held_number(problem, *response, inner));
      result.numbers.back().id = id_of(of, inner.name);
      result.has_peak = result.has_peak || result.numbers.back().name.part != Part::Value;
    }
    return result;
  }
  LookedUp whole{.name = result.name,
                 .inner = {},
                 .place = {},
                 .sampled = {},
                 .uses = result.uses,
                 .sees_law = result.sees_law,
                 .id = id_of(of, result.name.name + (model.row->at ? "@" + *model.row->at : ""))};
  if (model.row->at) {
    const Entry& at = *find(model.row->where, "at");
    whole.place = optim::Place{located(at, [&] {
      const double place = parse_quantity(*model.row->at, response->along, response->along, "at");
      check_within(place, *response);
      return place;
    })};
  } else if (response->curve) {
    whole.sampled = sampled_curve(problem, *response);
    result.has_peak = true;
  }
  result.numbers.push_back(std::move(whole));
  return result;
}

RowModel Model::make_row(const StatedRow& row) {
  RowModel model;
  model.row = &row;
  auto problem = std::make_shared<ProblemStatement>(base_of(row));
  model.problem = problem;
  for (const std::string& setting : row.set) {
    if (is_law_setting(model, setting)) model.law_settings.push_back(setting);
  }
  std::vector<std::string> of_machine = row.set;
  std::erase_if(of_machine, [&](const std::string& s) { return is_law_setting(model, s); });
  if (!of_machine.empty()) {
    located(*find(row.where, "set"), [&] { set_values(*problem, of_machine); });
  }
  model.responses.push_back(make_response_of(model, row.response, *find(row.where, "response")));
  return model;
}

Model::Model(const StatedTable& table, const std::atomic<bool>* stop) : table_(table), stop_(stop) {
  for (const StatedRow& row : table_.rows) {
    if (stop_ != nullptr) optim::Deadline({}, stop_).check();
    RowModel model = make_row(row);
    for (std::size_t h = 0; h < table_.hypotheses.size(); ++h) {
      if (is_about(table_.hypotheses[h], row.printed.id)) add_hypothesis(model, h);
    }
    complete(model);
    if (row.law.empty() && model.laws_by == kNone && !model.law_settings.empty()) {
      refuse(*find(row.where, "set"),
             fmt::format("'{}' sets neither a parameter of the machine nor one of a law",
                         model.law_settings.front()));
    }
    const bool is_unstated = model.laws_by != kNone && table_.hypotheses[model.laws_by].unstated;
    if (!row.law.empty() && !is_unstated) law_of(model, {});
    rows_.push_back(std::move(model));
  }
  for (std::size_t h = 0; h < table_.hypotheses.size(); ++h) {
    const auto depends = [h](const RowModel& model) {
      return std::find(model.depends.begin(), model.depends.end(), h) != model.depends.end();
    };
    if (std::any_of(rows_.begin(), rows_.end(), depends)) continue;
    refuse(table_.hypotheses[h].where, "it changes none of the values");
  }
}

void Model::complete(RowModel& model) {
  PrintedValue printed = model.row->printed;
  for (RowResponse& response : model.responses) {
    set_unit(response, printed, *find(model.row->where, "printed"));
  }
  model.unit = printed.unit;
}

}  // namespace camlaw::problems::stated

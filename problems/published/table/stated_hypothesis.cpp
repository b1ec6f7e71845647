// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "problems/published/table/stated_model.h"
#include "problems/statement/parameters.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

/// What the hypotheses of a stated table change in its rows.
namespace camlaw::problems::stated {
namespace {

/// Two hypotheses that change the same would hide one another.
void check_free(const StatedTable& table, std::size_t by, std::size_t h, const RowModel& model,
                const std::string& what) {
  if (by == kNone || by == h) return;
  refuse(table.hypotheses[h].where,
         fmt::format("it changes {} of the value '{}', as {} does; join the two, or say with rows "
                     "which values each is about",
                     what, model.row->printed.id, table.hypotheses[by].where.path));
}

bool any_uses(const RowModel& model, std::size_t parameter) {
  return std::any_of(model.responses.begin(), model.responses.end(),
                     [&](const RowResponse& r) { return r.uses.holds(parameter); });
}

bool any_sees_law(const RowModel& model) {
  return std::any_of(model.responses.begin(), model.responses.end(),
                     [](const RowResponse& r) { return r.sees_law; });
}

}  // namespace

const Overrides& Model::machine_settings(const RowModel& model, std::size_t h, std::size_t k) {
  const auto key = std::pair(model.row->mechanism, std::pair(h, k));
  const auto known = settings_.find(key);
  if (known != settings_.end()) return known->second;
  const StatedHypothesis& hypothesis = table_.hypotheses[h];
  ProblemStatement problem = bases_.at(model.row->mechanism);
  Overrides overrides;
  located(hypothesis.where, [&] {
    for (const std::string& setting : hypothesis.alternatives[k].departure.set) {
      if (is_law_setting(model, setting)) continue;
      const auto parameter = find_parameter(problem, name_of_setting(setting), Owner::Machine);
      set_value(problem, setting);
      overrides.emplace_back(parameter.parameter, problem.constants[parameter.parameter]);
    }
  });
  return settings_.emplace(key, std::move(overrides)).first->second;
}

std::vector<std::string> Model::law_settings(const RowModel& model, std::size_t h,
                                             std::size_t k) const {
  std::vector<std::string> settings;
  for (const std::string& setting : table_.hypotheses[h].alternatives[k].departure.set) {
    const bool is_stated = std::any_of(
        model.law_settings.begin(), model.law_settings.end(),
        [&](const auto& own) { return name_of_setting(own) == name_of_setting(setting); });
    if (is_law_setting(model, setting) && !is_stated) settings.push_back(setting);
  }
  return settings;
}

/// Other responses than the row's, before what uses them is asked.
void Model::add_responses(RowModel& model, std::size_t h) {
  const StatedHypothesis& hypothesis = table_.hypotheses[h];
  std::vector<std::size_t> response_of{0};
  for (const StatedAlternative& alternative : hypothesis.alternatives) {
    const auto& map = alternative.departure.responses;
    const auto found = map.find(model.row->response);
    response_of.push_back(found == map.end() ? 0 : model.responses.size());
    if (found == map.end()) continue;
    check_free(table_, model.responses_by, h, model, "the response");
    model.responses_by = h;
    model.responses.push_back(make_response_of(model, found->second, hypothesis.where));
  }
  if (model.responses_by == h) model.response_of = std::move(response_of);
}

void Model::add_settings(RowModel& model, std::size_t h) {
  const StatedHypothesis& hypothesis = table_.hypotheses[h];
  std::vector<Overrides> of_choice{{}};
  bool any = false;
  for (std::size_t k = 0; k < hypothesis.alternatives.size(); ++k) {
    Overrides own;
    for (const auto& [parameter, value] : machine_settings(model, h, k)) {
      const bool is_stated = std::any_of(model.row->set.begin(), model.row->set.end(),
                                         [&, p = parameter](const auto& setting) {
                                           const auto& of = model.problem->mechanism->parameters[p];
                                           const std::string name = name_of_setting(setting);
                                           return name == of.name || name == of.symbol;
                                         });
      if (is_stated || !any_uses(model, parameter)) continue;
      for (const auto& [other, choices] : model.overrides) {
        for (const Overrides& set : choices) {
          for (const auto& [index, unused] : set) {
            if (index != parameter) continue;
            check_free(table_, other, h, model, model.problem->mechanism->parameters[index].name);
          }
        }
      }
      own.emplace_back(parameter, value);
      any = true;
    }
    of_choice.push_back(std::move(own));
  }
  if (any) model.overrides.emplace_back(h, std::move(of_choice));
}

void Model::add_hypothesis(RowModel& model, std::size_t h) {
  const StatedHypothesis& hypothesis = table_.hypotheses[h];
  add_responses(model, h);
  add_settings(model, h);
  const bool sees_law = any_sees_law(model);
  bool is_law = false;
  for (std::size_t k = 0; k < hypothesis.alternatives.size(); ++k) {
    const StatedDeparture& departure = hypothesis.alternatives[k].departure;
    if (sees_law && departure.laws.contains(model.row->law)) {
      check_free(table_, model.laws_by, h, model, "the law");
      model.laws_by = h;
      is_law = true;
    }
    is_law = is_law || (sees_law && !law_settings(model, h, k).empty());
    const bool reads_peak = std::any_of(model.responses.begin(), model.responses.end(),
                                        [](const RowResponse& r) { return r.has_peak; });
    if (departure.peaks && reads_peak) {
      check_free(table_, model.peaks_by, h, model, "how peaks are read");
      model.peaks_by = h;
    }
    if (departure.cuts_off) {
      check_free(table_, model.digits_by, h, model, "the digits");
      model.digits_by = h;
    }
  }
  if (is_law) model.law_by.push_back(h);
  const bool sets = !model.overrides.empty() && model.overrides.back().first == h;
  const bool left_unknown = hypothesis.alternatives.empty();  // of rows that it names
  if (is_law || sets || left_unknown || model.responses_by == h || model.peaks_by == h ||
      model.digits_by == h) {
    model.depends.push_back(h);
  }
}

}  // namespace camlaw::problems::stated

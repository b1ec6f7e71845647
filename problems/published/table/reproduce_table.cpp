// SPDX-License-Identifier: MIT
#include "problems/published/table/implied.h"
#include "problems/published/table/stated_model.h"

namespace camlaw::problems {
namespace {

optim::PrintedTable hypothesis_table(const StatedTable& stated, stated::Model& model) {
  optim::PrintedTable table;
  table.name = stated.name;
  table.allow_misprints = stated.allow_misprints;
  for (const StatedHypothesis& hypothesis : stated.hypotheses) {
    optim::Hypothesis h{hypothesis.name, hypothesis.stated, {}, hypothesis.unstated};
    for (const StatedAlternative& alternative : hypothesis.alternatives) {
      h.alternatives.push_back(alternative.name);
    }
    table.hypotheses.push_back(std::move(h));
  }
  for (std::size_t i = 0; i < model.size(); ++i) {
    table.printed.push_back(model.row(i).row->printed.number);
    table.depends.push_back(model.row(i).depends);
  }
  table.model = [&model](std::size_t row, std::span<const int> choice) {
    return model.value(row, choice);
  };
  return table;
}

/// Why a value that needs what is left unknown cannot be compared.
void add_unknowns(const StatedTable& stated, const stated::Model& model,
                  SystemReproduction& result) {
  for (std::size_t i = 0; i < model.size(); ++i) {
    for (const std::size_t h : model.row(i).depends) {
      const StatedHypothesis& hypothesis = stated.hypotheses[h];
      if (!hypothesis.alternatives.empty()) continue;
      result.values[i].causes.push_back(hypothesis.name + ": not stated");
    }
  }
}

}  // namespace

SystemReproduction reproduce_table(const StatedTable& stated, const std::atomic<bool>* stop) {
  stated::Model model(stated, stop);
  std::vector<PrintedValue> printed;
  for (std::size_t i = 0; i < model.size(); ++i) {
    printed.push_back(model.row(i).row->printed);
    printed.back().unit = model.row(i).unit;
  }
  SystemReproduction result = reproduce_system(stated.name, stated.title, stated.source,
                                               std::move(printed), hypothesis_table(stated, model));
  add_unknowns(stated, model, result);
  stated::add_implied(model, result);
  result.notes = stated.notes;
  return result;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "problems/tolerance/tolerance_worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "optim/study/encoding.h"
#include "optim/verdict/parts_errands.h"
#include "problems/fronts/problem_settings.h"
#include "problems/fronts/sent_settings.h"
#include "problems/fronts/study_worker.h"
#include "problems/results/start_settings.h"
#include "problems/tolerance/grid_rooms.h"

namespace camlaw::problems {
namespace {

constexpr const char* kToleranceWork = "parts of a design";

/// A design with all that parts of it are judged by.
struct Workshop {
  explicit Workshop(VariedDesign design)
      : varied(std::move(design)),
        rooms(grid_rooms(varied)),
        drawer(*rooms.rows, varied.meant, varied.variations) {}

  VariedDesign varied;
  GridRooms rooms;
  optim::PartsDrawer drawer;
};

/// Whether two designs are the same machine with the same law. A value that a search has left a
/// rounding away from its bound is read as that bound.
bool same_design(const ProblemStatement& a, const ProblemStatement& b) {
  constexpr double kRounding = 2e-12;  // reading takes 1e-12 for the bound, in either design
  const auto is_same = [](double x, double y) {
    return x == y || std::abs(x - y) <= kRounding * std::max(std::abs(x), std::abs(y));
  };
  const auto are_same = [&](const auto& all, const auto& others) {
    return std::equal(all.begin(), all.end(), others.begin(), others.end(), is_same);
  };
  const Member &mine = a.laws.front(), &its = b.laws.front();
  const auto &own = mine.arguments.values(), &other = its.arguments.values();
  return are_same(a.constants, b.constants) && mine.name() == its.name() &&
         std::equal(own.begin(), own.end(), other.begin(), other.end(), are_same);
}

}  // namespace

ProblemStatement restated_design(const ProblemStatement& design) {
  ProblemStatement stated = read_problem(design.text, design.source, design.files);
  set_values(stated, restated_settings(design));
  if (!same_design(stated, design)) {
    throw std::invalid_argument(
        "the problem's text and what was set in it give another design than this result has; look "
        "at "
        "the problem file itself");
  }
  return stated;
}

optim::WorkerProgram tolerance_program(const ProblemStatement& design,
                                       const std::vector<std::string>& tolerances) {
  const ProblemStatement stated = restated_design(design);
  std::vector<std::string> texts{kToleranceWork, fmt::format("{}", tolerances.size())};
  texts.insert(texts.end(), tolerances.begin(), tolerances.end());
  add_settings_to(texts, problem_settings(stated));
  return {worker_path(), optim::encoded(texts)};
}

std::optional<optim::Service> service_of_tolerance(const std::string& sent) {
  const auto texts = optim::decoded_texts(sent);
  if (!texts || texts->empty() || texts->front() != kToleranceWork) return {};
  SentTexts reader(*texts);
  reader.text();
  std::vector<std::string> tolerances(reader.count());
  for (std::string& tolerance : tolerances) tolerance = reader.text();
  const ProblemStatement design = stated_problem(reader.settings());
  const auto shop =
      std::make_shared<const Workshop>(varied_design(design, asked_variations(design, tolerances)));
  return [shop, service = optim::parts_service(shop->drawer)](
             const std::string& order, const optim::Bench& bench) { return service(order, bench); };
}

}  // namespace camlaw::problems

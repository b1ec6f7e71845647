// SPDX-License-Identifier: MIT
#include "output/report/provenance.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <ctime>

#include "optim/solvers/solver.h"
#include "output/report/html.h"

namespace camlaw::cli {
namespace {

std::time_t time_of_report() {
  const char* fixed = std::getenv("SOURCE_DATE_EPOCH");
  if (fixed == nullptr || *fixed == '\0') return std::time(nullptr);
  char* end = nullptr;
  const long long seconds = std::strtoll(fixed, &end, 10);
  return *end == '\0' ? static_cast<std::time_t>(seconds) : std::time(nullptr);
}

}  // namespace

ReportSection provenance_section(Facts facts, const std::string& input_name,
                                 const std::string& input_text) {
  facts.insert(facts.begin(), {"program", "camlaw " CAMLAW_VERSION});
  facts.insert(facts.begin() + 1,
               {"solvers", fmt::format("{}", fmt::join(optim::solver_versions(), ", "))});
  facts.emplace_back("written",
                     fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(time_of_report())));
  facts.emplace_back("plots", "Chart.js, MIT licence, https://www.chartjs.org");
  std::string html = definitions(facts);
  if (!input_text.empty()) html += details(input_name, preformatted(input_text));
  return {"provenance", "Provenance", html};
}

}  // namespace camlaw::cli

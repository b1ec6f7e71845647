// SPDX-License-Identifier: MIT
#include "output/report/provenance.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "optim/versions.h"
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
               {"libraries", fmt::format("{}", fmt::join(optim::library_versions(), ", "))});
  facts.emplace_back("written",
                     fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(time_of_report())));
  facts.emplace_back("plots", "Chart.js, MIT licence, https://www.chartjs.org");
  std::string html = definitions(facts);
  if (!input_text.empty()) html += details(input_name, preformatted(input_text));
  return {"provenance", "Provenance", html};
}

void add_checksum(Facts& facts, const std::string& file, const std::string& checksum) {
  if (checksum.empty()) return;
  const std::string name = std::filesystem::path(file).filename().string();
  facts.emplace_back("SHA-256 of " + name,
                     checksum + fmt::format(" (as 'sha256sum {}' prints it)", name));
}

std::string record_line(const std::string& file, const std::string& checksum) {
  constexpr std::size_t kDigits = 16;
  const std::string name = std::filesystem::path(file).filename().string();
  return "camlaw " CAMLAW_VERSION ", " + name +
         (checksum.empty() ? "" : ", SHA-256 " + checksum.substr(0, kDigits) + "...");
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
// What a build without reports (CAMLAW_REPORTS=OFF) has in place of them.
#include <stdexcept>

#include "output/report/report.h"

namespace camlaw::cli {
namespace {

[[noreturn]] void refuse() {
  throw std::runtime_error("this build of camlaw has no reports (CAMLAW_REPORTS=OFF)");
}

}  // namespace

std::string page_html(const ReportPage&) { refuse(); }
bool is_unchanged_page(std::string_view) { refuse(); }
ReportPage design_report(const ReportedDesign&) { refuse(); }
ReportPage comparison_report(const std::vector<ComparedDesign>&, const std::vector<std::string>&) {
  refuse();
}
ReportPage front_report(const FrontAnswer&, const std::string&) { refuse(); }
ReportPage sweep_report(const SweepAnswer&, const std::string&) { refuse(); }
ReportPage reproduction_report(const std::vector<problems::SystemReproduction>&) { refuse(); }

}  // namespace camlaw::cli

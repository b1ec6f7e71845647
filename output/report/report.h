// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "output/answers/claim_output.h"
#include "output/answers/comparison_output.h"
#include "output/answers/front_answer.h"
#include "output/answers/search_facts.h"
#include "output/answers/sweep_answer.h"
#include "output/report/page.h"
#include "problems/published/table/reproduction.h"
#include "problems/results/recorded_design.h"

/// What reports are written about, one page each.
namespace camlaw::cli {

/// A design and where it comes from.
struct ReportedDesign {
  problems::ReadDesign read;  ///< its verdict is the search's, of all combinations of its choices
  std::string file;           ///< as it was named
  Facts facts = {};           ///< of the search that found it
  ClaimReview review = {};    ///< of the result as a record
  std::string checksum = {};  ///< SHA-256 of the file's bytes
  std::vector<std::string> settings = {};  ///< what the command line set in the design
  /// Told what is worked out next, and what share of the whole is done.
  std::function<void(const std::string& what, double done)> progress = {};
};

/// A design judged again: verdict, limits, curves, the mechanism in motion, rulers, sensitivities.
/// Throws std::invalid_argument for a design that cannot be at all.
ReportPage design_report(const ReportedDesign& reported);

/// Designs side by side: tables with the best marked, profiles and curves over one another, and
/// what they do not share. `checksums` are the SHA-256 of their files. Throws std::invalid_argument
/// for a design that cannot be at all.
ReportPage comparison_report(const std::vector<ComparedDesign>& designs,
                             const std::vector<std::string>& checksums);

/// A front with the curves of its designs, of which two can be compared.
ReportPage front_report(const FrontAnswer& answer, const std::string& file);

/// A sweep with its map: which choice is best where, contours, what holds the designs.
ReportPage sweep_report(const SweepAnswer& answer, const std::string& file);

/// Published tables beside what the program computes.
ReportPage reproduction_report(const std::vector<problems::SystemReproduction>& results);

}  // namespace camlaw::cli

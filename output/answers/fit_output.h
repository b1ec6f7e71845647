// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "fitting/cams/cam_fit.h"
#include "fitting/constants/constants_fit.h"
#include "fitting/motions/motion_fit.h"
#include "fitting/motions/recorded_motion.h"
#include "fitting/records/record_fit.h"
#include "output/document/document.h"
#include "output/figure/chart.h"
#include "problems/law_files/json_text.h"

/// Fits for people and for programs.
namespace camlaw::cli {

/// `fits` as fit_constants and rank_laws give them, not empty.
Document constants_document(const std::vector<problems::ConstantsFit>& fits);

/// A number of a fit for people: six digits are beyond what is measured.
std::string number(double value);
Cell number_cell(double value);
/// Fitted numbers with their intervals.
Table fitted_table(const optim::FitResult& fit);
bool all_identifiable(const optim::FitResult& fit);

/// What became of a table with too many rows to fit each: "100 neighbours each ...".
void add_condensed(std::size_t each, std::size_t left_out, Document& document);
/// Rows without a number.
void add_left_out(std::size_t rows, Document& document);
/// Whether a fit is to be trusted; `distrust` says why not, or is empty.
void add_trust(const std::string& distrust, Document& document);

/// A recorded curve and the machine behind it.
struct RecordAnswer {
  std::string machine_file;
  std::size_t left_out = 0;  ///< rows that lack a number
  problems::RecordedCurve record;
  problems::RecordFit fit;
};

Document record_document(const RecordAnswer& answer);
/// The command that shows the machine that was found, with what else was set: "evaluate FILE --set
/// 'mass=1.2 kg'".
std::string record_evaluation(const RecordAnswer& answer, const std::vector<std::string>& settings);
/// The record with what the machine computes, and what is left.
Figure record_figure(const RecordAnswer& answer);

/// A table of samples and the laws behind its motions.
struct SamplesAnswer {
  std::string source;
  std::size_t left_out = 0;  ///< rows that lack a number
  std::size_t each = 1;      ///< measured rows that a sample is the mean of
  std::size_t outliers = 0;  ///< of those, far off their neighbours
  std::variant<problems::RecordedMotion, problems::CamFit> fit;
  std::vector<std::string> notes = {};  ///< what was assumed in reading

  const problems::CamFit* cam() const { return std::get_if<problems::CamFit>(&fit); }
  const problems::RecordedMotion* motion() const {
    return std::get_if<problems::RecordedMotion>(&fit);
  }
  const problems::FittedCycle& cycle() const {
    return cam() != nullptr ? cam()->cycle : motion()->cycle;
  }
  const std::vector<problems::FaultTest>& faults() const {
    return cam() != nullptr ? cam()->faults : motion()->faults;
  }
  const std::optional<problems::Centre>& centre() const {
    return cam() != nullptr ? cam()->centre : motion()->centre;
  }
};

/// What is wrong with the record: rows that were left out, the centre that was fitted.
void add_record_faults(const SamplesAnswer& answer, Document& document);

/// What a measured cam adds: what of it lies off.
Document cam_document(const problems::CamFit& cam);
/// Draws what departs from the laws into the two panels of each motion.
void mark_departures(const problems::CamFit& cam, Figure& figure);

Document samples_document(const SamplesAnswer& answer);
/// Each motion's samples and law, and what is left.
Figure samples_figure(const SamplesAnswer& answer);
/// The law file of the largest motion.
Json samples_law(const SamplesAnswer& answer);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/answers/claim_output.h"
#include "output/export/shaft_place.h"
#include "problems/results/recorded_design.h"

/// A design judged again before it is written to a file.
namespace camlaw::cli {

/// "judged again: feasible", or that the design does not meet its limits; empty where there is
/// nothing to judge.
std::vector<std::string> judged_words(const problems::ReadDesign& read);

/// What is to be said of the record that a design was read from: `review`, and where that does not
/// believe it what the design is judged to be now.
std::vector<std::string> record_words(const problems::ReadDesign& read, const ClaimReview& review);

/// Of each limit of its problem that a design does not meet its value and its bound, a sentence
/// each: "limit not met: pressure_angle is 32.8 deg and must be at most 30 deg".
std::vector<std::string> unmet_words(const problems::ProblemStatement& design);

/// Of a cam that was taken from its shaft unmet_words of the shaft, whose limits are not those of
/// one cam, and where on the shaft it stands; nothing of a design that is no such cam.
struct TakenCam {
  std::vector<std::string> unmet = {};
  std::optional<problems::ShaftPlace> on_shaft = {};
};
/// Of a file with several cams on one shaft the one of this name, in place of the statement. Where
/// none is named the statement stays if `slave` is a curve of the shaft itself, else throws
/// std::invalid_argument; `example` says how one is named, {} being a name: "--cam {}".
TakenCam take_cam(const std::optional<std::string>& name, const std::string& file,
                  const char* example, const std::optional<std::string>& slave,
                  problems::ProblemStatement& statement);

}  // namespace camlaw::cli

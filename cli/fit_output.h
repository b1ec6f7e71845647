// SPDX-License-Identifier: MIT
#pragma once

#include "cli/chart.h"
#include "cli/law_json.h"
#include "problems/fits/constants_fit.h"
#include "problems/fits/motion_fit.h"

/// Fits for people and for programs.
namespace camlaw::cli {

/// `fits` as fit_constants and rank_laws give them, not empty.
std::string constants_text(const std::vector<problems::ConstantsFit>& fits);
Json constants_json(const std::vector<problems::ConstantsFit>& fits);

/// A table of samples and the laws behind its motions.
struct SamplesAnswer {
  std::string source;
  std::size_t left_out = 0;  ///< rows that lack a number
  problems::FoundCycle cycle;
  std::vector<problems::MotionFit> fits;
};

std::string samples_text(const SamplesAnswer& answer);
Json samples_json(const SamplesAnswer& answer);
/// Each motion's samples and law, and what is left.
Figure samples_figure(const SamplesAnswer& answer);
/// The law file of the largest motion.
Json samples_law(const SamplesAnswer& answer);

}  // namespace camlaw::cli

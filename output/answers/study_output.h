// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/answers/law_json.h"
#include "output/figure/chart.h"
#include "problems/law_files/json_text.h"
#include "problems/published/spine_cutter/study.h"

/// The spine cutter's study as text, CSV, JSON and pictures.
namespace camlaw::cli {

std::string study_text(const problems::SpineCutterStudy& study);
std::string study_csv(const problems::SpineCutterStudy& study);
Json study_json(const problems::SpineCutterStudy& study);
/// Peak force over cam radius, with the limit curve.
Figure trade_off_figure(const problems::SpineCutterStudy& study);
/// s, v, a, j of the compromise, the law of least force and the published laws.
Figure study_motion_figure(const problems::SpineCutterStudy& study);

}  // namespace camlaw::cli

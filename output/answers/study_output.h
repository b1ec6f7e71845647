// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/document/document.h"
#include "output/figure/chart.h"
#include "problems/law_files/json_text.h"
#include "problems/published/spine_cutter/study.h"

/// The spine cutter's study, its table and its pictures.
namespace camlaw::cli {

Document study_document(const problems::SpineCutterStudy& study);
/// Its laws, one row each.
Table study_table(const problems::SpineCutterStudy& study);
/// Peak force over cam radius, with the limit curve.
Figure trade_off_figure(const problems::SpineCutterStudy& study);
/// s, v, a, j of the compromise, the law of least force and the published laws.
Figure study_motion_figure(const problems::SpineCutterStudy& study);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include "output/document/document.h"
#include "output/figure/chart.h"
#include "problems/law_files/json_text.h"
#include "problems/published/spine_cutter/proved_fronts.h"

/// The proved fronts of the spine cutter's study as text, CSV, JSON and lines of its picture.
namespace camlaw::cli {

Document fronts_document(const problems::SpineCutterFronts& fronts);
/// The points of all fronts, one row each.
Table fronts_table(const problems::SpineCutterFronts& fronts);
void draw_fronts(const problems::SpineCutterFronts& fronts, Panel& panel);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/answers/law_json.h"
#include "output/figure/chart.h"
#include "problems/law_files/json_text.h"
#include "problems/published/spine_cutter/proved_fronts.h"

/// The proved fronts of the spine cutter's study as text, CSV, JSON and lines of its picture.
namespace camlaw::cli {

std::string fronts_text(const problems::SpineCutterFronts& fronts);
std::string fronts_csv(const problems::SpineCutterFronts& fronts);
Json fronts_json(const problems::SpineCutterFronts& fronts);
void draw_fronts(const problems::SpineCutterFronts& fronts, Panel& panel);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include "output/document/json.h"
#include "output/figure/chart.h"
#include "output/report/design_figure.h"
#include "problems/law_files/json_text.h"

/// Figures as data for the scripts of a report. Numbers have six digits: they are drawn, not
/// computed with.
namespace camlaw::cli {

/// A number to six digits; what is not finite is null.
Json drawn_number(double value);
/// What is rounding beside the largest of them is 0.
Json drawn_numbers(const std::vector<double>& values);

/// What panels are: names, axes and limits.
Json panels_json(const Figure& figure, const std::vector<PanelWords>& words);

/// The first line of each panel, that of the design: places in `grids`, each once, and values.
Json lines_json(const Figure& figure);

}  // namespace camlaw::cli

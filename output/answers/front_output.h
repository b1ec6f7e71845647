// SPDX-License-Identifier: MIT
#pragma once

#include "output/answers/front_answer.h"
#include "output/answers/law_json.h"
#include "output/figure/chart.h"
#include "problems/law_files/json_text.h"

/// A front for people, for programs and as a picture.
namespace camlaw::cli {

std::string front_text(const FrontAnswer& answer);
/// Of it what is said of the front as a whole: measures, rulers, the knee, the work. For fronts
/// with points.
std::string front_summary(const FrontAnswer& answer);
Json front_json(const FrontAnswer& answer);
std::string front_csv(const FrontAnswer& answer);
/// Empty of panels unless there are two or three objectives.
Figure front_figure(const FrontAnswer& answer);

/// One design of the front in full, and what the next tenth of each objective costs.
std::string point_text(const FrontAnswer& answer, std::size_t point);
Json point_json(const FrontAnswer& answer, std::size_t point);

}  // namespace camlaw::cli

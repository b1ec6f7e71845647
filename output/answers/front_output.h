// SPDX-License-Identifier: MIT
#pragma once

#include "output/answers/front_answer.h"
#include "output/document/document.h"
#include "output/figure/chart.h"
#include "problems/law_files/json_text.h"

/// A front for people, for programs and as a picture.
namespace camlaw::cli {

Document front_document(const FrontAnswer& answer);
/// What is said of the front as a whole: measures, rulers, the knee, the work.
Document front_summary(const FrontAnswer& answer);
/// Some of its points, one row each.
Table points_table(const FrontAnswer& answer, const std::vector<std::size_t>& points);
std::string front_csv(const FrontAnswer& answer);
/// Empty of panels unless there are two or three objectives.
Figure front_figure(const FrontAnswer& answer);

/// One design of the front in full, and what the next tenth of each objective costs.
Document point_document(const FrontAnswer& answer, std::size_t point);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/answers/front_answer.h"
#include "output/document/document.h"

/// What is said of points of a front in several places.
namespace camlaw::cli {

/// "certified optimum, global".
std::string verdict_words(const optim::FrontPoint& point);
/// A value of objective `i`, "33.1 mm".
std::string with_its_unit(const FrontAnswer& answer, std::size_t i, double value);
/// "R 33.1 mm, F 4.2 N".
std::string values_text(const FrontAnswer& answer, const std::vector<double>& costs);
/// The nearest points of the front that are better by a tenth or more in each of two objectives.
Document next_document(const FrontAnswer& answer, std::size_t point);

/// "point 3", "points 1, 2 and 5", of many "17 points, the first of them 3".
std::string points_text(const std::vector<std::size_t>& points);

/// "27 of 40 points" that were asked for; once there are more, "54 points, 40 asked for".
std::string counted_points(const optim::StudyProgress& progress);
/// "front: 27 of 40 points"; before the first "front: 3 searches, no point yet".
std::string front_progress(const optim::StudyProgress& progress);

/// Which of its points cannot be built, and what was checked of none of them.
Document front_buildable(const FrontAnswer& answer);

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/answers/design_review.h"
#include "output/report/page.h"
#include "problems/statement/statement.h"

namespace camlaw::cli {

/// What a response is, and from where on it does harm, as its machine describes it: "roller radius
/// over the pitch curve's radius of curvature" and "at 1 the profile is undercut". The second is
/// empty where the machine says no more.
struct ToldResponse {
  std::string meaning, consequence;
};
ToldResponse told(const problems::ResponseName& name, const problems::Mechanism& mechanism);

/// A tile for what is sought and for each limit, those with the least margin first: the value, what
/// it is, and a sentence on what it means for whoever designs with it.
ReportSection tiles_section(const problems::ProblemStatement& design, const DesignReview& review);

}  // namespace camlaw::cli

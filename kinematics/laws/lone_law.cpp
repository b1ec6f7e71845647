// SPDX-License-Identifier: MIT
#include "kinematics/laws/lone_law.h"

#include "kinematics/shape.h"
#include "numerics/scalar/dual.h"

namespace camlaw {

Member lone_law(LoneLaw about, Law<double> law) {
  const int smooth = continuity(law);
  Family family{.name = std::move(about.name),
                .aliases = std::move(about.aliases),
                .formula = std::move(about.formula),
                .parameters = {},
                .ends = std::move(about.ends),
                .continuity = smooth,
                .symmetric = about.symmetric,
                .source = std::move(about.source),
                .maker = [law = std::move(law)]<class S>(const Arguments<S>&) {
                  return law.template as<S>();
                }};
  const auto owned = std::make_shared<const Family>(std::move(family));
  return {owned, owned->defaults()};
}

}  // namespace camlaw

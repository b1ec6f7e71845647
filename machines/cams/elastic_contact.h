// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

/// The contact of a follower whose train is elastic (docs/theory.md, "Contact of an elastic
/// follower").
namespace camlaw::problems {

/// The parameter above 0 where a train is elastic.
inline constexpr const char* kTrainStiffness = "train_stiffness";

/// (U20) Adds to a mechanism with an elastic train, for each of its checks that forces decide, the
/// same check of the elastic follower: of `elastic_force` or `elastic_torque` in place of the rigid
/// follower's, and of a stress the response "elastic_NAME", which is the stress under that force,
/// as elastic_crown_stress is. Each of the two checks is made where it is meant. A mechanism
/// without such a train stays as it is.
void add_elastic_checks(Mechanism& mechanism);

}  // namespace camlaw::problems

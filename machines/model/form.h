// SPDX-License-Identifier: MIT
#pragma once

namespace camlaw::problems {

/// How a machine is built: which picture shows it, and how a measured cam of it is read.
enum class Form : char {
  Other,
  DiscRoller,          ///< a disc cam and a follower that slides
  DiscKnifeEdge,       ///< the same, with a knife edge
  DiscFlat,            ///< the same, with a flat face
  DiscConjugate,       ///< two discs, each with a roller of the same follower
  DiscTrailingRoller,  ///< a disc cam and a roller on an arm that it pulls
  DiscLeadingRoller,   ///< the same, the arm pushed
  DiscFlatArm,         ///< a disc cam and a flat face on an arm
  EndRoller,           ///< an end or barrel cam and a roller that slides
  EndArm,              ///< the same, the roller on an arm
  Plate,               ///< a plate that moves along a line
  BalancingCam,        ///< a cam between springs, on a shaft
  Geneva,
  SphericalGeneva,
  SignatureFeeder,
  LawAlone,  ///< a law by itself, no machine
};

}  // namespace camlaw::problems

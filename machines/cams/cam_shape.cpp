// SPDX-License-Identifier: MIT
#include "machines/cams/cam_shape.h"

namespace camlaw::problems {

std::optional<CamShape> cam_shape(const Mechanism& mechanism) {
  switch (mechanism.form) {
    case Form::DiscRoller:
    case Form::DiscKnifeEdge:
    case Form::DiscFlat:
    case Form::DiscConjugate:
    case Form::DiscTrailingRoller:
    case Form::DiscLeadingRoller:
    case Form::DiscFlatArm:
    case Form::BalancingCam:
      return CamShape::Disc;
    case Form::EndRoller:
    case Form::EndArm:
      return CamShape::Drum;
    case Form::Plate:
      return CamShape::Plate;
    default:
      return {};
  }
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "machines/die_press/mechanism.h"

#include "machines/die_press/die_press.h"
#include "machines/model/listed_responses.h"

namespace camlaw::problems {

namespace {

using optim::Part;
using S = optim::Shape;

enum class PressQuantity {
  Force,
  LineLoad,
  Stress,
  HalfWidth,
  Approach,
  ExactStress,
  ExactHalfWidth,
  ExactApproach
};

/// A quantity of the contact under a force.
template <class Machine, class X>
X under(const Machine& press, PressQuantity wanted, const X& force) {
  switch (wanted) {
    case PressQuantity::Force:
      return force;
    case PressQuantity::LineLoad:
      return press.line_load(force);
    case PressQuantity::Stress:
      return press.stress(force);
    case PressQuantity::HalfWidth:
      return press.half_width(force);
    case PressQuantity::Approach:
      return press.approach(force);
    case PressQuantity::ExactStress:
      return press.exact_stress(force);
    case PressQuantity::ExactHalfWidth:
      return press.exact_half_width(force);
    case PressQuantity::ExactApproach:
      break;
  }
  return press.exact_approach(force);
}

MechanismResponse given(PressQuantity which, ResponseAbout about) {
  return number_response<DiePress>(
      std::move(about), [which](const auto& press) { return under(press, which, press.load()); });
}

const Cycle& turn() {
  static const Cycle turn{"deg", {{0, 180}, {180, 360, true}}};
  return turn;
}

MechanismResponse running(PressQuantity which, ResponseAbout about) {
  return listed_curve<DiePress>(std::move(about), turn(), which,
                                [](const auto& press, PressQuantity wanted, const auto& motion) {
                                  return under(press, wanted, press.running_force(motion));
                                });
}

MechanismResponse displacement() {
  const ResponseAbout about{"displacement", "mm", "m",
                            "travel of the rollers from their lowest position"};
  return listed_curve<DiePress>(
      about, turn(), PressQuantity{},
      [](const auto& press, PressQuantity, const auto& motion) { return press.stroke * motion.s; });
}

struct Row {
  PressQuantity quantity;
  const char *number, *curve, *unit, *stored, *meaning;
  S in_radii;  ///< form in the two radii
};

constexpr Row kRows[] = {
    {PressQuantity::Stress, "contact_stress", "running_stress", "MPa", "Pa",
     "contact stress, as published", S::Convex},
    {PressQuantity::HalfWidth, "contact_half_width", "running_half_width", "mm", "m",
     "half the contact's width, as published", S::Concave},
    {PressQuantity::Approach, "elastic_approach", "running_approach", "um", "m",
     "elastic approach of cam and roller, as published", S::Concave},
    {PressQuantity::ExactStress, "exact_contact_stress", "running_exact_stress", "MPa", "Pa",
     "contact stress according to Hertz", S::Convex},
    {PressQuantity::ExactHalfWidth, "exact_contact_half_width", "running_exact_half_width", "mm",
     "m", "half the contact's width according to Hertz", S::Concave},
    {PressQuantity::ExactApproach, "exact_elastic_approach", "running_exact_approach", "um", "m",
     "approach of the axes according to Hertz", S::Concave}};

std::vector<MechanismResponse> responses() {
  std::vector<MechanismResponse> all{
      given(PressQuantity::Force, {"load", "N", "N", "contact load, F_k + k F_s"}),
      given(PressQuantity::LineLoad, {"line_load", "N/mm", "N/m", "contact load per unit width"}),
      running(PressQuantity::Force,
              {"running_force", "N", "N",
               "force between cam and roller; below 0 the roller leaves the cam"})};
  all.push_back(displacement());
  const std::vector<std::string> radii{"roller_radius", "segment_radius"};
  for (const Row& row : kRows) {
    const std::vector<ShapeStatement> shapes{{radii, row.in_radii, "DS9"}};
    all.push_back(given(row.quantity, {row.number, row.unit, row.stored, row.meaning, shapes}));
    all.push_back(running(row.quantity, {row.curve, row.unit, row.stored, row.meaning, shapes}));
  }
  return all;
}

}  // namespace

Mechanism die_press_mechanism() {
  return {
      .name = "die-press",
      .title = "cam and rollers of a flat die-cutting press",
      .source =
          "Study of the elastic deformation amount of the flat die-cutting press parts "
          "being in constant contact, Ukrainian Academy of Printing",
      .parameters = parameters_of<DiePress>(),
      .responses = responses(),
      .peaks = {
          {"least_force", "running_force", Part::Lowest,
           "least force between cam and roller; above 0 the spring keeps contact"},
          {"peak_force", "running_force", Part::Highest, "greatest force between cam and roller"},
          {"peak_stress", "running_stress", Part::Highest, "greatest contact stress"},
          {"peak_approach", "running_approach", Part::Highest, "greatest elastic approach"}}};
}

}  // namespace camlaw::problems

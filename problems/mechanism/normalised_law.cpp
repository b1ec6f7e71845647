// SPDX-License-Identifier: MIT
#include "problems/mechanism/normalised_law.h"

#include "problems/mechanism/responses.h"

namespace camlaw::problems {
namespace {

/// No machine at all.
template <class T>
struct NoMachine {};

}  // namespace

template <>
struct MachineTraits<NoMachine> {
  static const std::vector<MechanismParameter>& parameters() {
    static const std::vector<MechanismParameter> none;
    return none;
  }
  template <class T>
  static constexpr std::array<T NoMachine<T>::*, 0> fields{};
};

namespace {

template <class F>
MechanismResponse law_curve(const char* name, const char* meaning, optim::Shape shape, F motion) {
  static const Cycle cycle{"1", {{0, 1}}};
  return curve_response<NoMachine>({name, "1", "1", meaning, {{{"law"}, shape}}}, cycle,
                                   [motion](const auto&) { return motion; });
}

std::vector<MechanismResponse> curves() {
  using optim::Shape;
  return {
      law_curve("displacement", "s", Shape::Linear, [](const auto& m) { return m.s; }),
      law_curve("velocity", "s'", Shape::Linear, [](const auto& m) { return m.v; }),
      law_curve("acceleration", "s''", Shape::Linear, [](const auto& m) { return m.a; }),
      law_curve("jerk", "s''' within the pieces", Shape::Linear, [](const auto& m) { return m.j; }),
      law_curve("moment", "s' s''", Shape::General, [](const auto& m) { return m.v * m.a; })};
}

}  // namespace

Mechanism normalised_law_mechanism() {
  using optim::Part;
  return {.name = "law",
          .title = "a motion law alone, normalised",
          .source = "VDI 2143",
          .parameters = {},
          .responses = curves(),
          .peaks = {{"B", "velocity", Part::Magnitude, "peak velocity, C_v in VDI 2143"},
                    {"C", "acceleration", Part::Magnitude, "peak acceleration, C_a"},
                    {"D", "jerk", Part::Magnitude, "peak jerk within the pieces, C_j"},
                    {"Cm", "moment", Part::Magnitude, "peak dynamic moment, C_Mdyn"}}};
}

}  // namespace camlaw::problems

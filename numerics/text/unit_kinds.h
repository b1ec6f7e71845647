// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace camlaw {

/// A kind of quantity as messages name it, and a unit of that kind. Angles are a kind of their own
/// in what people write, and plain numbers in dimensions.
struct UnitKind {
  const char* name;
  const char* unit;
  bool has_angle = false;
};

/// The kinds that messages name; a torque and an energy are told apart by neither unit nor
/// dimension.
inline constexpr std::array kUnitKinds{UnitKind{"an angle", "rad", true},
                                       UnitKind{"a length", "m"},
                                       UnitKind{"an area", "m2"},
                                       UnitKind{"a volume", "m3"},
                                       UnitKind{"a time", "s"},
                                       UnitKind{"a frequency", "1/s"},
                                       UnitKind{"an angular velocity", "rad/s", true},
                                       UnitKind{"a velocity", "m/s"},
                                       UnitKind{"an acceleration", "m/s2"},
                                       UnitKind{"a mass", "kg"},
                                       UnitKind{"a density", "kg/m3"},
                                       UnitKind{"a force", "N"},
                                       UnitKind{"a spring rate", "N/m"},
                                       UnitKind{"a stress", "Pa"},
                                       UnitKind{"a torque or an energy", "N m"},
                                       UnitKind{"a power", "W"},
                                       UnitKind{"a moment of inertia", "kg m2"}};

}  // namespace camlaw

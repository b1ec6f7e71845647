// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// What columns of measured tables are called, in English, German and Ukrainian.
namespace camlaw::problems {

enum class ColumnKind {
  Angle,         ///< angle, cam_angle, phi, theta; Winkel; кут
  Time,          ///< t, time; Zeit; час
  Across,        ///< x
  Displacement,  ///< lift, displacement, s, y, h; Hub, Weg; переміщення
  Velocity,
  Acceleration,
  Radius,
  ProfileX,  ///< x, profile_x
  ProfileY   ///< y, profile_y
};

/// Whether a column's name is one of a kind's, in any case; blanks count as underscores.
bool is_named(std::string_view name, ColumnKind kind);
/// Whether it is one of any kind's.
bool is_known_name(std::string_view name);

/// Whether columns of that name are counted in units of that kind: a lift in mm or deg, not in ms.
bool may_have_unit(std::string_view name, std::string_view unit);

/// Whether a unit of an angle, a length, a time or what is made of them can be read.
bool is_known_unit(std::string_view unit);
/// Whether it is one of an angle or a length that no name is mistaken for: "deg", "mm", not "m".
bool is_plain_unit(std::string_view unit);
/// Whether it is one of a torque, force, power, pressure or shaft speed, or a quotient: no part of
/// a name reads like one.
bool is_distinct_unit(std::string_view unit);

}  // namespace camlaw::problems

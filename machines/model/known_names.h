// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "machines/model/mechanism.h"

/// What the program itself takes from a name. A machine that has such a thing, one that a file
/// states included, calls it so (docs/problem-files.md). Nothing outside machines/ compares names
/// of parameters or responses in any other way; a test of the architecture looks.
namespace camlaw::problems {

namespace known {

/// Curves: where the follower is, and its velocity by time; the jerk.
inline constexpr std::string_view kDisplacement = "displacement", kVelocity = "velocity",
                                  kJerk = "jerk";
/// Parameters: the shaft's speed, rpm; how far the follower goes along a line or about a pivot.
inline constexpr std::string_view kSpeed = "speed", kStroke = "stroke", kSwing = "swing";
/// Parameters of cams.
inline constexpr std::string_view kBaseRadius = "base_radius", kFaceWidth = "face_width";

}  // namespace known

/// The parameter, or the response, of exactly that name; none where the machine has none.
std::optional<std::size_t> parameter_called(const Mechanism& mechanism, std::string_view name);
const MechanismResponse* response_called(const Mechanism& mechanism, std::string_view name);

/// Whether a response is a jerk or made of one: "peak_jerk", "mean_square_jerk".
bool is_of_jerk(const MechanismResponse& response);
/// Whether it is a pressure angle: "second_pressure_angle", "peak_pressure_angle".
bool is_pressure_angle(const MechanismResponse& response);
/// Whether a parameter is the pressure that a material bears: "allowable_pressure".
bool is_allowable_pressure(std::string_view parameter);
/// Of a response of the line contact of a roller the one of a crowned roller; empty of others.
std::string_view crowned_twin(std::string_view of_line);

/// What a curve is about, by its name and listed unit.
enum class Subject { Motion, Loads, Contact, Geometry };
/// On a shaft the name has its cam before it, "infeed.displacement".
Subject subject_of(std::string_view curve, std::string_view unit);

}  // namespace camlaw::problems

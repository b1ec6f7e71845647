// SPDX-License-Identifier: MIT
#pragma once

namespace camlaw::problems {

/// Units and names of a follower's motion and load: millimetres and newtons, or degrees and
/// newton metres.
struct FollowerWords {
  const char* stroke;                          ///< its parameter
  const char *place, *place_stored;            ///< units of displacement, listed and stored
  const char *velocity, *acceleration, *jerk;  ///< units, listed and stored
  const char* force;                           ///< unit
  const char *mass, *force_name;               ///< parameter and response
  const char *load, *effort;                   ///< in meanings: what it is, and what the cam exerts
};

inline constexpr FollowerWords kSliding{"stroke",
                                        "mm",
                                        "m",
                                        "m/s",
                                        "m/s2",
                                        "m/s3",
                                        "N",
                                        "mass",
                                        "follower_force",
                                        "force",
                                        "force that the cam must exert along the follower's path"};
inline constexpr FollowerWords kOscillating{"swing",
                                            "deg",
                                            "rad",
                                            "rad/s",
                                            "rad/s2",
                                            "rad/s3",
                                            "N m",
                                            "inertia",
                                            "follower_torque",
                                            "torque",
                                            "torque that the cam must exert on the arm"};

}  // namespace camlaw::problems

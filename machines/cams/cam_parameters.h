// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/given.h"

/// Parameters that several cams have alike.
namespace camlaw::cams {

inline constexpr MachineParameter kStroke{
    "stroke", "h", "mm", "m", "stroke of the follower, at displacement 1", 20, 1e-6, 1e5},
    kSwing{"swing", "Psi", "deg", "rad", "swing of the arm, at displacement 1", 20, 1e-6, 179},
    kBaseRadius{"base_radius", "r_b", "mm", "m", "least radius of the profile", 40, 1e-3, 1e5},
    kRollerRadius{"roller_radius", "r_r", "mm", "m", "radius of the roller", 10, 1e-3, 1e5},
    kOffset{"offset",
            "e",
            "mm",
            "m",
            "offset of the follower's path from the cam's centre; above 0 it lowers the pressure "
            "angle of the rise",
            0,
            -1e5,
            1e5},
    kTrackRadius{"radius", "R", "mm", "m", "mean radius of the roller's track", 50, 1e-3, 1e5},
    kArmLength{"arm_length", "l", "mm", "m", "length of the arm", 80, 1e-3, 1e5},
    kPivotDistance{"pivot_distance",
                   "d",
                   "mm",
                   "m",
                   "distance of the arm's pivot from the cam's centre",
                   100,
                   1e-3,
                   1e5},
    kSpeed{"speed", "n", "rpm", "rad/s", "speed of the cam", 300, 1e-3, 1e6};

/// Mass, spring and load of a follower that slides.
inline constexpr MachineParameter kMass{
    "mass", "m", "kg", "kg", "mass that moves with the follower", 1, 0, 1e6},
    kSpringRate{"spring_rate",
                "c",
                "N/mm",
                "N/m",
                "rate of the spring that holds the follower on the cam",
                5,
                0,
                1e6},
    kSpringPreload{"spring_preload",
                   "F_0",
                   "N",
                   "N",
                   "force of the spring at the lowest position",
                   50,
                   -1e9,
                   1e9},
    kLoad{"load", "F_L", "N", "N", "constant load on the follower that opposes the rise",
          0,      -1e9,  1e9};

/// The same of an arm.
inline constexpr MachineParameter kInertia{
    "inertia", "J", "kg m2", "kg m2", "moment of inertia of everything that swings", 0.002, 0, 1e6},
    kArmSpringRate{"spring_rate", "c", "N m/deg", "N m/rad", "rate of the spring about the pivot",
                   0.2,           0,   1e9},
    kArmSpringPreload{"spring_preload",
                      "M_0",
                      "N m",
                      "N m",
                      "torque of the spring at the lowest position",
                      3,
                      -1e9,
                      1e9},
    kArmLoad{"load", "M_L", "N m", "N m", "constant torque on the arm that opposes the rise",
             0,      -1e9,  1e9};

/// Width and material of the contact, and how the cam is made.
inline constexpr MachineParameter kFaceWidth{
    "face_width", "b", "mm", "m", "width of the contact along the cam's axis", 15, 1e-3, 1e4},
    kYoungsModulus{
        "youngs_modulus", "E", "GPa", "Pa", "Young's modulus of cam and roller", 210, 1e-3, 1e4},
    kPoissonRatio{
        "poisson_ratio", "nu", "1", "1", "Poisson's ratio of cam and roller", 0.3, 0, 0.5},
    kCutterRadius{"cutter_radius",
                  "r_c",
                  "mm",
                  "m",
                  "radius of the tool that cuts the profile",
                  10,
                  1e-3,
                  1e4},
    kDensity{"density", "rho", "kg/m3", "kg/m3", "density of the cam", 7850, 1, 1e5},
    kBoreRadius{"bore_radius", "r_0", "mm", "m", "radius of the cam's bore", 10, 0, 1e5},
    kWearCoefficient{"wear_coefficient",
                     "k_w",
                     "mm3/N/m",
                     "m2/N",
                     "wear coefficient after Archard: volume that the profile loses per force and "
                     "length of sliding",
                     1e-7,
                     0,
                     1};

/// The guide of a sliding follower.
inline constexpr MachineParameter kGuideFriction{
    "guide_friction", "mu", "1", "1", "coefficient of friction of the follower's guide", 0, 0, 1},
    kGuideLength{"guide_length", "l_g", "mm", "m", "length of the follower's guide", 60, 1e-3, 1e5},
    kOverhang{"overhang",
              "a",
              "mm",
              "m",
              "distance of roller or edge from the guide at the lowest position",
              40,
              0,
              1e5};

/// The elastic train between cam and end, its stiffness in the unit of the follower's force by its
/// motion; without one, which is the default, the follower is rigid.
inline constexpr MachineParameter kTrainStiffness{
    "train_stiffness",
    "c_t",
    "N/mm",
    "N/m",
    "stiffness between the cam and the follower's end; 0 makes the follower "
    "rigid, and the responses of its end are undefined",
    0,
    0,
    1e9},
    kArmTrainStiffness{"train_stiffness",       "c_t", "N m/deg", "N m/rad",
                       kTrainStiffness.meaning, 0,     0,         1e9},
    kTrainDamping{"train_damping",
                  "zeta",
                  "1",
                  "1",
                  "damping ratio of the train: its damping over critical damping",
                  0.05,
                  0,
                  0.99},
    kEndShare{"end_share", "kappa", "1", "1", "fraction of the mass at the end of the train",
              1,           1e-6,    1},
    kArmEndShare = kEndShare.meaning_that("fraction of the inertia at the end of the train");

/// What the bearing of a roller, or of each of a pair, is made for, its face along its axis, and
/// what lubricates a contact.
inline constexpr MachineParameter kCrownRadius{
    "crown_radius", "R_c", "mm", "m", "radius of the roller's crown along its axis", 500, 1, 1e6},
    kDynamicRating{"dynamic_rating",
                   "C",
                   "kN",
                   "N",
                   "basic dynamic load rating of the roller's bearing",
                   10,
                   1e-3,
                   1e5},
    kStaticRating{"static_rating",
                  "C_0",
                  "kN",
                  "N",
                  "basic static load rating of the roller's bearing",
                  10,
                  1e-3,
                  1e5},
    kSpeedLimit{"speed_limit", "n_G", "rpm", "rad/s", "permissible speed of the roller on its pin",
                6000,          1e-3,  1e6},
    kViscosity{
        "viscosity", "eta", "mPa s", "Pa s", "viscosity of the lubricant at the contact's inlet",
        50,          1e-3,  1e6},
    kPressureViscosity{"pressure_viscosity",
                       "alpha",
                       "1/GPa",
                       "1/Pa",
                       "pressure-viscosity coefficient of the lubricant",
                       20,
                       1e-3,
                       1e3},
    kRoughness{"roughness",
               "R_q",
               "um",
               "m",
               "root mean square roughness of both surfaces, sqrt(R_q1^2 + R_q2^2)",
               0.4,
               1e-4,
               1e3};

}  // namespace camlaw::cams

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// Between the library and the plug-in that has Open CASCADE: plain C, as the plug-in is loaded by
/// name. All lengths are in mm, z is the cam's axis.

enum CamlawStepKind {
  kCamlawStepLine,   ///< points: begin, end
  kCamlawStepArc,    ///< points: centre, begin, end; counterclockwise, once round from end to end
  kCamlawStepSpline  ///< of degree 3: its control points
};

/// An edge of a loop in the plane.
struct CamlawStepEdge {
  int kind;
  std::size_t points;
  const double* point;      ///< x and y of each
  std::size_t knots;        ///< of splines; each once
  const double* knot;       ///< rising
  const int* multiplicity;  ///< of each knot
};

/// Edges that each begin where the one before ends, the first where the last does.
struct CamlawStepLoop {
  std::size_t edges;
  const CamlawStepEdge* edge;
};

/// What lies between two planes z within the first of its loops and outside the others.
struct CamlawStepPrism {
  double from, to;
  std::size_t loops;
  const CamlawStepLoop* loop;
};

/// A surface of degree 3 in both directions. The first parameter is the angle, the second the
/// distance from the axis.
struct CamlawStepSurface {
  std::size_t columns, rows;  ///< of control points
  const double* point;        ///< x, y, z of each, a column after the other
  std::size_t knots[2];       ///< each once, for both directions
  const double* knot[2];      ///< rising
  const int* multiplicity[2];
};

/// A groove round a body whose first loop is two halves of a circle, from 0 to 180 deg and on.
struct CamlawStepGroove {
  double floor, outside;       ///< distances from the axis
  CamlawStepSurface lower[2];  ///< of the flank, from 0 to 180 deg and on
  CamlawStepSurface upper[2];
};

struct CamlawStepSolid {
  CamlawStepPrism body;
  std::size_t cuts;  ///< that are taken out of the body from its upper end, where `to` is
  const CamlawStepPrism* cut;
  const CamlawStepGroove* groove;  ///< null: there is none
};

struct CamlawStepAsked {
  CamlawStepSolid solid;
  int in_inches;             ///< whether lengths are written in inches, else in mm
  const char* name;          ///< of the product
  const char* program;       ///< what the file is from
  std::size_t descriptions;  ///< lines of the header's description
  const char* const* description;
  void* self;
  /// Takes the next bytes of the file; throws nothing.
  void (*take)(void* self, const char* bytes, std::size_t count);
};

/// The solid as Open CASCADE measures it.
struct CamlawStepMade {
  double volume;      ///< mm^3
  std::size_t faces;  ///< how many it has
};

/// The function's name; its number grows when what is passed changes.
#define CAMLAW_STEP camlaw_step_1

extern "C" {
/// Builds the solid, checks it and hands the file over: nothing of it where something is wrong.
/// Null, or what went wrong, which lives until the thread's next call.
const char* CAMLAW_STEP(const CamlawStepAsked* asked, CamlawStepMade* made);
using CamlawStep = const char* (*)(const CamlawStepAsked* asked, CamlawStepMade* made);
}

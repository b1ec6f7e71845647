// SPDX-License-Identifier: MIT
#pragma once

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <cstddef>
#include <vector>

#include "output/export/solid/step_plugin.h"

/// Plane loops as Open CASCADE has them, and the prisms on them.
namespace camlaw::step {

TColStd_Array1OfReal knots_of(const double* knots, std::size_t count);
TColStd_Array1OfInteger counts_of(const int* counts, std::size_t count);

/// The loop in the plane z. Throws std::runtime_error where its edges do not meet.
TopoDS_Wire wire_of(const CamlawStepLoop& loop, double z);

/// A face in a plane z, within the first wire and outside the others. Throws std::runtime_error
/// where they bound none.
TopoDS_Face flat_face(const std::vector<TopoDS_Wire>& wires, double z);

/// What is above the prism's loops, up to the plane `to`.
TopoDS_Shape prism_of(const CamlawStepPrism& prism, double to);

}  // namespace camlaw::step

// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/exported_curve.h"
#include "output/export/shop_drawing.h"

/// Curves as a drawing: DXF of AutoCAD 2000 (AC1015; Autodesk, DXF Reference), one layer for
/// each curve.
namespace camlaw::problems {

/// Lines are one LWPOLYLINE, closed where the curve is; arcs single ARC and LINE entities in their
/// order; a spline one SPLINE of degree 3 by its control points, or of a curve with cusps one from
/// each cusp to the next: programs refuse a spline that turns back. Shapes are
/// LINE, CIRCLE, ARC and TEXT entities on their layers. `comments` stand at the beginning.
std::string dxf_text(const std::vector<ExportedCurve>& curves,
                     const std::vector<DrawnShape>& shapes, const LengthUnit& unit,
                     const std::vector<std::string>& comments);

/// The layer of a curve: "PITCH_CURVE".
std::string dxf_layer(const std::string& curve);

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "output/export/solid/step_barrel.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <array>
#include <cmath>
#include <gp.hxx>
#include <gp_Ax3.hxx>
#include <gp_Vec.hxx>
#include <numbers>
#include <utility>
#include <vector>

#include "output/export/solid/step_prism.h"

namespace camlaw::step {
namespace {

Handle(Geom_BSplineSurface) surface_of(const CamlawStepSurface& asked) {
  constexpr int kDegree = 3;  // the surface is cubic both ways
  TColgp_Array2OfPnt poles(1, static_cast<int>(asked.columns), 1, static_cast<int>(asked.rows));
  for (std::size_t i = 0; i < asked.columns; ++i) {
    for (std::size_t j = 0; j < asked.rows; ++j) {
      const double* p = asked.point + 3 * (i * asked.rows + j);
      poles.SetValue(static_cast<int>(i) + 1, static_cast<int>(j) + 1, gp_Pnt(p[0], p[1], p[2]));
    }
  }
  const auto knots = [&](int direction) {
    return knots_of(asked.knot[direction], asked.knots[direction]);
  };
  const auto counts = [&](int direction) {
    return counts_of(asked.multiplicity[direction], asked.knots[direction]);
  };
  return new Geom_BSplineSurface(poles, knots(0), knots(1), counts(0), counts(1), kDegree, kDegree);
}

/// An edge on a surface: the same curve by its two parameters.
void lay(const TopoDS_Edge& edge, const Handle(Geom2d_Curve) & curve,
         const Handle(Geom_Surface) & surface) {
  BRep_Builder().UpdateEdge(edge, curve, surface, TopLoc_Location(), Precision::Confusion());
}

/// A face between four edges. Of the surface's parameters the first is the angle, and rises along
/// `low` and `high`; the second rises from low to high, along `begin` and `end`.
TopoDS_Face face_between(const Handle(Geom_Surface) & surface, const TopoDS_Edge& low,
                         const TopoDS_Edge& end, const TopoDS_Edge& high,
                         const TopoDS_Edge& begin) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, low);
  builder.Add(wire, end);
  builder.Add(wire, high.Reversed());
  builder.Add(wire, begin.Reversed());
  wire.Closed(true);
  TopoDS_Face face;
  builder.MakeFace(face, surface, Precision::Confusion());
  builder.Add(face, wire);
  return face;
}

Handle(Geom2d_Curve) along_angle(double second) {
  return new Geom2d_Line(gp_Pnt2d(0, second), gp_Dir2d(1, 0));
}
Handle(Geom2d_Curve) across_angle(double angle) {
  return new Geom2d_Line(gp_Pnt2d(angle, 0), gp_Dir2d(0, 1));
}

/// Where a half turn begins and ends: vertices from the lower end of the barrel along its outside,
/// down into the groove and out of it to the upper end, and the edges between them, each rising
/// along z or away from the axis.
struct Seam {
  std::array<TopoDS_Vertex, 6> vertex;  ///< lower end, lower rim, lower foot, upper foot, rim, end
  TopoDS_Edge below, lower, floor, upper, above;
};

/// Half of a barrel with its groove: an edge round the axis for each of the vertices, and the
/// surfaces between.
class BarrelHalf {
 public:
  BarrelHalf(const CamlawStepPrism& body, const CamlawStepGroove& groove, std::size_t half)
      : body_(body),
        groove_(groove),
        from_(half == 0 ? 0 : std::numbers::pi),
        to_(half == 0 ? std::numbers::pi : 2 * std::numbers::pi),
        lower_(surface_of(groove.lower[half])),
        upper_(surface_of(groove.upper[half])) {}

  /// The vertices and edges at its beginning.
  Seam seam() const {
    Seam seam;
    const std::array<gp_Pnt, 6> at{
        on(groove_.outside, body_.from),       lower_->Value(from_, groove_.outside),
        lower_->Value(from_, groove_.floor),   upper_->Value(from_, groove_.floor),
        upper_->Value(from_, groove_.outside), on(groove_.outside, body_.to)};
    for (std::size_t i = 0; i < at.size(); ++i) {
      seam.vertex[i] = BRepBuilderAPI_MakeVertex(at[i]);
    }
    const auto& v = seam.vertex;
    const auto upright = [&](double distance, std::size_t from, std::size_t to) {
      const Handle(Geom_Line) line = new Geom_Line(on(distance, 0), gp_Dir(0, 0, 1));
      return edge(line, v[from], v[to], at[from].Z(), at[to].Z());
    };
    seam.below = upright(groove_.outside, 0, 1);
    seam.floor = upright(groove_.floor, 2, 3);
    seam.above = upright(groove_.outside, 4, 5);
    seam.lower = edge(lower_->UIso(from_), v[2], v[1], groove_.floor, groove_.outside);
    seam.upper = edge(upper_->UIso(from_), v[3], v[4], groove_.floor, groove_.outside);
    return seam;
  }

  /// Its faces, and the edges of both ends: the lower one's first.
  std::pair<std::vector<TopoDS_Face>, std::array<TopoDS_Edge, 2>> faces(const Seam& begin,
                                                                        const Seam& end) const {
    const auto turn = [&](const Handle(Geom_Curve) & curve, std::size_t i) {
      return edge(curve, begin.vertex[i], end.vertex[i], from_, to_);
    };
    const std::array<TopoDS_Edge, 6> round{turn(circle(body_.from), 0),
                                           turn(lower_->VIso(groove_.outside), 1),
                                           turn(lower_->VIso(groove_.floor), 2),
                                           turn(upper_->VIso(groove_.floor), 3),
                                           turn(upper_->VIso(groove_.outside), 4),
                                           turn(circle(body_.to), 5)};
    const auto flank = [&](const Handle(Geom_BSplineSurface) & surface, std::size_t foot,
                           std::size_t rim, const TopoDS_Edge& at_begin,
                           const TopoDS_Edge& at_end) {
      lay(round[foot], along_angle(groove_.floor), surface);
      lay(round[rim], along_angle(groove_.outside), surface);
      lay(at_begin, across_angle(from_), surface);
      lay(at_end, across_angle(to_), surface);
      return face_between(surface, round[foot], at_end, round[rim], at_begin);
    };
    const auto band = [&](double radius, std::size_t low, std::size_t high,
                          const TopoDS_Edge& at_begin, const TopoDS_Edge& at_end) {
      const Handle(Geom_CylindricalSurface) surface =
          new Geom_CylindricalSurface(gp_Ax3(gp::XOY()), radius);
      lay(round[low], on_cylinder(low), surface);
      lay(round[high], on_cylinder(high), surface);
      lay(at_begin, across_angle(from_), surface);
      lay(at_end, across_angle(to_), surface);
      return face_between(surface, round[low], at_end, round[high], at_begin);
    };
    return {{band(groove_.outside, 0, 1, begin.below, end.below),
             flank(lower_, 2, 1, begin.lower, end.lower),
             band(groove_.floor, 2, 3, begin.floor, end.floor),
             flank(upper_, 3, 4, begin.upper, end.upper),
             band(groove_.outside, 4, 5, begin.above, end.above)},
            {round[0], round[5]}};
  }

 private:
  gp_Pnt on(double distance, double z) const {
    return {distance * std::cos(from_), distance * std::sin(from_), z};
  }
  Handle(Geom_Curve) circle(double z) const {
    return new Geom_Circle(gp_Ax2(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0)),
                           groove_.outside);
  }
  static TopoDS_Edge edge(const Handle(Geom_Curve) & curve, const TopoDS_Vertex& from,
                          const TopoDS_Vertex& to, double begin, double end) {
    return BRepBuilderAPI_MakeEdge(curve, from, to, begin, end);
  }

  /// The i-th edge round the axis by the parameters of a cylinder, angle and z.
  Handle(Geom2d_Curve) on_cylinder(std::size_t i) const {
    if (i == 0) return along_angle(body_.from);
    if (i == 5) return along_angle(body_.to);
    const Handle(Geom_BSplineSurface) flank = i < 3 ? lower_ : upper_;
    const bool at_floor = i == 2 || i == 3;
    // The angle is linear in itself: its control points are the means of three knots that follow.
    const int count = flank->NbUPoles(), row = at_floor ? 1 : flank->NbVPoles();
    const TColStd_Array1OfReal& sequence = flank->UKnotSequence();
    TColgp_Array1OfPnt2d poles(1, count);
    for (int k = 1; k <= count; ++k) {
      const double angle = (sequence(k + 1) + sequence(k + 2) + sequence(k + 3)) / 3;
      poles.SetValue(k, gp_Pnt2d(angle, flank->Pole(k, row).Z()));
    }
    return new Geom2d_BSplineCurve(poles, flank->UKnots(), flank->UMultiplicities(), 3);
  }

  const CamlawStepPrism& body_;
  const CamlawStepGroove& groove_;
  double from_, to_;
  Handle(Geom_BSplineSurface) lower_, upper_;
};

}  // namespace

TopoDS_Solid barrel_of(const CamlawStepPrism& body, const CamlawStepGroove& groove) {
  const std::array<BarrelHalf, 2> halves{BarrelHalf(body, groove, 0), BarrelHalf(body, groove, 1)};
  const std::array<Seam, 2> seams{halves[0].seam(), halves[1].seam()};
  BRepBuilderAPI_Sewing sewing;
  std::array<BRepBuilderAPI_MakeWire, 2> rims;
  for (std::size_t half = 0; half < 2; ++half) {
    const auto [faces, ends] = halves[half].faces(seams[half], seams[1 - half]);
    for (const TopoDS_Face& face : faces) sewing.Add(face);
    for (std::size_t end = 0; end < 2; ++end) rims[end].Add(ends[end]);
  }
  std::array<std::vector<TopoDS_Wire>, 2> loops{{{rims[0].Wire()}, {rims[1].Wire()}}};
  for (std::size_t i = 1; i < body.loops; ++i) {
    BRepPrimAPI_MakePrism hole(wire_of(body.loop[i], body.from), gp_Vec(0, 0, body.to - body.from));
    for (TopExp_Explorer faces(hole.Shape(), TopAbs_FACE); faces.More(); faces.Next()) {
      sewing.Add(faces.Current());
    }
    loops[0].push_back(TopoDS::Wire(hole.FirstShape()));
    loops[1].push_back(TopoDS::Wire(hole.LastShape()));
  }
  for (std::size_t end = 0; end < 2; ++end) {
    sewing.Add(flat_face(loops[end], end == 0 ? body.from : body.to));
  }
  sewing.Perform();
  BRepBuilderAPI_MakeSolid solid;
  for (TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL); shells.More(); shells.Next()) {
    solid.Add(TopoDS::Shell(shells.Current()));
  }
  TopoDS_Solid result = solid.Solid();
  BRepLib::OrientClosedSolid(result);
  return result;
}

}  // namespace camlaw::step

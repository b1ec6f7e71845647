// SPDX-License-Identifier: MIT
#include "output/export/solid/step_prism.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Geom_BSplineCurve.hxx>
#include <ShapeFix_Face.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>
#include <stdexcept>
#include <vector>

namespace camlaw::step {

TColStd_Array1OfReal knots_of(const double* knots, std::size_t count) {
  TColStd_Array1OfReal all(1, static_cast<int>(count));
  for (std::size_t i = 0; i < count; ++i) all.SetValue(static_cast<int>(i) + 1, knots[i]);
  return all;
}

TColStd_Array1OfInteger counts_of(const int* counts, std::size_t count) {
  TColStd_Array1OfInteger all(1, static_cast<int>(count));
  for (std::size_t i = 0; i < count; ++i) all.SetValue(static_cast<int>(i) + 1, counts[i]);
  return all;
}

namespace {

gp_Pnt point_of(const CamlawStepEdge& edge, std::size_t i, double z) {
  return {edge.point[2 * i], edge.point[2 * i + 1], z};
}

gp_Pnt begin_of(const CamlawStepEdge& edge, double z) {
  return point_of(edge, edge.kind == kCamlawStepArc ? 1 : 0, z);
}

Handle(Geom_BSplineCurve) spline_of(const CamlawStepEdge& edge, double z) {
  constexpr int kDegree = 3;  // cubic_path() makes cubics
  TColgp_Array1OfPnt poles(1, static_cast<int>(edge.points));
  for (std::size_t i = 0; i < edge.points; ++i) {
    poles.SetValue(static_cast<int>(i) + 1, point_of(edge, i, z));
  }
  return new Geom_BSplineCurve(poles, knots_of(edge.knot, edge.knots),
                               counts_of(edge.multiplicity, edge.knots), kDegree);
}

TopoDS_Edge edge_of(const CamlawStepEdge& edge, double z, const TopoDS_Vertex& from,
                    const TopoDS_Vertex& to) {
  if (edge.kind == kCamlawStepLine) return BRepBuilderAPI_MakeEdge(from, to);
  if (edge.kind == kCamlawStepSpline) return BRepBuilderAPI_MakeEdge(spline_of(edge, z), from, to);
  const gp_Pnt centre = point_of(edge, 0, z);
  const gp_Vec out(centre, begin_of(edge, z));
  const gp_Circ circle(gp_Ax2(centre, gp_Dir(0, 0, 1), gp_Dir(out)), out.Magnitude());
  return BRepBuilderAPI_MakeEdge(circle, from, to);
}

}  // namespace

TopoDS_Wire wire_of(const CamlawStepLoop& loop, double z) {
  std::vector<TopoDS_Vertex> begins;
  for (std::size_t i = 0; i < loop.edges; ++i) {
    begins.push_back(BRepBuilderAPI_MakeVertex(begin_of(loop.edge[i], z)));
  }
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < loop.edges; ++i) {
    wire.Add(edge_of(loop.edge[i], z, begins[i], begins[(i + 1) % loop.edges]));
    if (!wire.IsDone()) throw std::runtime_error("the edges of a loop do not meet");
  }
  return wire;
}

TopoDS_Face flat_face(const std::vector<TopoDS_Wire>& wires, double z) {
  BRepBuilderAPI_MakeFace face(gp_Pln(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), wires.front());
  for (std::size_t i = 1; i < wires.size(); ++i) face.Add(wires[i]);
  if (!face.IsDone()) throw std::runtime_error("the loops do not bound a face");
  ShapeFix_Face fix(face.Face());
  fix.FixOrientation();
  return fix.Face();
}

TopoDS_Shape prism_of(const CamlawStepPrism& prism, double to) {
  std::vector<TopoDS_Wire> wires;
  for (std::size_t i = 0; i < prism.loops; ++i) {
    wires.push_back(wire_of(prism.loop[i], prism.from));
  }
  return BRepPrimAPI_MakePrism(flat_face(wires, prism.from), gp_Vec(0, 0, to - prism.from));
}

}  // namespace camlaw::step

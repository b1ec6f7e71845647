// SPDX-License-Identifier: MIT
#include "output/export/solid/step_plugin.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Interface_FloatWriter.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Precision.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <ShapeFix_Face.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <XSControl_WorkSession.hxx>
#include <array>
#include <cmath>
#include <exception>
#include <gp.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>
#include <mutex>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

gp_Pnt point_of(const CamlawStepEdge& edge, std::size_t i, double z) {
  return {edge.point[2 * i], edge.point[2 * i + 1], z};
}

gp_Pnt begin_of(const CamlawStepEdge& edge, double z) {
  return point_of(edge, edge.kind == kCamlawStepArc ? 1 : 0, z);
}

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

Handle(Geom_BSplineCurve) spline_of(const CamlawStepEdge& edge, double z) {
  constexpr int kDegree = 3;
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

/// A face in a plane z, within the first wire and outside the others.
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

/// The only solid that there is in a shape.
TopoDS_Solid only_solid(const TopoDS_Shape& shape) {
  TopExp_Explorer solids(shape, TopAbs_SOLID);
  if (!solids.More()) throw std::runtime_error("nothing is left of the solid");
  TopoDS_Solid solid = TopoDS::Solid(solids.Current());
  solids.Next();
  if (solids.More()) throw std::runtime_error("the solid falls apart");
  return solid;
}

Handle(Geom_BSplineSurface) surface_of(const CamlawStepSurface& asked) {
  constexpr int kDegree = 3;
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

/// A barrel with its groove, its faces built one by one: no surfaces are cut with each other.
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

TopoDS_Solid built(const CamlawStepSolid& asked) {
  if (asked.groove != nullptr) return barrel_of(asked.body, *asked.groove);
  TopoDS_Shape shape = prism_of(asked.body, asked.body.to);
  for (std::size_t i = 0; i < asked.cuts; ++i) {
    // A cut that ends above the body has no face in common with it.
    const double beyond = 2 * asked.cut[i].to - asked.cut[i].from;
    BRepAlgoAPI_Cut cut(shape, prism_of(asked.cut[i], beyond));
    if (!cut.IsDone() || cut.HasErrors()) throw std::runtime_error("the groove cannot be cut");
    shape = cut.Shape();
  }
  return only_solid(shape);
}

std::size_t faces_of(const TopoDS_Solid& solid) {
  std::size_t count = 0;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) ++count;
  return count;
}

CamlawStepMade checked(const TopoDS_Solid& solid) {
  if (!BRepCheck_Analyzer(solid).IsValid()) {
    throw std::runtime_error("Open CASCADE finds that the solid is not valid");
  }
  for (TopExp_Explorer shells(solid, TopAbs_SHELL); shells.More(); shells.Next()) {
    if (!BRep_Tool::IsClosed(shells.Current())) {
      throw std::runtime_error("Open CASCADE finds that the solid is not closed");
    }
  }
  // By Gauss and Kronrod: what Open CASCADE does without them is wrong by 1e-5 along splines.
  constexpr double kVolume = 1e-9;  // of the whole
  GProp_GProps properties;
  BRepGProp::VolumePropertiesGK(solid, properties, kVolume, false, true);
  return {properties.Mass(), faces_of(solid)};
}

Handle(TCollection_HAsciiString) text(const char* words) {
  return new TCollection_HAsciiString(words);
}

/// The same file tomorrow: it has no time, for which the header needs one.
void describe(const CamlawStepAsked& asked, const Handle(StepData_StepModel) & model) {
  APIHeaderSection_MakeHeader header(model);
  header.SetName(text(asked.name));
  header.SetTimeStamp(text("1970-01-01T00:00:00"));
  header.SetPreprocessorVersion(text(asked.program));
  header.SetOriginatingSystem(text(asked.program));
  header.SetAuthorValue(1, text(""));
  header.SetOrganizationValue(1, text(""));
  header.SetAuthorisation(text(""));
  const int count = static_cast<int>(asked.descriptions);
  if (count == 0) return;
  Handle(Interface_HArray1OfHAsciiString) lines = new Interface_HArray1OfHAsciiString(1, count);
  for (int i = 0; i < count; ++i) lines->SetValue(i + 1, text(asked.description[i]));
  header.SetDescription(lines);
}

/// Open CASCADE puts a number behind the name.
void name_product(const CamlawStepAsked& asked, const Handle(StepData_StepModel) & model) {
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto product = Handle(StepBasic_Product)::DownCast(model->Entity(i));
    if (product.IsNull()) continue;
    product->SetId(text(asked.name));
    product->SetName(text(asked.name));
  }
}

std::string written(const CamlawStepAsked& asked, const TopoDS_Solid& solid) {
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", asked.in_inches != 0 ? "INCH" : "MM");
  STEPControl_Writer writer;
  if (writer.Transfer(solid, STEPControl_ManifoldSolidBrep) != IFSelect_RetDone) {
    throw std::runtime_error("Open CASCADE cannot write the solid");
  }
  const Handle(StepData_StepModel) model = writer.Model();
  describe(asked, model);
  name_product(asked, model);
  StepData_StepWriter file(model);
  file.FloatWriter().SetFormat("%.14E");
  file.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ostringstream stream;
  file.Print(stream);
  return std::move(stream).str();
}

}  // namespace

extern "C" const char* CAMLAW_STEP(const CamlawStepAsked* asked, CamlawStepMade* made) {
  // Open CASCADE keeps what it writes in, and how, for the whole process.
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  thread_local std::string error;
  try {
    Message::DefaultMessenger()->ChangePrinters().Clear();  // which print on standard output
    const TopoDS_Solid solid = built(asked->solid);
    *made = checked(solid);
    const std::string file = written(*asked, solid);
    asked->take(asked->self, file.data(), file.size());
    return nullptr;
  } catch (const Standard_Failure& failure) {
    const char* message = failure.GetMessageString();
    error = std::string(failure.DynamicType()->Name()) + ": " + (message != nullptr ? message : "");
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  return error.c_str();
}

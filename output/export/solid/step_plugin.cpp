// SPDX-License-Identifier: MIT
#include "output/export/solid/step_plugin.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Interface_FloatWriter.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
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
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <XSControl_WorkSession.hxx>
#include <exception>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

gp_Pnt point_of(const CamlawStepEdge& edge, std::size_t i, double z) {
  return {edge.point[2 * i], edge.point[2 * i + 1], z};
}

gp_Pnt begin_of(const CamlawStepEdge& edge, double z) {
  return point_of(edge, edge.kind == kCamlawStepArc ? 1 : 0, z);
}

Handle(Geom_BSplineCurve) spline_of(const CamlawStepEdge& edge, double z) {
  constexpr int kDegree = 3;
  TColgp_Array1OfPnt poles(1, static_cast<int>(edge.points));
  for (std::size_t i = 0; i < edge.points; ++i) {
    poles.SetValue(static_cast<int>(i) + 1, point_of(edge, i, z));
  }
  const int count = static_cast<int>(edge.knots);
  TColStd_Array1OfReal knots(1, count);
  TColStd_Array1OfInteger multiplicities(1, count);
  for (int i = 0; i < count; ++i) {
    knots.SetValue(i + 1, edge.knot[i]);
    multiplicities.SetValue(i + 1, edge.multiplicity[i]);
  }
  return new Geom_BSplineCurve(poles, knots, multiplicities, kDegree);
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

TopoDS_Shape prism_of(const CamlawStepPrism& prism, double to) {
  const gp_Pln plane(gp_Pnt(0, 0, prism.from), gp_Dir(0, 0, 1));
  BRepBuilderAPI_MakeFace face(plane, wire_of(prism.loop[0], prism.from));
  for (std::size_t i = 1; i < prism.loops; ++i) face.Add(wire_of(prism.loop[i], prism.from));
  if (!face.IsDone()) throw std::runtime_error("the loops do not bound a face");
  ShapeFix_Face fix(face.Face());
  fix.FixOrientation();
  return BRepPrimAPI_MakePrism(fix.Face(), gp_Vec(0, 0, to - prism.from));
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

TopoDS_Solid built(const CamlawStepSolid& asked) {
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

// SPDX-License-Identifier: MIT
#include "output/export/solid/step_plugin.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Interface_FloatWriter.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <XSControl_WorkSession.hxx>
#include <exception>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "output/export/solid/step_barrel.h"
#include "output/export/solid/step_prism.h"

namespace camlaw::step {
namespace {

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
}  // namespace camlaw::step

extern "C" const char* CAMLAW_STEP(const CamlawStepAsked* asked, CamlawStepMade* made) {
  // Open CASCADE keeps what it writes in, and how, for the whole process.
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  thread_local std::string error;
  try {
    Message::DefaultMessenger()->ChangePrinters().Clear();  // which print on standard output
    const TopoDS_Solid solid = camlaw::step::built(asked->solid);
    *made = camlaw::step::checked(solid);
    const std::string file = camlaw::step::written(*asked, solid);
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

// SPDX-License-Identifier: MIT
#include "output/export/drives/drive_files.h"

#include <fmt/format.h>

#include <cmath>

#include "output/export/exported_curve.h"

namespace camlaw::problems {
namespace {

/// Decimals of degrees and millimetres, far below what a drive resolves.
constexpr int kDecimals = 9;

/// A place or a position as it is rounded already.
std::string fixed_text(double value) { return fmt::format("{:.{}f}", value + 0.0, kDecimals); }

/// A literal of IEC 61131-3 with all digits of a double.
std::string real_text(double value) { return value == 0 ? "0.0" : fmt::format("{:.16E}", value); }

std::string comment_lines(std::span<const std::string> comments) {
  std::string text;
  for (const std::string& comment : comments)
    text += fmt::format("(* {} *)\n", plain_text(comment));
  return text;
}

/// The elements of an array, one each line, with commas between them.
template <class Element>
std::string elements(const PiecewiseMotion& path, const Element& element) {
  std::string text;
  for (std::size_t i = 0; i < path.knots.size(); ++i) {
    text += "        " + element(i, path.knots[i]) + (i + 1 < path.knots.size() ? ",\n" : "];\n");
  }
  return text;
}

/// Whether the places are even as far as their last digit tells.
bool is_even(const PiecewiseMotion& path) {
  const auto& knots = path.knots;
  const double step =
      (knots.back().master - knots.front().master) / static_cast<double>(knots.size() - 1);
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double even = knots.front().master + step * static_cast<double>(i);
    if (std::abs(knots[i].master - even) > 1.1 * std::pow(10.0, -kDecimals)) return false;
  }
  return true;
}

std::string beckhoff_points(const PiecewiseMotion& path, std::span<const std::string> comments) {
  const std::size_t count = path.knots.size();
  return comment_lines(comments) +
         fmt::format("VAR_GLOBAL\n    CamPoints : ARRAY[0..{}, 0..1] OF LREAL := [\n", count - 1) +
         elements(path,
                  [](std::size_t, const MotionKnot& k) {
                    return fixed_text(k.master) + ", " + fixed_text(k.s);
                  }) +
         fmt::format(
             "    Cam : MC_CAM_REF := (\n"
             "        pArray := ADR(CamPoints), ArraySize := SIZEOF(CamPoints),\n"
             "        TableType := {}, NoOfRows := {}, NoOfColumns := 2);\nEND_VAR\n",
             is_even(path) ? "MC_TABLETYPE_EQUIDISTANT" : "MC_TABLETYPE_NONEQUIDISTANT", count);
}

std::string beckhoff_motion(const PiecewiseMotion& path, std::span<const std::string> comments) {
  const std::size_t count = path.knots.size();
  return comment_lines(comments) +
         fmt::format("VAR_GLOBAL\n    CamPoints : ARRAY[1..{}] OF MC_MotionFunctionPoint := [\n",
                     count) +
         elements(
             path,
             [&](std::size_t i, const MotionKnot& k) {
               return fmt::format(
                   "(PointIndex := {}, FunctionType := MOTIONFUNCTYPE_POLYNOM5_MM, PointType := "
                   "MOTIONPOINTTYPE_MOTION, RelIndexNextPoint := {}, MasterPos := {}, SlavePos "
                   ":= {}, SlaveVelo := {}, SlaveAcc := {}, SlaveJerk := 0.0)",
                   i + 1, i + 1 < count ? 1 : 0, fixed_text(k.master), fixed_text(k.s),
                   real_text(k.v), real_text(k.a));
             }) +
         fmt::format(
             "    Cam : MC_CAM_REF := (\n"
             "        pArray := ADR(CamPoints), ArraySize := SIZEOF(CamPoints),\n"
             "        TableType := MC_TABLETYPE_MOTIONFUNCTION, NoOfRows := {}, NoOfColumns "
             ":= 1);\nEND_VAR\n",
             count);
}

std::string codesys(const PiecewiseMotion& path, std::span<const std::string> comments) {
  const std::size_t count = path.knots.size();
  return comment_lines(comments) +
         fmt::format(
             "{{attribute 'linkalways'}}\nVAR_GLOBAL\n"
             "    Cam_A : ARRAY[0..{}] OF SMC_CAMXYVA := [\n",
             count - 1) +
         elements(path,
                  [](std::size_t, const MotionKnot& k) {
                    return fmt::format("(dX := {}, dY := {}, dV := {}, dA := {})",
                                       fixed_text(k.master), fixed_text(k.s), real_text(k.v),
                                       real_text(k.a));
                  }) +
         fmt::format(
             "    Cam : MC_CAM_REF := (nElements := {}, byType := 3, xStart := {}, xEnd := "
             "{}, nTappets := 0, strCAMName := 'Cam', pce := ADR(Cam_A), xPartofLM := "
             "TRUE);\nEND_VAR\n",
             count, fixed_text(path.knots.front().master), fixed_text(path.knots.back().master));
}

/// A comment may only stand behind the two numbers of a line.
std::string lenze(const PiecewiseMotion& path, std::span<const std::string> comments) {
  std::string text;
  for (std::size_t i = 0; i < path.knots.size(); ++i) {
    text += fixed_text(path.knots[i].master) + " " + fixed_text(path.knots[i].s);
    const bool last = i + 1 == path.knots.size();
    for (std::size_t c = i; c < comments.size() && (c == i || last); ++c) {
      text += (c == i ? " // " : "; ") + plain_text(comments[c]);
    }
    text += "\n";
  }
  return text;
}

std::string rockwell(const PiecewiseMotion& path, std::span<const std::string> comments) {
  std::string text = comment_lines(comments);
  const auto single = [](double value) {
    return value == 0 ? std::string("0.0") : fmt::format("{:.8E}", static_cast<float>(value));
  };
  for (std::size_t i = 0; i < path.knots.size(); ++i) {
    const MotionKnot& k = path.knots[i];
    text +=
        fmt::format("Cam[{0}].Master := {1}; Cam[{0}].Slave := {2}; Cam[{0}].SegmentType := 1;\n",
                    i, single(k.master), single(k.s));
  }
  return text + fmt::format("MCCP(CamCalculate, Cam[0], {}, {}, {}, CamProfile[0]);\n",
                            path.knots.size(), single(path.knots.front().v),
                            single(path.knots.back().v));
}

std::string siemens(const PiecewiseMotion& path, std::span<const std::string> comments) {
  return comment_lines(comments) +
         fmt::format(
             "USING Simatic.Ax.LCamHdl;\nCONFIGURATION CamConfiguration\n    VAR_GLOBAL\n"
             "        camProfile : ARRAY[1..{}] OF LCamHdl_typeBasicPoint := [\n",
             path.knots.size()) +
         elements(path,
                  [](std::size_t, const MotionKnot& k) {
                    return fmt::format(
                        "(leadingValue := {}, followingValue := {}, velocityRatio := "
                        "{}, accelerationRatio := {})",
                        fixed_text(k.master), fixed_text(k.s), real_text(k.v), real_text(k.a));
                  }) +
         "    END_VAR\nEND_CONFIGURATION\n";
}

}  // namespace

const std::vector<DriveFormat>& drive_formats() {
  using P = DrivePath;
  // A drive that states no limit itself takes kMany; the basic cam of LCamHdl has 50 segments.
  constexpr std::size_t kMany = 10000, kSegmentsOfCam = 50;
  static const std::vector<DriveFormat> formats{
      {"beckhoff-points",
       "Beckhoff Information System, TF5050 TC3 NC Camming: MC_CAM_REF, example 1, and "
       "MC_TableType",
       P::Lines, kDecimals, kMany, beckhoff_points},
      {"beckhoff-motion",
       "Beckhoff Information System, TF5050 TC3 NC Camming: MC_CAM_REF, example 2, "
       "MC_MotionFunctionPoint, MC_MotionFunctionType and MC_MotionPointType",
       P::Quintics, kDecimals, kMany, beckhoff_motion},
      {"codesys",
       "CODESYS Online Help, SoftMotion: Display Generated Code, and SM3_Basic: MC_CAM_REF and "
       "SMC_CAM_TYPE",
       P::Quintics, kDecimals, kMany, codesys},
      {"lenze", "Lenze, Global Drive Cam Loader 1.1 EN, 05/2005, section 4.2.1", P::Lines,
       kDecimals, kMany, lenze},
      {"rockwell",
       "Rockwell Automation, MOTION-RM002H-EN-P, February 2018: MCCP, and the CAM data type in "
       "chapter 10",
       P::Spline, 0, kMany, rockwell},
      {"siemens",
       "Siemens, SIMATIC AX library LCamHdl: LCamHdl_CreateCamBasic and LCamHdl_typeBasicPoint",
       P::Quintics, kDecimals, kSegmentsOfCam, siemens}};
  return formats;
}

}  // namespace camlaw::problems

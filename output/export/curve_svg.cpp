// SPDX-License-Identifier: MIT
#include "output/export/curve_svg.h"

#include <algorithm>
#include <iterator>
#include <numbers>

#include "output/export/xml_text.h"

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

constexpr double kMargin = 5, kPen = 0.25;  // mm

/// Down is greater y in a picture.
std::string place(const Vector2d& p) {
  return fmt::format("{:.6f} {:.6f}", rounded(p.x(), 6), rounded(-p.y(), 6));
}

std::string way_of(const ExportedCurve& curve) {
  std::string way = "M " + place(curve.joints().front());
  const auto add = [&](const std::string& text) { way += " " + text; };
  if (const auto* chords = std::get_if<Chords>(&curve.path)) {
    for (std::size_t i = 1; i < chords->points.size(); ++i) add("L " + place(chords->points[i].at));
  } else if (const auto* arcs = std::get_if<ArcPath>(&curve.path)) {
    for (const ArcPiece& piece : arcs->pieces) {
      if (piece.is_line()) {
        add("L " + place(piece.to));
        continue;
      }
      add(fmt::format("A {0:.6f} {0:.6f} 0 {1} {2} {3}", piece.radius(),
                      std::abs(piece.sweep) > std::numbers::pi ? 1 : 0, piece.sweep > 0 ? 0 : 1,
                      place(piece.to)));
    }
  } else {
    for (const CubicPiece& piece : std::get<CubicPath>(curve.path).pieces) {
      add("C " + place(piece.control[1]) + " " + place(piece.control[2]) + " " +
          place(piece.control[3]));
    }
  }
  return curve.closed ? way + " Z" : way;
}

std::string id_of(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

}  // namespace

std::string svg_text(const std::vector<ExportedCurve>& curves, const LengthUnit& unit,
                     const std::string& title, const std::vector<std::string>& comments) {
  constexpr const char* kColours[] = {"#000000", "#0072b2", "#009e73", "#b00020"};
  const Extent extent = extent_of(curves);
  const double margin = kMargin / unit.mm;
  const Vector2d size = extent.high - extent.low + Vector2d::Constant(2 * margin);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.6f}{5}\" height=\"{1:.6f}{5}\" "
      "viewBox=\"{2:.6f} {3:.6f} {0:.6f} {1:.6f}\">\n<title>{4}</title>\n<desc>",
      size.x(), size.y(), extent.low.x() - margin, -extent.high.y() - margin, xml_escape(title),
      unit.name);
  for (const std::string& comment : comments) text += xml_escape(comment) + "\n";
  text += fmt::format("</desc>\n<g fill=\"none\" stroke-width=\"{:.6g}\">\n", kPen / unit.mm);
  const bool centred =
      curves.front().closed && (extent.low.array() <= 0).all() && (extent.high.array() >= 0).all();
  if (centred) {
    text += fmt::format(
        "<path id=\"centre\" stroke=\"#777777\" d=\"M -{0:.6g} 0 H {0:.6g} M 0 -{0:.6g} V "
        "{0:.6g}\"/>\n",
        2 / unit.mm);
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    text += fmt::format("<path id=\"{}\" stroke=\"{}\" d=\"{}\"><title>{}</title></path>\n",
                        id_of(curves[i].name), kColours[i % 4], way_of(curves[i]),
                        xml_escape(curves[i].name));
  }
  return text + "</g>\n</svg>\n";
}

}  // namespace camlaw::problems

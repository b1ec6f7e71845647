// SPDX-License-Identifier: MIT
#include "output/export/dxf.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "output/export/dxf_frame.h"

namespace camlaw::problems {
namespace {

using dxf::Tags;
using Eigen::Vector2d;

/// Entities with handles that count up.
class Entities {
 public:
  explicit Entities(Tags& tags) : tags_(tags) {}
  int next() const { return next_; }

  void add(const ExportedCurve& curve) {
    layer_ = dxf_layer(curve.name);
    if (const auto* chords = std::get_if<Chords>(&curve.path)) {
      polyline(*chords, curve.closed);
    } else if (const auto* arcs = std::get_if<ArcPath>(&curve.path)) {
      for (const ArcPiece& piece : arcs->pieces) piece.is_line() ? line(piece) : arc(piece);
    } else {
      for (const CubicPath& run : std::get<CubicPath>(curve.path).runs_between_cusps()) spline(run);
    }
  }

  void add(const DrawnShape& shape) {
    layer_ = shape.layer;
    if (const auto* line = std::get_if<DrawnLine>(&shape.shape)) {
      begin("LINE", "AcDbLine");
      tags_.point(10, line->from);
      tags_.point(11, line->to);
    } else if (const auto* arc = std::get_if<DrawnArc>(&shape.shape)) {
      const bool whole = arc->to - arc->from >= 360;
      begin(whole ? "CIRCLE" : "ARC", "AcDbCircle");
      tags_.point(10, arc->centre);
      tags_.real(40, arc->radius);
      if (whole) return;
      tags_.text(100, "AcDbArc");
      tags_.real(50, std::fmod(arc->from, 360));
      tags_.real(51, std::fmod(arc->to, 360));
    } else {
      const auto& text = std::get<DrawnText>(shape.shape);
      begin("TEXT", "AcDbText");
      tags_.point(10, text.at);
      tags_.real(40, text.height);
      tags_.text(1, plain_text(text.text));
      tags_.text(100, "AcDbText");
    }
  }

 private:
  void begin(const char* type, const char* subclass) {
    tags_.text(0, type);
    tags_.handle(5, next_++);
    tags_.handle(330, dxf::kModel);
    tags_.text(100, "AcDbEntity");
    tags_.text(8, layer_);
    tags_.text(100, subclass);
  }

  void polyline(const Chords& chords, bool closed) {
    const std::size_t count = chords.points.size() - (closed ? 1 : 0);
    begin("LWPOLYLINE", "AcDbPolyline");
    tags_.integer(90, static_cast<int>(count));
    tags_.integer(70, closed ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) {
      tags_.real(10, chords.points[i].at.x());
      tags_.real(20, chords.points[i].at.y());
    }
  }

  void line(const ArcPiece& piece) {
    begin("LINE", "AcDbLine");
    tags_.point(10, piece.from);
    tags_.point(11, piece.to);
  }

  /// An ARC runs counterclockwise.
  void arc(const ArcPiece& piece) {
    const auto angle = [&](const Vector2d& p) {
      const Vector2d way = p - piece.centre;
      const double degrees = std::atan2(way.y(), way.x()) * 180 / std::numbers::pi;
      return degrees < 0 ? degrees + 360 : degrees;
    };
    begin("ARC", "AcDbCircle");
    tags_.point(10, piece.centre);
    tags_.real(40, piece.radius());
    tags_.text(100, "AcDbArc");
    tags_.real(50, angle(piece.sweep > 0 ? piece.from : piece.to));
    tags_.real(51, angle(piece.sweep > 0 ? piece.to : piece.from));
  }

  void spline(const CubicPath& path) {
    // The bit of a planar spline in group 70, and the degree of cubics.
    constexpr int kPlanar = 8, kDegree = 3;
    const auto knots = path.knots();
    const auto points = path.control_points();
    begin("SPLINE", "AcDbSpline");
    tags_.real(210, 0);
    tags_.real(220, 0);
    tags_.real(230, 1);
    tags_.integer(70, kPlanar);
    tags_.integer(71, kDegree);
    tags_.integer(72, static_cast<int>(knots.size()));
    tags_.integer(73, static_cast<int>(points.size()));
    tags_.integer(74, 0);
    for (const double knot : knots) tags_.real(40, knot);
    for (const Vector2d& point : points) tags_.point(10, point);
  }

  Tags& tags_;
  std::string layer_ = {};
  int next_ = dxf::kFirstFree;
};

/// The outermost points of a shape; of a text about those.
std::vector<Vector2d> outermost(const DrawnShape& shape) {
  constexpr double kLetter = 0.85;  // how wide a letter is, of its height
  if (const auto* line = std::get_if<DrawnLine>(&shape.shape)) return {line->from, line->to};
  if (const auto* text = std::get_if<DrawnText>(&shape.shape)) {
    const double width = kLetter * text->height * static_cast<double>(text->text.size());
    return {text->at, text->at + Vector2d(width, text->height)};
  }
  const auto& arc = std::get<DrawnArc>(shape.shape);
  std::vector<Vector2d> points;
  const auto add = [&](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    points.push_back(arc.centre + arc.radius * Vector2d(std::cos(angle), std::sin(angle)));
  };
  add(arc.from), add(arc.to);
  for (double top = 90 * std::ceil(arc.from / 90); top < arc.to; top += 90) add(top);
  return points;
}

Extent extent_of_all(const std::vector<ExportedCurve>& curves,
                     const std::vector<DrawnShape>& shapes) {
  Extent extent = extent_of(curves);
  for (const DrawnShape& shape : shapes) {
    for (const Vector2d& point : outermost(shape)) {
      extent.low = extent.low.cwiseMin(point);
      extent.high = extent.high.cwiseMax(point);
    }
  }
  return extent;
}

}  // namespace

std::string dxf_layer(const std::string& curve) {
  std::string layer;
  for (const char c : curve) {
    layer += c == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return layer;
}

std::string dxf_text(const std::vector<ExportedCurve>& curves,
                     const std::vector<DrawnShape>& shapes, const LengthUnit& unit,
                     const std::vector<std::string>& comments) {
  Tags entities;
  Entities writer(entities);
  std::vector<std::string> layers;
  for (const ExportedCurve& curve : curves) {
    writer.add(curve);
    layers.push_back(dxf_layer(curve.name));
  }
  for (const DrawnShape& shape : shapes) {
    writer.add(shape);
    if (std::find(layers.begin(), layers.end(), shape.layer) == layers.end()) {
      layers.push_back(shape.layer);
    }
  }
  Tags tags;
  for (const std::string& comment : comments) tags.text(999, plain_text(comment));
  dxf::begin(tags, {extent_of_all(curves, shapes), layers, unit, writer.next()});
  tags.text(0, "SECTION");
  tags.text(2, "ENTITIES");
  std::string text = tags.take() + entities.take();
  tags.text(0, "ENDSEC");
  dxf::end(tags);
  return text + tags.take();
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "output/export/dxf.h"

#include <cctype>
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
      spline(std::get<CubicPath>(curve.path));
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

}  // namespace

std::string dxf_layer(const std::string& curve) {
  std::string layer;
  for (const char c : curve) {
    layer += c == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return layer;
}

std::string dxf_text(const std::vector<ExportedCurve>& curves, const LengthUnit& unit,
                     const std::vector<std::string>& comments) {
  Tags entities;
  Entities writer(entities);
  for (const ExportedCurve& curve : curves) writer.add(curve);
  Tags tags;
  for (const std::string& comment : comments) tags.text(999, plain_text(comment));
  dxf::begin(tags, curves, unit, writer.next());
  tags.text(0, "SECTION");
  tags.text(2, "ENTITIES");
  std::string text = tags.take() + entities.take();
  tags.text(0, "ENDSEC");
  dxf::end(tags);
  return text + tags.take();
}

}  // namespace camlaw::problems

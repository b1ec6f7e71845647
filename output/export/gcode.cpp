// SPDX-License-Identifier: MIT
#include "output/export/gcode.h"

#include <cmath>
#include <iterator>
#include <numbers>

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

class Program {
 public:
  explicit Program(const GcodeSettings& settings) : settings_(settings) {}

  void comment(const std::string& text) { line(fmt::format("({})", plain_text(text))); }
  void line(const std::string& text) { text_ += text + "\n"; }
  /// A place or a length as the program has it.
  std::string number(double value) const {
    return fmt::format("{:.{}f}", rounded(value, settings_.decimals), settings_.decimals);
  }
  std::string place(const Vector2d& p) const {
    return fmt::format("X{} Y{}", number(p.x()), number(p.y()));
  }
  void straight(const Vector2d& to) { line(fmt::format("G1 {}", place(to))); }
  void arc(const ArcPiece& piece) {
    // What rounds to a full turn would be one.
    if (place(piece.from) == place(piece.to)) return;
    if (piece.is_line()) return straight(piece.to);
    const Vector2d start = rounded(piece.from, settings_.decimals);
    const Vector2d centre = piece.centre - start;
    line(fmt::format("G{} {} I{} J{}", piece.sweep > 0 ? 3 : 2, place(piece.to), number(centre.x()),
                     number(centre.y())));
  }
  std::string take() { return std::move(text_); }

 private:
  const GcodeSettings& settings_;
  std::string text_ = "%\n";
};

void follow(const ExportedCurve& curve, Program& program) {
  if (const auto* arcs = std::get_if<ArcPath>(&curve.path)) {
    for (const ArcPiece& piece : arcs->pieces) program.arc(piece);
    return;
  }
  const auto points = std::get<Chords>(curve.path).points;
  for (std::size_t i = 1; i < points.size(); ++i) program.straight(points[i].at);
}

/// Down beside the path, along its lead and the path, and up.
void run_pass(const ToolPass& pass, const GcodeSettings& settings, Program& program) {
  const ExportedCurve& curve = pass.path.exported();
  const auto& lead = pass.path.lead();
  if (std::holds_alternative<CubicPath>(curve.path)) {
    throw std::invalid_argument("G-code has no splines; use arcs or lines");
  }
  if (settings.compensation && !lead) {
    throw std::invalid_argument(
        "--compensation begins and ends on a straight move: give --lead too, larger than the tool");
  }
  if (!pass.comment.empty()) program.comment(pass.comment);
  const Vector2d start = !lead                   ? curve.joints().front()
                         : settings.compensation ? lead->from
                                                 : lead->in.from;
  program.line(fmt::format("G0 {}", program.place(start)));
  program.line(fmt::format("G1 Z{} F{:.6g}", program.number(-settings.depth), settings.feed));
  if (settings.compensation) {
    program.line(fmt::format("G1 G{} D{} {}", lead->outside_is_left ? 41 : 42,
                             *settings.compensation, program.place(lead->in.from)));
  }
  if (lead) program.arc(lead->in);
  follow(curve, program);
  if (lead) program.arc(lead->out);
  if (settings.compensation) program.line(fmt::format("G1 G40 {}", program.place(lead->to)));
  program.line(fmt::format("G0 Z{}", program.number(settings.clearance)));
}

}  // namespace

double gcode_rounding(int decimals) { return 3 / std::numbers::sqrt2 * std::pow(10.0, -decimals); }

std::string gcode_text(const std::vector<ToolPass>& passes, const GcodeSettings& settings,
                       const std::vector<std::string>& comments) {
  Program program(settings);
  for (const std::string& comment : comments) program.comment(comment);
  program.line(fmt::format("{} G17 G90 G40 G94", settings.unit.mm == 1 ? "G21" : "G20"));
  program.line(fmt::format("G0 Z{}", program.number(settings.clearance)));
  for (const ToolPass& pass : passes) run_pass(pass, settings, program);
  program.line("M30");
  program.line("%");
  return program.take();
}

}  // namespace camlaw::problems

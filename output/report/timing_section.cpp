// SPDX-License-Identifier: MIT
#include "output/report/timing_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/laws/side_by_side.h"
#include "output/document/formatting.h"
#include "output/report/html.h"

namespace camlaw::cli {
namespace {

using problems::ProblemStatement;

constexpr double kDegrees = 360;

double in_turn(double angle) { return angle - kDegrees * std::floor(angle / kDegrees); }

double phase_of(const ProblemStatement& design, std::size_t cam) {
  return design.constants[design.mechanism->cams[cam].phase];
}

const char* word_of(TimedSpan::Kind kind) {
  return kind == TimedSpan::Kind::Rise     ? "rise"
         : kind == TimedSpan::Kind::Return ? "return"
                                           : "dwell";
}

/// What a law does between two places: it rests where it is at one height at both and between them.
TimedSpan::Kind kind_of(const Law<double>& law, double begin, double end) {
  // A law that leaves its height and returns to it shows at most of these.
  constexpr int kLooks = 16;
  constexpr double kSame = 1e-9;  // of a stroke of 1: rounding of a dwell's height
  const double first = law(begin).s, last = law(end, Side::Left).s;
  if (std::abs(last - first) > kSame)
    return last > first ? TimedSpan::Kind::Rise : TimedSpan::Kind::Return;
  for (int i = 1; i < kLooks; ++i) {
    const double s = law(std::lerp(begin, end, i / double(kLooks))).s;
    if (std::abs(s - first) > kSame)
      return s > first ? TimedSpan::Kind::Rise : TimedSpan::Kind::Return;
  }
  return TimedSpan::Kind::Dwell;
}

/// Where a span ends, within the turn.
double end_of(const TimedSpan& span) { return span.to > kDegrees ? in_turn(span.to) : span.to; }

std::string bar(const TimedSpan& span, double from, double to, bool is_named) {
  const std::string name = escaped(plain_name(span.name));
  return fmt::format(
      "<i class=\"{}\" style=\"left:{:.3f}%;width:{:.3f}%\" title=\"{}: {}, {:.4g} to {:.4g} "
      "deg\">{}</i>",
      word_of(span.kind), 100 * from / kDegrees, 100 * (to - from) / kDegrees, name,
      word_of(span.kind), span.from, end_of(span), is_named ? name : "");
}

/// A span in one bar, or in two where it goes over the end of the turn, the longer one named.
std::string bars(const TimedSpan& span) {
  if (span.to <= kDegrees) return bar(span, span.from, span.to, true);
  const double before = kDegrees - span.from, after = span.to - kDegrees;
  return bar(span, span.from, kDegrees, before >= after) + bar(span, 0, after, after > before);
}

/// The displacement over the shaft's turn, below the names of the parts, which stand in the upper
/// third.
std::string line(const Law<double>& law, double phase) {
  constexpr int kPoints = 360;  // a point each degree
  std::vector<double> s;
  for (int i = 0; i <= kPoints; ++i) s.push_back(law(in_turn(i - phase) / kDegrees).s);
  const auto [lowest, highest] = std::minmax_element(s.begin(), s.end());
  const double range = *highest > *lowest ? *highest - *lowest : 1;
  std::string points;
  for (int i = 0; i <= kPoints; ++i) {
    points +=
        fmt::format("{} {:.2f} ", i, 95 - 58 * (s[static_cast<std::size_t>(i)] - *lowest) / range);
  }
  points.pop_back();
  return fmt::format(
      "<svg viewBox=\"0 0 360 100\" preserveAspectRatio=\"none\" aria-hidden=\"true\">"
      "<polyline points=\"{}\"/></svg>",
      points);
}

std::string axis() {
  std::string ticks;
  for (int angle = 0; angle <= 360; angle += 45) {
    ticks += fmt::format("<i{} style=\"left:{:.2f}%\">{}</i>",
                         angle % 90 == 0 ? "" : " class=\"minor\"", angle / 3.6, angle);
  }
  return "<div class=\"ticks\" aria-hidden=\"true\">" + ticks + "</div>\n";
}

}  // namespace

namespace {

/// The parts of a law that begins at `phase` of the shaft, deg.
std::vector<TimedSpan> spans_of(const Member& law, double phase) {
  const auto motion = law.possible_law();
  std::vector<TimedSpan> result;
  if (!law.family->spans || !motion) return result;
  for (const NamedSpan& span : law.family->spans(law.arguments)) {
    const double from = in_turn(span.begin * kDegrees + phase);
    result.push_back({span.name, kind_of(*motion, span.begin, span.end), from,
                      from + (span.end - span.begin) * kDegrees});
  }
  return result;
}

}  // namespace

std::vector<TimedSpan> timed_spans(const ProblemStatement& design, std::size_t cam) {
  return spans_of(laws_side_by_side(design.laws.front()).at(cam), phase_of(design, cam));
}

std::vector<TimedSpan> motion_spans(const ProblemStatement& design) {
  const bool is_one = design.cams.empty() && !design.laws.empty() &&
                      design.mechanism->moved_by == problems::MovedBy::Program;
  return is_one ? spans_of(design.laws.front(), 0) : std::vector<TimedSpan>{};
}

Json spans_json(const std::vector<TimedSpan>& spans) {
  Json list = Json::array();
  for (const TimedSpan& span : spans) {
    list.push_back({{"kind", word_of(span.kind)}, {"from", span.from}, {"to", span.to}});
  }
  return list;
}

std::optional<ReportSection> timing_section(const ProblemStatement& design) {
  if (design.cams.empty()) return {};
  Table table{.columns = {words("cam"), names("part"), words("motion"), numbers("from, deg"),
                          numbers("to, deg")}};
  std::string rows;
  const std::vector<Member> laws = laws_side_by_side(design.laws.front());
  for (std::size_t cam = 0; cam < design.cams.size(); ++cam) {
    const std::string& name = design.cams[cam].name;
    std::string track;
    for (const TimedSpan& span : timed_spans(design, cam)) {
      track += bars(span);
      table.add({name, span.name, word_of(span.kind), in_digits(span.from, 6),
                 in_digits(end_of(span), 6)});
    }
    const bool is_moved =
        design.mechanism->cams[cam].mechanism->moved_by != problems::MovedBy::Nothing;
    const auto motion = laws[cam].possible_law();
    if (motion && is_moved) track += line(*motion, phase_of(design, cam));
    rows += fmt::format(
        "<p class=\"cam\"><b>{}</b> has its zero at {} deg</p>\n<div class=\"track\">{}</div>\n",
        escaped(plain_name(name)), in_digits(phase_of(design, cam), 6), track);
  }
  return ReportSection{
      "timing", "Timing",
      "<div class=\"timing\">\n" + rows + axis() + "</div>\n" +
          paragraph("Over the angle of the shaft, deg: the parts of each cam's motion, and its "
                    "displacement as a line between its lowest and its highest place.") +
          (table.rows.empty() ? ""
                              : details("The parts of the motions in numbers", html_of(table)))};
}

}  // namespace camlaw::cli

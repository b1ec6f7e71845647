// SPDX-License-Identifier: MIT
#include "output/figure/chart_labels.h"

#include <algorithm>
#include <cmath>

namespace camlaw::cli {
namespace {

/// Directions from a point to its label, best first: beside, above and below, corners, and the
/// half ways, which shift the label sideways by a quarter of its width.
constexpr DrawnPoint kDirections[] = {{1, 0}, {-1, 0}, {0, -1},   {0, 1},     {1, -1},  {-1, -1},
                                      {1, 1}, {-1, 1}, {0.5, -1}, {-0.5, -1}, {0.5, 1}, {-0.5, 1}};

/// Gaps between a marker and its label. Beyond the first one there is a leader.
constexpr double kGaps[] = {2, 10, 18, 28, 40, 55, 75, 100};

constexpr double kLabelSpacing = 1.5;  // Free px around each label.

/// Width of a character over the font size, measured in DejaVu Sans by groups and rounded up.
double character_width(char c) {
  constexpr std::string_view kNarrow = "iIjl.,:;'|!()[]/ftr\"- ";
  constexpr std::string_view kWide = "mwMW@%+=<>~";
  if (kNarrow.find(c) != std::string_view::npos) return 0.42;
  if (kWide.find(c) != std::string_view::npos) return 0.98;
  return c >= 'A' && c <= 'Z' ? 0.76 : 0.64;
}

/// Whether the byte continues a UTF-8 character.
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

Rect grown(const Rect& r, double by) {
  return {r.left - by, r.top - by, r.right + by, r.bottom + by};
}

bool contains(const Rect& outer, const Rect& inner) {
  return inner.left >= outer.left && inner.right <= outer.right && inner.top >= outer.top &&
         inner.bottom <= outer.bottom;
}

bool contains(const Rect& rect, DrawnPoint p) {
  return p.x >= rect.left && p.x <= rect.right && p.y >= rect.top && p.y <= rect.bottom;
}

double cross(DrawnPoint o, DrawnPoint a, DrawnPoint b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

bool crossing(const LineSegment& s, const LineSegment& t) {
  return cross(s.a, s.b, t.a) * cross(s.a, s.b, t.b) <= 0 &&
         cross(t.a, t.b, s.a) * cross(t.a, t.b, s.b) <= 0;
}

Placement candidate(const Label& label, DrawnPoint direction, double gap) {
  const double distance = label.reach + gap;
  const DrawnPoint centre{label.anchor.x + direction.x * (distance + label.width / 2),
                          label.anchor.y + direction.y * (distance + label.height / 2)};
  const Rect box{centre.x - label.width / 2, centre.y - label.height / 2,
                 centre.x + label.width / 2, centre.y + label.height / 2};
  if (gap <= kGaps[0]) return {box, {}};
  const DrawnPoint end{std::clamp(label.anchor.x, box.left, box.right),
                       std::clamp(label.anchor.y, box.top, box.bottom)};
  const double length = std::hypot(end.x - label.anchor.x, end.y - label.anchor.y);
  const double t = label.reach / length;  // The leader starts at the marker's edge.
  const DrawnPoint start{label.anchor.x + t * (end.x - label.anchor.x),
                         label.anchor.y + t * (end.y - label.anchor.y)};
  return {box, LineSegment{start, end}};
}

/// Whether the leader is clear of other points' markers and of what is placed already.
bool is_free_leader(const LineSegment& leader, DrawnPoint anchor,
                    const std::vector<Placement>& placed, const Surroundings& around) {
  const auto blocks = [&](const Rect& m) { return !contains(m, anchor) && overlap(m, leader); };
  if (std::ranges::any_of(around.markers, blocks)) return false;
  return std::ranges::none_of(placed, [&](const Placement& other) {
    return overlap(other.box, leader) || (other.leader && crossing(*other.leader, leader));
  });
}

bool is_free(const Placement& place, const Label& label, const std::vector<Placement>& placed,
             const Surroundings& around, bool over_lines) {
  const Rect box = grown(place.box, kLabelSpacing);
  if (!contains(around.frame, box)) return false;
  const auto covers = [&](const auto& obstacle) { return overlap(box, obstacle); };
  if (std::ranges::any_of(around.markers, covers)) return false;
  if (!over_lines && std::ranges::any_of(around.lines, covers)) return false;
  for (const Placement& other : placed)
    if (covers(other.box) || (other.leader && covers(*other.leader))) return false;
  return !place.leader || is_free_leader(*place.leader, label.anchor, placed, around);
}

std::optional<Placement> find_place(const Label& label, const std::vector<Placement>& placed,
                                    const Surroundings& around) {
  for (const bool over_lines : {false, true})
    for (const double gap : kGaps)
      for (const DrawnPoint direction : kDirections) {
        const Placement place = candidate(label, direction, gap);
        if (is_free(place, label, placed, around, over_lines)) return place;
      }
  return {};
}

}  // namespace

bool overlap(const Rect& a, const Rect& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

bool overlap(const Rect& rect, const LineSegment& segment) {
  const Rect bounds{std::min(segment.a.x, segment.b.x), std::min(segment.a.y, segment.b.y),
                    std::max(segment.a.x, segment.b.x), std::max(segment.a.y, segment.b.y)};
  if (bounds.left > rect.right || bounds.right < rect.left || bounds.top > rect.bottom ||
      bounds.bottom < rect.top)
    return false;
  if (contains(rect, segment.a) || contains(rect, segment.b)) return true;
  return crossing(segment, {{rect.left, rect.top}, {rect.right, rect.bottom}}) ||
         crossing(segment, {{rect.left, rect.bottom}, {rect.right, rect.top}});
}

double text_width(std::string_view text, double font_size) {
  double width = 0;
  for (const char c : text)
    if (!is_continuation(c)) width += character_width(c);
  return width * font_size;
}

std::vector<std::string> wrap_text(std::string_view text, double font_size, double width) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word(text.substr(begin, end - begin));
    begin = end + 1;
    if (word.empty()) continue;
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (lines.empty() || text_width(longer, font_size) > width)
      lines.push_back(word);
    else
      lines.back() = longer;
  }
  return lines;
}

std::vector<std::optional<Placement>> place_labels(std::span<const Label> labels,
                                                   const Surroundings& surroundings) {
  std::vector<std::optional<Placement>> places;
  std::vector<Placement> placed;
  for (const Label& label : labels) {
    places.push_back(find_place(label, placed, surroundings));
    if (places.back()) placed.push_back(*places.back());
  }
  return places;
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#include "output/figure/chart_svg.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace camlaw::cli {
namespace {

std::string points_attribute(std::span<const DrawnPoint> points) {
  std::string text;
  for (const DrawnPoint& p : points) {
    if (!text.empty()) text += ' ';
    text += svg_number(p.x) + "," + svg_number(p.y);
  }
  return text;
}

std::string stroke_attributes(const Stroke& stroke) {
  return fmt::format(R"(stroke="{}" stroke-width="{}"{})", xml_escape(stroke.colour),
                     svg_number(stroke.width),
                     stroke.dashed ? R"( stroke-dasharray="6.00 4.00")" : "");
}

std::string_view element_name(MarkerShape shape) {
  switch (shape) {
    case MarkerShape::Circle:
      return "circle";
    case MarkerShape::Square:
      return "rect";
    case MarkerShape::Diamond:
      return "polygon";
    case MarkerShape::Cross:
      break;
  }
  return "path";
}

/// The marker's element without its end.
std::string shape(DrawnPoint c, MarkerShape shape, double r) {
  const auto n = svg_number;
  switch (shape) {
    case MarkerShape::Circle:
      return fmt::format(R"(<circle cx="{}" cy="{}" r="{}")", n(c.x), n(c.y), n(r));
    case MarkerShape::Square:  // Same area as the circle, roughly.
      return fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}")", n(c.x - 0.9 * r),
                         n(c.y - 0.9 * r), n(1.8 * r), n(1.8 * r));
    case MarkerShape::Diamond: {
      const DrawnPoint corners[] = {{c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}};
      return fmt::format(R"(<polygon points="{}")", points_attribute(corners));
    }
    case MarkerShape::Cross:
      break;
  }
  const double d = 0.8 * r;
  return fmt::format(R"(<path d="M {} {} L {} {} M {} {} L {} {}")", n(c.x - d), n(c.y - d),
                     n(c.x + d), n(c.y + d), n(c.x - d), n(c.y + d), n(c.x + d), n(c.y - d));
}

}  // namespace

std::string svg_number(double value) {
  return fmt::format("{:.2f}", std::abs(value) < 0.005 ? 0.0 : value);
}

Svg::Svg(double width, double height, std::string_view description) {
  const std::string w = svg_number(width), h = svg_number(height);
  out_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" role=\"img\" aria-label=\"{2}\" font-family=\"sans-serif\" fill=\"#222222\">\n",
      w, h, xml_escape(description));
  rect(R"(class="page" fill="#FFFFFF")", {0, 0, width, height});
}

void Svg::rect(std::string_view attributes, const Rect& r) {
  out_ += fmt::format("<rect {} x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", attributes,
                      svg_number(r.left), svg_number(r.top), svg_number(r.right - r.left),
                      svg_number(r.bottom - r.top));
}

void Svg::frame(const Rect& r, std::string_view colour) {
  rect(fmt::format(R"(class="frame" fill="none" stroke="{}")", xml_escape(colour)), r);
}

void Svg::line(std::string_view kind, const LineSegment& s, const Stroke& stroke) {
  out_ += fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", kind,
                      svg_number(s.a.x), svg_number(s.a.y), svg_number(s.b.x), svg_number(s.b.y),
                      stroke_attributes(stroke));
}

void Svg::polyline(std::span<const DrawnPoint> points, const Stroke& stroke) {
  out_ += fmt::format(
      "<polyline fill=\"none\" {} stroke-linejoin=\"round\" stroke-linecap=\"{}\" "
      "points=\"{}\"/>\n",
      stroke_attributes(stroke), stroke.dashed ? "butt" : "round", points_attribute(points));
}

void Svg::text(std::string_view kind, DrawnPoint p, std::string_view text, const TextStyle& style) {
  const char* anchor = style.anchor == Anchor::Start ? "start"
                       : style.anchor == Anchor::End ? "end"
                                                     : "middle";
  out_ += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\"",
                      kind, svg_number(p.x), svg_number(p.y), svg_number(style.size), anchor);
  if (style.bold) out_ += R"( font-weight="bold")";
  if (style.upwards)
    out_ += fmt::format(" transform=\"rotate(-90 {} {})\"", svg_number(p.x), svg_number(p.y));
  if (style.halo)
    out_ += R"( stroke="#FFFFFF" stroke-width="3" stroke-linejoin="round" paint-order="stroke")";
  out_ += fmt::format(">{}</text>\n", xml_escape(text));
}

void Svg::marker(DrawnPoint centre, const MarkerStyle& style, std::string_view tooltip) {
  const bool filled = style.filled && style.shape != MarkerShape::Cross;
  const std::string colour = xml_escape(style.colour);
  out_ += fmt::format(R"({} fill="{}" stroke="{}" stroke-width="{}" pointer-events="all")",
                      shape(centre, style.shape, style.size), filled ? colour : "none",
                      filled ? "#FFFFFF" : colour, filled ? "0.80" : "1.50");
  out_ += tooltip.empty() ? "/>\n"
                          : fmt::format("><title>{}</title></{}>\n", xml_escape(tooltip),
                                        element_name(style.shape));
}

void Svg::begin_clip(const Rect& r) {
  // An inner picture cuts off what leaves it. It needs no name, as a clip path does: a page with
  // several figures would have the same one twice.
  const std::string box = fmt::format("{} {} {} {}", svg_number(r.left), svg_number(r.top),
                                      svg_number(r.right - r.left), svg_number(r.bottom - r.top));
  out_ += fmt::format(
      "<svg class=\"within\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{}\">\n",
      svg_number(r.left), svg_number(r.top), svg_number(r.right - r.left),
      svg_number(r.bottom - r.top), box);
}

void Svg::end_clip() { out_ += "</svg>\n"; }

std::string Svg::finish() && { return std::move(out_) + "</svg>\n"; }

}  // namespace camlaw::cli

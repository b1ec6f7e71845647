// SPDX-License-Identifier: MIT
#include "output/figure/chart.h"

#include <fmt/format.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <regex>
#include <sstream>

#include "output/figure/chart_labels.h"
#include "output/figure/chart_scale.h"
#include "output/figure/chart_svg.h"

namespace camlaw::cli::chart_test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

struct Element {
  std::string tag;
  std::map<std::string, std::string> attributes;
  std::string text;
  std::string tooltip;

  double number(const std::string& name) const { return std::stod(attributes.at(name)); }
  bool is(const std::string& kind) const {
    const auto found = attributes.find("class");
    return found != attributes.end() && found->second == kind;
  }
};

void collect(const boost::property_tree::ptree& tree, std::vector<Element>& elements) {
  for (const auto& [tag, child] : tree) {
    if (tag == "<xmlattr>") continue;
    Element element{tag, {}, child.data(), child.get("title", "")};
    if (const auto attributes = child.get_child_optional("<xmlattr>"))
      for (const auto& [name, value] : *attributes) element.attributes[name] = value.data();
    elements.push_back(element);
    collect(child, elements);
  }
}

/// All elements in document order; the parser throws if the XML is not well-formed.
std::vector<Element> parse(const std::string& svg) {
  std::istringstream in(svg);
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(in, tree);
  std::vector<Element> elements;
  collect(tree, elements);
  return elements;
}

std::vector<Element> parse(const Figure& figure) { return parse(to_svg(figure)); }

std::vector<Element> of_kind(const std::vector<Element>& elements, const std::string& kind) {
  std::vector<Element> found;
  for (const Element& e : elements)
    if (e.is(kind)) found.push_back(e);
  return found;
}

std::vector<Element> of_tag(const std::vector<Element>& elements, const std::string& tag) {
  std::vector<Element> found;
  for (const Element& e : elements)
    if (e.tag == tag) found.push_back(e);
  return found;
}

Rect rect_of(const Element& e) {
  return {e.number("x"), e.number("y"), e.number("x") + e.number("width"),
          e.number("y") + e.number("height")};
}

std::vector<DrawnPoint> points_of(const Element& polyline) {
  std::istringstream in(polyline.attributes.at("points"));
  std::vector<DrawnPoint> points;
  char comma = 0;
  for (DrawnPoint p; in >> p.x >> comma >> p.y;) points.push_back(p);
  return points;
}

/// Box of a text, estimated apart from text_width: 0.55 of the font size per character.
Rect text_box(const Element& text) {
  const double font = text.number("font-size");
  const double width = 0.55 * font * static_cast<double>(text.text.size());
  const std::string& anchor = text.attributes.at("text-anchor");
  const double left =
      text.number("x") - (anchor == "start" ? 0 : (anchor == "end" ? width : width / 2));
  return {left, text.number("y") - 0.8 * font, left + width, text.number("y") + 0.1 * font};
}

bool is_within(const Rect& inner, const Rect& outer) {
  const double rounding = 0.011;
  return inner.left >= outer.left - rounding && inner.right <= outer.right + rounding &&
         inner.top >= outer.top - rounding && inner.bottom <= outer.bottom + rounding;
}

Line wave(const std::string& name, double amplitude) {
  Line line{.name = name};
  for (int i = 0; i <= 100; ++i) {
    line.x.push_back(i / 100.0);
    line.y.push_back(amplitude * std::sin(0.2 * i));
  }
  return line;
}

/// Four panels over one x axis with two laws each.
Figure column() {
  Figure figure{.title = "Laws", .subtitle = "over the cam angle"};
  for (const char* name : {"lift", "velocity", "acceleration", "jerk"})
    figure.panels.push_back({.x = {"angle", "-", 0.0, 1.0},
                             .y = {name, "mm"},
                             .lines = {wave("first", 1), wave("second", 2)}});
  return figure;
}

/// A scatter plot with n labelled points at random, and a curve through it.
Figure crowd(int n) {
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Markers markers{.name = "laws"};
  for (int i = 0; i < n; ++i) {
    const double x = uniform(), y = uniform();
    markers.points.push_back({x, y, fmt::format("law no. {}", i), "tip"});
  }
  return {.panels = {{.x = {"radius", "mm"},
                      .y = {"force", "N"},
                      .lines = {{.name = "limit", .x = {0, 1}, .y = {1, 0}}},
                      .markers = {markers}}}};
}

}  // namespace

TEST_CASE("chart: ticks of known ranges are the numbers one would choose") {
  CHECK(nice_ticks(0, 1) == std::vector<double>{0, 0.2, 0.4, 0.6, 0.8, 1});
  CHECK(nice_ticks(-52.5, 42) == std::vector<double>{-40, -20, 0, 20, 40});
  CHECK(nice_ticks(0, 0.3) == std::vector<double>{0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3});
  CHECK(nice_ticks(1e6, 8e6) == std::vector<double>{1e6, 2e6, 3e6, 4e6, 5e6, 6e6, 7e6, 8e6});
  CHECK_FALSE(std::signbit(nice_ticks(-1, 1)[2]));
}

TEST_CASE("chart: ticks of a turn are parts of it that one counts in") {
  CHECK(degree_ticks(0, 360) == std::vector<double>{0, 60, 120, 180, 240, 300, 360});
  CHECK(degree_ticks(0, 180) == std::vector<double>{0, 30, 60, 90, 120, 150, 180});
  CHECK(degree_ticks(-180, 180).front() == -180);
  CHECK(degree_ticks(0, 720) == std::vector<double>{0, 180, 360, 540, 720});
  CHECK(degree_ticks(-32, 32) == nice_ticks(-32, 32));
  CHECK(degree_ticks(0, 1e4) == nice_ticks(0, 1e4));
}

TEST_CASE("chart: ticks are 4 to 8 even steps within the range, for all sizes of ranges") {
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int i = 0; i < 20000; ++i) {
    const double width = std::pow(10, -200 + 400 * uniform());
    const double lower = width * (10 * uniform() - 5);
    const double upper = lower + width * (0.01 + uniform());
    const auto ticks = nice_ticks(lower, upper);
    CAPTURE(lower, upper, ticks.size());
    REQUIRE((ticks.size() >= 4 && ticks.size() <= 8));
    const double step = ticks[1] - ticks[0];
    REQUIRE(ticks.front() >= lower - 1e-8 * step);
    REQUIRE(ticks.back() <= upper + 1e-8 * step);
    for (std::size_t k = 2; k < ticks.size(); ++k)
      REQUIRE(ticks[k] - ticks[k - 1] == Approx(step).epsilon(1e-9));
    const double decade = std::pow(10, std::floor(std::log10(step) + 1e-9));
    const double mantissa = step / decade;
    const auto is_near = [&](double m) { return std::abs(mantissa - m) < 1e-6; };
    REQUIRE((is_near(1) || is_near(2) || is_near(2.5) || is_near(5)));
  }
}

TEST_CASE("chart: ticks of huge, tiny and degenerate ranges are finite and few") {
  CHECK(nice_ticks(-1e300, 1e300).size() >= 4);
  CHECK(nice_ticks(0, 1e-270).size() >= 4);
  CHECK(nice_ticks(1, std::nextafter(1, 2)).size() == 2);
  CHECK(nice_ticks(0, 5e-324).size() == 2);
  CHECK_THROWS_AS(nice_ticks(1, 1), std::invalid_argument);
  CHECK_THROWS_AS(nice_ticks(0, nan), std::invalid_argument);
  CHECK_THROWS_AS(nice_ticks(-infinity, 0), std::invalid_argument);
}

TEST_CASE("chart: tick labels have equally many decimals, no -0, and exponents where short") {
  using Labels = std::vector<std::string>;
  const auto labels = [](double lower, double upper) {
    return tick_labels(nice_ticks(lower, upper));
  };
  CHECK(labels(0, 1) == Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(labels(-52.5, 42) == Labels{"-40", "-20", "0", "20", "40"});
  CHECK(labels(0, 4e6) == Labels{"0", "1e6", "2e6", "3e6", "4e6"});
  CHECK(labels(9e6, 1.25e7) ==
        Labels{"0.90e7", "0.95e7", "1.00e7", "1.05e7", "1.10e7", "1.15e7", "1.20e7", "1.25e7"});
  CHECK(labels(-1e-7, 1e-7) == Labels{"-1.0e-7", "-0.5e-7", "0", "0.5e-7", "1.0e-7"});
  CHECK(labels(0, 0.005) == Labels{"0.000", "0.001", "0.002", "0.003", "0.004", "0.005"});
  CHECK(labels(1000, 1000.001).front() == "1000.0000");
}

TEST_CASE("chart: axis ranges have 4 % padding, and constants a sensible width") {
  const auto range = [](std::optional<Range> data, std::optional<double> lower = {},
                        std::optional<double> upper = {}) {
    const Range r = axis_range("force", data, lower, upper);
    return std::pair{r.lower, r.upper};
  };
  CHECK(range(Range{0, 100}) == std::pair{-4.0, 104.0});
  CHECK(range(Range{0, 100}, 0.0) == std::pair{0.0, 104.0});
  CHECK(range(Range{0, 100}, 1.0, 2.0) == std::pair{1.0, 2.0});
  CHECK(range(Range{50, 50}) == std::pair{45.0, 55.0});
  CHECK(range(Range{50, 50 + 1e-12}).first == Approx(45));
  CHECK(range(Range{0, 0}) == std::pair{-1.0, 1.0});
  CHECK(range({}) == std::pair{0.0, 1.0});
  CHECK(range(Range{0, 100}, 500.0) == std::pair{500.0, 608.0});
  CHECK(range(Range{0, 100}, {}, -500.0) == std::pair{-608.0, -500.0});
  CHECK_THROWS_WITH(range({}, 5.0, 3.0), Catch::Contains("'force'") && Catch::Contains("5"));
  CHECK_THROWS_AS(range({}, nan, 3.0), std::invalid_argument);
}

TEST_CASE("chart: a curve is cut where it leaves the range and where it is not finite") {
  const std::vector<double> x{0, 1, 2, 3, 4, 5}, y{0, 2, 0, nan, 1, 0};
  const auto pieces = clipped_curve(x, y, {0, 5}, {0, 1});
  REQUIRE(pieces.size() == 3);
  CHECK(pieces[0].back().x == Approx(0.5 / 5));  // The rise meets y = 1 half-way.
  CHECK(pieces[0].back().y == 1);
  CHECK(pieces[1].front().x == Approx(1.5 / 5));
  CHECK(pieces[2].front().x == Approx(4.0 / 5));
  SECTION("a segment with both ends outside is drawn where it crosses") {
    const std::vector<double> u{-1, 2}, v{0.5, 0.5};
    const auto through = clipped_curve(u, v, {0, 1}, {0, 1});
    REQUIRE(through.size() == 1);
    CHECK((through[0].front().x == 0 && through[0].back().x == 1));
  }
  SECTION("a segment past a corner is not drawn") {
    const std::vector<double> u{-1, 0.4}, v{0.4, 1.9};
    CHECK(clipped_curve(u, v, {0, 1}, {0, 1}).empty());
  }
  SECTION("a lone sample is a dot") {
    const std::vector<double> u{nan, 0.5, nan}, v{0, 0.5, 0};
    const auto dot = clipped_curve(u, v, {0, 1}, {0, 1});
    REQUIRE(dot.size() == 1);
    CHECK(dot[0].size() == 2);
  }
}

TEST_CASE("chart: the document is well-formed, self-contained and the same each time") {
  for (const Figure& figure : {column(), crowd(30), Figure{}, Figure{.panels = {{}, {}}}}) {
    const std::string svg = to_svg(figure);
    CHECK(svg == to_svg(figure));
    const auto elements = parse(svg);
    REQUIRE(elements.front().tag == "svg");
    const Element& root = elements.front();
    CHECK(root.attributes.at("viewBox") ==
          "0 0 " + root.attributes.at("width") + " " + root.attributes.at("height"));
    CHECK(svg.find("script") == std::string::npos);
    CHECK(svg.find("href") == std::string::npos);
    CHECK(svg.find(" id=") == std::string::npos);  // which two figures of a page could share
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
    CHECK(svg.find("-0.00") == std::string::npos);
    for (const Element& text : of_tag(elements, "text")) CHECK(text.number("font-size") >= 11);
    const std::regex two_decimals(R"(-?\d+\.\d\d)");
    for (const Element& line : of_tag(elements, "line"))
      for (const char* name : {"x1", "y1", "x2", "y2", "stroke-width"})
        CHECK(std::regex_match(line.attributes.at(name), two_decimals));
  }
}

TEST_CASE("chart: every point of a curve is inside its frame when bounds are given") {
  Figure figure = column();
  for (Panel& panel : figure.panels) {
    panel.x.lower = 0.2;
    panel.x.upper = 0.7;
    panel.y.lower = -0.5;
    panel.y.upper = 1.2;
    panel.lines.push_back({.x = {0.3, 0.4, 0.5}, .y = {0, 1e308, 0}});
  }
  std::optional<Rect> frame;
  int frames = 0, points = 0;
  // A panel's curves stand before its frame in the document.
  std::vector<DrawnPoint> pending;
  for (const Element& e : parse(figure)) {
    if (e.tag == "polyline")
      for (const DrawnPoint p : points_of(e)) pending.push_back(p);
    if (!e.is("frame")) continue;
    ++frames;
    for (const DrawnPoint p : pending) {
      ++points;
      CHECK(is_within({p.x, p.y, p.x, p.y}, rect_of(e)));
    }
    pending.clear();
  }
  CHECK(frames == 4);
  CHECK(points > 100);
}

TEST_CASE("chart: samples that are not finite break a curve") {
  Figure figure{.panels = {{.lines = {{.x = {0, 1, 2, 3, 4, 5, 6, 7},
                                       .y = {0, 1, nan, 1, 2, infinity, 1, 0}}}}}};
  CHECK(of_tag(parse(figure), "polyline").size() == 3);
  figure.panels[0].lines[0].y[2] = 0;
  CHECK(of_tag(parse(figure), "polyline").size() == 2);
}

TEST_CASE("chart: text comes back unchanged from an XML parser") {
  const std::string nasty = R"(a < b > c & "d" 'e' µ²)";
  const Figure figure{.title = nasty,
                      .panels = {{.title = nasty,
                                  .x = {.label = nasty},
                                  .lines = {{.name = nasty, .x = {0, 1}, .y = {0, 1}}},
                                  .markers = {{.points = {{.x = 0.5, .y = 0.5, .tooltip = nasty}},
                                               .colour = "\"><script>"}}}}};
  const auto elements = parse(figure);
  for (const char* kind : {"title", "panel-title", "axis-title"}) {
    REQUIRE(of_kind(elements, kind).size() == 1);
    CHECK(of_kind(elements, kind)[0].text == nasty);
  }
  CHECK(elements.front().attributes.at("aria-label") == nasty);
  CHECK(of_tag(elements, "circle").at(0).tooltip == nasty);
  CHECK(of_tag(elements, "script").empty());
  CHECK(xml_escape("a\x01\nb\xff"
                   "c\xed\xa0\x80") == "a  b?c???");
}

TEST_CASE("chart: labels of 30 crowded points overlap neither each other, markers nor frame") {
  const auto elements = parse(crowd(30));
  const Rect frame = rect_of(of_kind(elements, "frame").at(0));
  const auto labels = of_kind(elements, "label");
  const auto circles = of_tag(elements, "circle");
  CHECK(labels.size() >= 25);
  CHECK(circles.size() == 31);  // One is in the legend.
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Rect box = text_box(labels[i]);
    CAPTURE(labels[i].text);
    CHECK(is_within(box, frame));
    for (std::size_t k = i + 1; k < labels.size(); ++k)
      CHECK_FALSE(overlap(box, text_box(labels[k])));
    for (const Element& c : circles) {
      const double x = c.number("cx"), y = c.number("cy"), r = c.number("r");
      CHECK_FALSE(overlap(box, Rect{x - r, y - r, x + r, y + r}));
    }
    for (const Element& leader : of_kind(elements, "leader")) {
      const LineSegment segment{{leader.number("x1"), leader.number("y1")},
                                {leader.number("x2"), leader.number("y2")}};
      const double inset = 1;  // A label's own leader ends at its box.
      const Rect core{box.left + inset, box.top + inset, box.right - inset, box.bottom - inset};
      CHECK_FALSE(overlap(core, segment));
    }
  }
}

TEST_CASE("chart: a label moved away has a leader, and one without room is a tooltip only") {
  const Label label{{50, 50}, 4, 30, 12};
  SECTION("alone it stands close by") {
    const auto place = place_labels(std::vector{label}, {{0, 0, 200, 200}, {}, {}}).at(0);
    REQUIRE(place);
    CHECK_FALSE(place->leader);
    CHECK(place->box.left == 56);
  }
  SECTION("with all near places taken it moves away") {
    const std::vector<Rect> wall{{56, 20, 60, 80}, {40, 20, 44, 80}, {40, 56, 60, 60}};
    const auto place = place_labels(std::vector{label}, {{0, 0, 200, 200}, wall, {}}).at(0);
    REQUIRE(place);
    REQUIRE(place->leader);
    CHECK(place->leader->b.y == place->box.bottom);
    for (const Rect& marker : wall) CHECK_FALSE(overlap(marker, *place->leader));
  }
  SECTION("it goes over a line only if it must") {
    const std::vector<LineSegment> line{{{60, 0}, {60, 200}}};
    CHECK(place_labels(std::vector{label}, {{0, 0, 200, 200}, {}, line}).at(0)->box.right == 44);
    CHECK(place_labels(std::vector{label}, {{46, 30, 95, 62}, {}, line}).at(0)->box.left == 56);
  }
  SECTION("in a frame without room there is none, and the tooltip tells the name") {
    CHECK_FALSE(place_labels(std::vector{label}, {{40, 40, 60, 60}, {}, {}}).at(0));
    Figure figure = crowd(3);
    figure.panel_width = 60;
    figure.panel_height = 60;
    const auto elements = parse(figure);
    CHECK(of_kind(elements, "label").size() < 3);
    std::vector<std::string> tooltips;
    for (const Element& c : of_tag(elements, "circle")) tooltips.push_back(c.tooltip);
    CHECK_THAT(tooltips, Catch::VectorContains(std::string("law no. 2: tip")));
  }
}

TEST_CASE("chart: points outside given bounds and points that are not finite are not drawn") {
  const Figure figure{.panels = {{.x = {.lower = 0, .upper = 1},
                                  .y = {.lower = 0, .upper = 1},
                                  .markers = {{.points = {{0.5, 0.5, "in", ""},
                                                          {1.5, 0.5, "out", ""},
                                                          {0.5, -0.1, "below", ""},
                                                          {nan, 0.5, "nan", ""},
                                                          {0.5, infinity, "inf", ""}}}}}}};
  const auto elements = parse(figure);
  CHECK(of_tag(elements, "circle").size() == 1);
  REQUIRE(of_kind(elements, "label").size() == 1);
  CHECK(of_kind(elements, "label")[0].text == "in");
}

TEST_CASE("chart: each series name has one legend entry, in rows above the frames") {
  Figure figure = column();
  for (int i = 0; i < 20; ++i)
    figure.panels[1].lines.push_back(wave(fmt::format("another law {}", i), 1));
  figure.panels[2].markers.push_back({.name = "first", .points = {{.x = 0.5}}});
  const auto elements = parse(figure);
  const double width = elements.front().number("width");
  const double top = rect_of(of_kind(elements, "frame").at(0)).top;
  std::map<std::string, int> names;
  std::map<double, int> rows;
  for (const Element& e : of_kind(elements, "legend")) {
    if (e.tag != "text") continue;
    ++names[e.text];
    ++rows[e.number("y")];
    CHECK(text_box(e).right < width);
    CHECK(text_box(e).bottom < top);
  }
  CHECK(names.size() == 22);
  CHECK(names["first"] == 1);
  CHECK(rows.size() >= 3);
}

TEST_CASE("chart: one series has one colour in all panels and in the legend") {
  Figure figure = column();
  std::swap(figure.panels[1].lines[0], figure.panels[1].lines[1]);
  const auto lines = of_tag(parse(figure), "polyline");
  REQUIRE(lines.size() == 8);
  CHECK(lines[0].attributes.at("stroke") == palette()[0]);
  CHECK(lines[1].attributes.at("stroke") == palette()[1]);
  CHECK(lines[2].attributes.at("stroke") == palette()[1]);
  CHECK(lines[3].attributes.at("stroke") == palette()[0]);
}

TEST_CASE("chart: a column over one x axis is titled below, other panels each on their own") {
  const auto x_titles = [](const Figure& figure) {
    int n = 0;
    for (const Element& e : of_kind(parse(figure), "axis-title")) n += e.text == "angle, -";
    return n;
  };
  Figure figure = column();
  CHECK(x_titles(figure) == 1);
  figure.panels[3].x.upper = 2;
  CHECK(x_titles(figure) == 4);
  figure = column();
  figure.columns = 2;
  CHECK(x_titles(figure) == 4);
  const auto frames = of_kind(parse(figure), "frame");
  CHECK(rect_of(frames.at(0)).top == rect_of(frames.at(1)).top);
  CHECK(rect_of(frames.at(0)).left == rect_of(frames.at(2)).left);
  CHECK(rect_of(frames.at(1)).left > rect_of(frames.at(0)).right);
}

TEST_CASE("chart: a zero line is drawn only where the axis crosses zero") {
  Figure figure{.panels = {{.lines = {{.x = {1, 2}, .y = {-1, 1}}}}}};
  CHECK(of_kind(parse(figure), "zero").size() == 1);
  figure.panels[0].lines[0].y = {1, 2};
  CHECK(of_kind(parse(figure), "zero").empty());
}

TEST_CASE("chart: a panel without finite data says so and has axes from 0 to 1") {
  const Figure figure{.panels = {{.lines = {{.x = {nan, 1}, .y = {1, infinity}}}}}};
  const auto elements = parse(figure);
  CHECK(of_kind(elements, "no-data").size() == 1);
  std::vector<std::string> numbers;
  for (const Element& e : of_kind(elements, "number")) numbers.push_back(e.text);
  CHECK(numbers.size() == 12);
  CHECK_THAT(numbers, Catch::VectorContains(std::string("0.0")));
  CHECK_THAT(numbers, Catch::VectorContains(std::string("1.0")));
  CHECK(of_kind(parse(column()), "no-data").empty());
}

TEST_CASE("chart: all text lies on the page") {
  Figure figure = crowd(30);
  figure.title = "A title which is much longer than the small panel of this figure is wide";
  figure.subtitle = "and a subtitle which is longer still, with settings and numbers and units";
  figure.panel_width = 150;
  figure.panel_height = 90;
  figure.panels[0].y.label = "a quantity with a long name";
  figure.panels[0].lines[0].name = "a curve with a name that is longer than the panel is wide";
  const auto elements = parse(figure);
  const Rect page = rect_of(of_kind(elements, "page").at(0));
  for (const Element& text : of_tag(elements, "text")) {
    CAPTURE(text.text);
    if (text.attributes.count("transform") == 0) CHECK(is_within(text_box(text), page));
    CHECK((text.number("x") > 8 && text.number("y") > 8));
  }
}

TEST_CASE("chart: bad input is refused with its name and value") {
  Figure figure = column();
  SECTION("unequal numbers") {
    figure.panels[0].lines[0].y.pop_back();
    CHECK_THROWS_WITH(to_svg(figure), Catch::Contains("'first' has 101 x and 100 y"));
  }
  SECTION("columns") {
    figure.columns = 0;
    CHECK_THROWS_WITH(to_svg(figure), Catch::Contains("columns is 0"));
  }
  SECTION("sizes") {
    figure.panel_width = nan;
    CHECK_THROWS_WITH(to_svg(figure), Catch::Contains("panel_width is nan"));
  }
  SECTION("bounds") {
    figure.panels[2].x.lower = 3;
    CHECK_THROWS_WITH(to_svg(figure), Catch::Contains("axis 'angle': lower 3"));
  }
}

TEST_CASE("chart: nothing has an id, which a page with several charts would have twice") {
  Figure figure;
  Panel panel;
  panel.lines.push_back({.name = "a", .x = {0, 1}, .y = {0, 2}});
  figure.panels = {panel, panel};
  std::size_t frames = 0;
  for (const Element& e : parse(figure)) {
    CHECK(e.attributes.count("id") == 0);
    if (!e.is("within")) continue;
    ++frames;
    // Its own coordinates are those of the page.
    CHECK(e.attributes.at("viewBox") == fmt::format("{} {} {} {}", e.attributes.at("x"),
                                                    e.attributes.at("y"), e.attributes.at("width"),
                                                    e.attributes.at("height")));
  }
  CHECK(frames == 2);
}

}  // namespace camlaw::cli::chart_test

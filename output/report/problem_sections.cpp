// SPDX-License-Identifier: MIT
#include "output/report/problem_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kinematics/peaks.h"
#include "output/answers/buildable_output.h"
#include "output/answers/limit_text.h"
#include "output/answers/profile_output.h"
#include "output/document/formatting.h"
#include "output/report/html.h"
#include "problems/statement/parameters.h"
#include "problems/tolerance/profile_loss.h"

namespace camlaw::cli {
namespace {

using problems::ProblemStatement;

/// A margin as a share of the bound: to the right of the middle what is left, to the left what is
/// passed.
std::string margin_bar(const optim::LimitReport& limit) {
  const double size = std::max(std::abs(limit.bound), std::abs(limit.value));
  const double share =
      std::isfinite(limit.margin) && size > 0 ? std::clamp(limit.margin / size, -1.0, 1.0) : 0;
  const double width = std::max(1.0, 50 * std::abs(share));
  return fmt::format(
      "<svg class=\"bar {}\" viewBox=\"0 0 100 10\" width=\"100\" height=\"10\" "
      "aria-hidden=\"true\"><rect class=\"track\" width=\"100\" height=\"10\"/>"
      "<rect x=\"{:.1f}\" width=\"{:.1f}\" height=\"10\"/>"
      "<path d=\"M50 0V10\"/></svg>",
      limit.met ? "good" : "bad", share < 0 ? 50 - width : 50, width);
}

constexpr std::size_t kSideColumn = 7;  // the column "side" of limit_table

Table limit_table(bool priced) {
  Table table{.columns = {names("limit"), words(""), numbers("value"), numbers("bound"),
                          numbers("margin"), words("unit"), numbers("worst at"), words("side"),
                          words(""), words("proved")}};
  if (priced) table.columns.push_back(numbers("price"));
  return table;
}

Cell with_html(std::string html) {
  Cell cell;
  cell.html = std::move(html);
  return cell;
}

Cell price_cell(double price) {
  if (std::isnan(price)) return "not known";
  return price != 0 ? fmt::format("{:.4g}", price) : "";
}

std::vector<Cell> limit_row(const optim::LimitReport& limit, const LimitText& text,
                            const std::string& side, bool priced,
                            const std::vector<std::string>& blamed) {
  const bool is_blamed = std::find(blamed.begin(), blamed.end(), limit.name) != blamed.end();
  std::vector<Cell> row{limit.name,
                        with_html((limit.met ? badge("good", "met") : badge("bad", "not met")) +
                                  (is_blamed ? fmt::format(" {}", badge("bad", "blamed")) : "")),
                        text.value,
                        text.bound,
                        text.margin,
                        shown_unit(limit.unit),
                        text.place,
                        side,
                        with_html(margin_bar(limit)),
                        limit.proved ? "yes" : "no"};
  if (priced) row.push_back(price_cell(limit.multiplier));
  return row;
}

/// Where a design stands among its bounds, "10 to 120".
std::string bounds_text(const problems::VariableStatement& v) {
  if (!v.values.empty()) return problems::values_text(v.values, "1");
  return fmt::format("{:.6g} to {:.6g}{}", v.lower, v.upper, problems::measured_bounds(v));
}

std::string ruler_words(const Peaks<double>& peak, std::optional<double> lambda) {
  std::string text =
      "The law against what is physically possible. C_v, C_a and C_j are the greatest velocity, "
      "acceleration and jerk of the law over a "
      "unit stroke in unit time, C_Mdyn the greatest product of velocity and acceleration.";
  if (lambda) {
    text += fmt::format(
        " lambda = {:.4f}: no motion from rest to rest with these peaks takes less "
        "than {:.2f} % of the time that this law takes.",
        *lambda, 100 * *lambda);
  }
  if (std::isinf(peak.max_jerk())) text += " C_j is infinite: the acceleration jumps.";
  return text;
}

/// A variable's value in the design.
double value_of_variable(const ProblemStatement& design, const problems::VariableStatement& v) {
  return v.of_law ? v.start : design.constants[v.parameter];
}

/// The law or the program of a design, and its parts from catalogues.
std::string law_words(const ProblemStatement& design) {
  std::string words;
  if (design.mechanism->moved_by != problems::MovedBy::Nothing) {
    const Member law = design.laws.front().listed();
    words = design.mechanism->moved_by == problems::MovedBy::Program
                ? definitions({{"program", law.family->formula}})
                : definitions({{"motion law", law.label()}});
  }
  for (const problems::PartStatement& part : design.parts) {
    words += definitions({{part.name, part.items[part.start].name + ", of " + part.catalogue}});
  }
  return words;
}

std::string parameter_table(const ProblemStatement& design) {
  Table table{.columns = {names("parameter"), numbers("value"), words("unit"), words("meaning")}};
  const auto& parameters = design.mechanism->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    table.add({parameters[i].name, in_digits(design.constants[i]), shown_unit(parameters[i].unit),
               parameters[i].meaning});
  }
  return html_of(table);
}

}  // namespace

ReportSection problem_section(const ProblemStatement& statement) {
  ProblemStatement untitled = statement;
  untitled.title.clear();
  return {"problem", "The problem", list_of_lines(problems::in_words(untitled))};
}

ReportSection values_section(const ProblemStatement& design) {
  Table varied{.columns = {names("variable"), numbers("value"), words("unit"), numbers("between")}};
  for (const auto& v : design.variables) {
    const double value = value_of_variable(design, v);
    const std::string measure = problems::measure_of(v, value);
    varied.add({v.name, in_digits(value) + (measure.empty() ? "" : " (" + measure + ")"),
                shown_unit(v.unit), bounds_text(v)});
  }
  const std::string machine = details("Every parameter of the machine", parameter_table(design));
  constexpr std::size_t kMany = 24;
  const std::size_t count = design.variables.size();
  std::string variables = varied.rows.empty() ? "" : html_of(varied);
  if (count > kMany) variables = details(fmt::format("All {} variables", count), variables);
  return {"values", "The design", variables + law_words(design) + machine};
}

ReportSection limits_section(const ProblemStatement& design,
                             const std::vector<optim::LimitReport>& limits, bool priced,
                             const std::vector<std::string>& blamed) {
  if (limits.empty()) return {"limits", "Limits", paragraph("The problem states no limits.")};
  Table table = limit_table(priced);
  const auto others = problems::other_sides(design, limits);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const auto& other = others[i];
    table.add(limit_row(limits[i], limit_text(limits[i], design, i), nearness(limits[i], other),
                        priced, blamed));
    if (!other) continue;
    table.add(
        limit_row(*other, limit_text(*other, design, i), nearness(*other, limits[i]), priced, {}));
  }
  const bool has_two = std::any_of(others.begin(), others.end(),
                                   [](const auto& other) { return other.has_value(); });
  table.columns[kSideColumn].on_page = has_two;
  std::string notes =
      "The bar shows the margin relative to the bound: to the right of the middle if the limit is "
      "met, to the left if it is violated. Proved: by intervals, over the whole cycle, rounding "
      "included.";
  if (has_two) {
    notes +=
        " Side: of a limit with a lower and an upper bound, the critical side is the one to which "
        "the design is nearer.";
  }
  if (!blamed.empty())
    notes += " Blamed: the search found that these limits cannot be met, alone or together.";
  if (priced)
    notes += " Price: how much the objective improves per unit by which the bound is eased.";
  return {"limits", "Limits", html_of(table) + paragraph(notes)};
}

ReportSection buildable_section(const problems::Buildability& found) {
  return {"buildable", "Can it be built?",
          html_of(buildable_table(found)) + paragraph(buildable_words(found) + ".")};
}

std::optional<ReportSection> profile_section(const ProblemStatement& design) {
  if (!design.profile || !design.profile->any()) return {};
  Document document;
  document.add(Heading{"Errors of the profile"});
  try {
    document.add(profile_document(problems::profile_answer(design, *design.profile)));
  } catch (const std::invalid_argument& error) {
    document.say(error.what() + std::string("\n"));  // undercut, say: the page has all the rest
  }
  return sections_of(document).front();
}

ReportSection numbers_section(const std::vector<problems::EvaluatedResponse>& evaluated) {
  Table table{.columns = {names("number"), numbers("value"), words("unit"), words("meaning")}};
  for (const auto& r : evaluated) {
    if (r.is_curve) continue;
    table.add({r.name, significant(r.value, std::abs(r.value)), shown_unit(r.unit), r.meaning});
  }
  return {"numbers", "Numbers", table.rows.empty() ? "" : html_of(table)};
}

std::optional<ReportSection> rulers_section(const ProblemStatement& design) {
  if (design.mechanism->moved_by != problems::MovedBy::Law) return {};
  const Peaks<double> peak = peaks(design.laws.front().law());
  const std::optional<double> lambda = limit_index(peak);
  Table table{.columns = {words("constant"), numbers("of this law"), numbers("least of any law"),
                          numbers("above it"), words("what it decides")}};
  const auto row = [&](const char* name, double value, std::optional<double> least,
                       const char* decides) {
    const bool measured = lambda && least && std::isfinite(value) && std::isfinite(*least);
    table.add({name, in_digits(value, 6), measured ? in_digits(*least, 6) : "",
               measured ? fmt::format("{:.2f} %", 100 * std::max(0.0, value / *least - 1)) : "",
               decides});
  };
  row("C_v", peak.max_velocity(), 1.0,
      "It sets the pressure angle, and so how large the cam must be.");
  row("C_a", peak.max_acceleration(), least_acceleration(peak.max_velocity()),
      "It sets the inertia force, and so the spring and the contact stress.");
  row("C_j", peak.max_jerk(),
      std::isfinite(peak.max_jerk())
          ? std::optional(least_jerk(peak.max_velocity(), peak.max_acceleration()))
          : std::nullopt,
      "It sets how strongly the follower's train is made to vibrate.");
  row("C_Mdyn", peak.max_dynamic_moment(), {},
      "It sets the peak of the torque that the moved mass asks of the shaft.");
  return ReportSection{
      "rulers", "Figures of merit",
      html_of(table) + paragraph(ruler_words(peak, lambda)) +
          (lambda ? paragraph("Least of any law from rest to rest: of C_v at all, of "
                              "C_a for this C_v, of C_j for this C_v and C_a.")
                  : "")};
}

namespace {

/// What the lines of a picture are, of those that it has.
std::string line_words(const std::string& svg) {
  const auto has = [&](const char* shape) { return svg.find(shape) != std::string::npos; };
  if (has("<title>point on the path</title>")) {
    return paragraph(
        "The dashed curve is the path; the arrow is the direction in which the point runs along "
        "it.");
  }
  if (has("<title>working point</title>")) {
    return paragraph(
        "The motor's speed is to the right, its torque upwards. The shaded area is what the motor "
        "can give, the dashed lines are its continuous torque, and the dashed curve is the path of "
        "the working point through the cycle.");
  }
  if (!has("class=\"arrow\"")) return "";
  std::string words =
      "The blue arrow shows the direction in which the driving part turns or moves.";
  if (has("class=\"base\"")) words += " The dotted circle is the base circle.";
  if (has("class=\"groove\"")) {
    words +=
        " Rollers run in the cam's grooves; what is left between two grooves is a rib. The "
        "dash-dotted line on the cam is its zero, which faces the turret where the angle is 0. "
        "Dashed are the bore and what is behind the cam. Below, the side of the cam that faces the "
        "turret is developed: the angle of the cam is read at the dashed line.";
    return paragraph(words);
  }
  if (has("<path class=\"pitch\"")) words += " The dashed curve is the pitch curve.";
  return paragraph(words);
}

}  // namespace

ReportSection motion_section(const ProblemStatement& design, const std::string& svg) {
  const std::string place = problems::place_name(design);
  const std::string stage = "<div class=\"stage\">" + svg + "</div>\n";
  std::string html = "<div class=\"motion\">\n" + (svg.empty() ? "" : stage + line_words(svg));
  html +=
      "<div class=\"controls\"><button type=\"button\" id=\"play\" "
      "aria-pressed=\"false\">Play</button>\n<label>" +
      plain_name(place.substr(0, place.find(" ["))) +
      " <input type=\"range\" id=\"place\" min=\"0\" max=\"1000\" value=\"0\"></label>\n"
      "<output id=\"place-text\"></output></div>\n</div>\n";
  return {"motion", svg.empty() ? "Through the cycle" : "In motion",
          html + paragraph(
                     "Drag the slider, or press the arrow keys while it has the focus, to move the "
                     "mechanism through its cycle. A thin line marks the same position in "
                     "the charts below; a click into a chart goes to that position.")};
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "kinematics/limits.h"
#include "kinematics/shape.h"
#include "numerics/text/units.h"
#include "output/answers/law_json.h"
#include "output/document/formatting.h"
#include "output/document/printing.h"
#include "output/figure/law_figure.h"
#include "problems/law_files/law_file.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::cli {
namespace {

struct LawOptions {
  std::string name;
  std::vector<std::string> parameters;
  std::optional<std::string> samples, csv, svg;
  bool json = false;
};

/// How many points are wanted; none where that is not said.
std::optional<int> samples_of(const LawOptions& options) {
  constexpr int kFewest = 2, kMost = 1000000;
  if (!options.samples) return {};
  return static_cast<int>(problems::parse_integer(*options.samples, kFewest, kMost, "--samples"));
}

/// Reads a parameter's value with its unit.
double read_quantity(std::string_view text, const Parameter& parameter, const std::string& what) {
  return parse_quantity(text, parameter.unit, parameter.unit, what);
}

std::string peak_line(const char* name, const Peak<double>& peak, const Interval& enclosure) {
  const double width = enclosure.upper() - enclosure.lower();
  const std::string proof = std::isfinite(peak.value) ? fmt::format("proved to {:.0e}", width) : "";
  return fmt::format(
      "  {:<6}{:>20}  at x = {:<20}{}\n", name,
      std::isfinite(peak.value) ? fmt::format("{:.13g}", peak.value) : shown(peak.value, 0),
      fmt::format("{:.13g}", peak.position), proof);
}

void print_parameters(const Member& member) {
  for (std::size_t i = 0; i < member.family->parameters.size(); ++i) {
    const Parameter& p = member.family->parameters[i];
    const std::string unit = p.unit == "1" ? "" : " " + p.unit;
    say("  {} = {}{}  ({:g} .. {:g}; {})\n", p.name, fmt::join(member.arguments.list(i), ","), unit,
        p.low, p.high, p.meaning);
  }
}

void print_law(const Member& member) {
  const Family& family = *member.family;
  const Law<double> law = member.law();
  const auto peak = peaks(law);
  const auto proof = peaks(member.law<Interval>());
  const auto lambda = limit_index(peak);
  say("{}{}\n", member.name(),
      family.aliases.empty() ? "" : fmt::format("  ({})", fmt::join(family.aliases, "; ")));
  say("  {}\n  ends {}, continuity {}, {}; {}\n", family.formula, to_string(law.ends()),
      class_name(continuity(law)), is_symmetric(law) ? "symmetric" : "not symmetric",
      family.source);
  if (!family.parameters.empty()) say("parameters\n");
  print_parameters(member);
  const auto a = Quantity::Acceleration, j = Quantity::Jerk;
  say("peaks\n{}{}{}{}{}{}",
      peak_line("C_v", peak.absolute(Quantity::Velocity), proof.max_velocity()),
      peak_line("C_a+", peak.high(a), proof.high(a).value),
      peak_line("C_a-", peak.low(a), proof.low(a).value),
      peak_line("C_j+", peak.high(j), proof.high(j).value),
      peak_line("C_j-", peak.low(j), proof.low(j).value),
      peak_line("C_Mdyn", peak.absolute(Quantity::Moment), proof.max_dynamic_moment()));
  if (std::isinf(peak.max_jerk()) && std::isfinite(peak.jerk_inside_highest.value) &&
      std::isfinite(peak.jerk_inside_lowest.value)) {
    say("  acceleration jumps; between jumps jerk is {:.8g} .. {:.8g}\n",
        peak.jerk_inside_lowest.value, peak.jerk_inside_highest.value);
  }
  if (lambda) say("  lambda = {:.6f}\n", *lambda);
}

Json sample_to_json(const MotionSample& sample) {
  const auto& [x, m] = sample;
  return {
      {"x", x}, {"s", to_json(m.s)}, {"v", to_json(m.v)}, {"a", to_json(m.a)}, {"j", to_json(m.j)}};
}

/// A text with each of its lines but the first moved in.
std::string moved_in(const std::string& text, std::size_t spaces) {
  std::string result;
  for (const char c : text) {
    result += c;
    if (c == '\n') result.append(spaces, ' ');
  }
  return result;
}

/// Samples one by one: a million of them as one object take a gigabyte.
void print_samples(const Law<double>& law, int count) {
  print_data("  \"samples\": [");
  const char* before = "\n    ";
  for (const MotionSample& sample : motion_samples(law, count)) {
    print_data(before + moved_in(sample_to_json(sample).dump(2), 4));
    before = ",\n    ";
  }
  print_data("\n  ]\n}\n");
}

void print_json(const Member& member, const LawOptions& options) {
  const Law<double> law = member.law();
  Json object = law_to_json(member);
  object["enclosures"] = enclosures_to_json(peaks(member.law<Interval>()));
  object["pieces"] = pieces_to_json(law);
  std::string text = object.dump(2);
  if (!options.samples) {
    print_data(text + "\n");
    return;
  }
  text.erase(text.rfind('\n'));  // the samples are one more member
  print_data(text + ",\n");
  print_samples(law, *samples_of(options));
}

int show_law(const LawOptions& options) {
  keep_standard_output({options.csv, options.svg}, options.json);
  keep_law(options.name);
  Member member = problems::find_any_law(options.name, "", read_quantity);
  for (const std::string& assignment : options.parameters) {
    set_argument(member, assignment, read_quantity);
  }
  const Law<double> law = member.law();
  constexpr int kDefaultSamples = 361;
  const int samples = samples_of(options).value_or(kDefaultSamples);
  std::vector<OutputFile> files;
  if (options.csv) files.push_back({*options.csv, motion_csv(law, samples)});
  if (options.svg) {
    files.push_back(
        {*options.svg, to_svg(motion_figure(member.label(), {{.name = "", .law = law}}))});
  }
  write_files(files);
  if (options.json) {
    print_json(member, options);
    return kDone;
  }
  print_law(member);
  if (options.samples && !options.csv) {
    print_data("samples\n" + motion_csv(law, samples));
  }
  say_written(files);
  return kDone;
}

}  // namespace

Command law_command() {
  const auto options = std::make_shared<LawOptions>();
  return {.name = "law",
          .help = "Show one law: peaks, table, curves",
          .options = {{.names = "NAME",
                       .target = &options->name,
                       .takes = takes::kLaw,
                       .help = "a name of 'camlaw laws', an alias, NAME k=v ..., or a law's file",
                       .required = true},
                      {"--param", &options->parameters, takes::kSetting,
                       "set a parameter: k=v, with a unit if it has one"},
                      {"--samples", &options->samples, takes::kNumber,
                       "tabulate this many even points, 2 to 1000000"},
                      {"--csv", &options->csv, takes::kFile,
                       "write the table (361 points unless --samples) here"},
                      {"--svg", &options->svg, takes::kFile, "draw s, v, a, j here"},
                      json_switch(options->json)},
          .examples = {{"camlaw law modified-sine",
                        "its peaks, where they are, and to what they are proved"},
                       {"camlaw law inclined-sinusoid --param 'angle=75 deg' --svg inclined.svg",
                        "a parameter with its unit; s, v, a and j as a picture"},
                       {"camlaw law 'modified-sine crossover=0.4' --csv table.csv --samples 721",
                        "a table for the control or the cam cutter"}},
          .run = [options] { return show_law(*options); }};
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "numerics/text/units.h"
#include "output/answers/law_output.h"
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

/// Whether a text is a fraction, "1/3", of which the last part is no unit.
bool is_fraction(std::string_view text) {
  const std::size_t slash = text.find('/');
  return slash != std::string_view::npos && text.find_first_not_of("0123456789.+-/ ") == text.npos;
}

/// Reads a parameter's value with its unit.
double read_quantity(std::string_view text, const Parameter& parameter, const std::string& what) {
  if (is_fraction(text)) return read_plain_number(text, parameter, what);
  return parse_quantity(text, parameter.unit, parameter.unit, what);
}

int show_law(const LawOptions& options) {
  keep_plain_outputs({options.csv, options.svg}, options.json);
  keep_law(options.name);
  Member member = problems::find_any_law(options.name, "", read_quantity);
  for (const std::string& assignment : options.parameters) {
    set_argument(member, assignment, read_quantity);
  }
  const Law<double> law = member.law();
  // Both ends and a point each degree, were the motion one turn.
  constexpr int kDefaultSamples = 361;
  const int samples = samples_of(options).value_or(kDefaultSamples);
  std::vector<OutputFile> files;
  const auto table = [law, samples](const auto& take) { motion_csv(law, samples, take); };
  if (options.csv) files.push_back({*options.csv, "", table});
  if (options.svg) {
    files.push_back(
        {*options.svg, to_svg(motion_figure(member.label(), {{.name = "", .law = law}}))});
  }
  write_files(files);
  const Document document = law_document(member);
  if (options.json) {
    options.samples ? print(document, law_samples(law, samples)) : print(document, true);
    return kDone;
  }
  print(document, false);
  if (options.samples && !options.csv) {
    print_data("samples\n");
    table([](std::string_view piece) {
      print_data(piece);
      return !is_reader_gone();
    });
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
                       .help = "a name from 'camlaw laws', an alias, NAME k=v ..., or a law's file",
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
                        "its peaks, where they occur, and the bounds that are proved"},
                       {"camlaw law inclined-sinusoid --param 'angle=75 deg' --svg inclined.svg",
                        "a parameter with its unit; s, v, a and j as a picture"},
                       {"camlaw law 'modified-sine crossover=0.4' --csv table.csv --samples 721",
                        "a table for a controller or a cam milling machine"}},
          .run = [options] { return show_law(*options); }};
}

}  // namespace camlaw::cli

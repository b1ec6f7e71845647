// SPDX-License-Identifier: MIT
#include "cli/man_page.h"

#include <fmt/format.h>

#include "problems/law_files/law_file.h"

namespace camlaw::cli {
namespace {

/// Text as roff takes it: backslashes, hyphens that are minus signs, quotes, no line that begins
/// like a request.
std::string roff(const std::string& text) {
  std::string result;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) result += "\\&";
    line_begins = c == '\n';
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if (c == '\'') {
      result += "\\(aq";
    } else {
      result += c;
    }
  }
  return result;
}

std::string synopsis(const CommandPage& command) {
  std::string text = fmt::format(".B camlaw {}\n", command.name);
  for (const OptionPage& option : command.options) {
    if (!option.positional) continue;
    const std::string shown = option.shown();
    text += roff(option.required ? shown : "[" + shown + "]") + "\n";
  }
  return text + "[options]\n";
}

std::string option_list(const CommandPage& page) {
  std::string text;
  for (const OptionPage& option : page.options) {
    text += fmt::format(".TP\n.B {}\n{}\n", roff(option.shown()), roff(option.help));
  }
  return text;
}

/// The examples as they stand in --help, without their heading.
std::string example_list(const CommandPage& page) {
  if (page.examples.empty()) return {};
  std::string lines = example_lines(page.examples);
  lines.pop_back();  // the last end of a line
  return fmt::format(".PP\nExamples:\n.PP\n.EX\n{}\n.EE\n", roff(lines));
}

std::string command_section(const CommandPage& page) {
  return fmt::format(".SS {}\n{}\n.PP\n{}", roff("camlaw " + page.name), roff(page.help + "."),
                     synopsis(page)) +
         option_list(page) + example_list(page);
}

std::string closing_sections() {
  return fmt::format(
      ".SH EXIT STATUS\n.TP\n.B 0\nSuccess; for a search, a certified or a feasible "
      "design.\n.TP\n.B 1\nA failure, such as a file that cannot be written, or a published value "
      "that is reproduced worse than before.\n.TP\n.B 2\nBad input; one line on standard error "
      "names it and says what is accepted.\n.TP\n.B 3\nNo design meets the limits.\n.TP\n.B 4\nNo "
      "answer, or only a part of it.\n.SH ENVIRONMENT\n.TP\n.B {}\nA folder whose law files are "
      "laws like those of the catalogue.\n.TP\n.B NO_COLOR\nIf it is set, nothing is coloured; "
      "otherwise verdicts are coloured on a terminal.\n",
      problems::kOwnLaws);
}

}  // namespace

std::string man_page(const std::vector<CommandPage>& pages, const std::string& version) {
  std::string text = fmt::format(
      ".TH CAMLAW 1 \"\" \"{0}\" \"User Commands\"\n"
      ".SH NAME\ncamlaw \\- choose, optimise, fit and check cam motion laws and mechanisms\n"
      ".SH SYNOPSIS\n.B camlaw\n.I COMMAND\n[options]\n"
      ".SH DESCRIPTION\ncamlaw holds cam motion laws and the mechanisms that they drive as exact "
      "functions, finds and proves their peaks, searches for the best designs of problem files, "
      "and finds the laws behind measurements and printed tables.\n"
      "Numbers take units (\"40 mm\", \"1.43 rad\").\n"
      ".SH OPTIONS\n",
      roff(version));
  text += option_list(pages.front()) + ".SH COMMANDS\n";
  for (std::size_t i = 1; i < pages.size(); ++i) text += command_section(pages[i]);
  return text + closing_sections();
}

}  // namespace camlaw::cli

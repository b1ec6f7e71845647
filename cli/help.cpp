// SPDX-License-Identifier: MIT
#include "cli/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace camlaw::cli {
namespace {

OptionPage page_of(const Option& option) {
  OptionPage page{.names = {},
                  .takes = option.takes,
                  .help = option.help,
                  .positional = option.is_positional(),
                  .required = option.required,
                  .repeats = option.repeats()};
  std::istringstream names(option.names);
  for (std::string name; std::getline(names, name, ',');) page.names.push_back(name);
  return page;
}

OptionPage switch_page(std::vector<std::string> names, const std::string& help) {
  return {.names = std::move(names), .takes = {}, .help = help};
}

CommandPage page_of(const Command& command) {
  CommandPage page{command.name, command.help, {}, command.examples};
  page.options.push_back(switch_page({"-h", "--help"}, kHelpHelp));
  for (const Option& option : command.options) page.options.push_back(page_of(option));
  for (const Option& option : common_options(nullptr)) page.options.push_back(page_of(option));
  std::stable_partition(page.options.begin(), page.options.end(),
                        [](const OptionPage& option) { return option.positional; });
  return page;
}

}  // namespace

std::string OptionPage::shown() const {
  const std::string text = positional || takes.empty()
                               ? fmt::format("{}", fmt::join(names, ", "))
                               : fmt::format("{} {}", fmt::join(names, ", "), takes);
  return repeats ? text + " ..." : text;
}

std::string example_lines(const std::vector<Example>& examples) {
  std::string text;
  for (const Example& example : examples) {
    text += fmt::format("  {}\n      {}\n", example.line, example.what);
  }
  return text;
}

std::vector<CommandPage> command_pages(const CommandTree& program) {
  CommandPage whole = page_of(Command{program.name, program.help, {}, program.examples, {}});
  whole.options.insert(whole.options.begin() + 1, switch_page({kVersionOption}, kVersionHelp));
  std::vector<CommandPage> pages{std::move(whole)};
  for (const Command& command : program.commands) {
    if (command.is_listed) pages.push_back(page_of(command));
  }
  return pages;
}

}  // namespace camlaw::cli

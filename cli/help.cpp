// SPDX-License-Identifier: MIT
#include "cli/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace camlaw::cli {
namespace {

/// What an option takes, without the ranges that CLI11 puts behind it: "INT:INT in [2 - 9]".
/// Words to choose from are told by themselves: "TEXT:{place,value}".
std::string takes_of(const CLI::Option& option) {
  if (option.get_type_size() == 0) return {};
  const std::string type = option.get_type_name();
  const std::size_t brace = type.find('{');
  return brace == std::string::npos ? type.substr(0, type.find(':')) : type.substr(brace);
}

OptionPage page_of(const CLI::Option& option) {
  OptionPage page{.names = {},
                  .takes = takes_of(option),
                  .help = option.get_description(),
                  .positional = !option.nonpositional(),
                  .required = option.get_required(),
                  .repeats = option.get_items_expected_max() > 1};
  for (const std::string& name : option.get_snames())
    page.names.push_back(fmt::format("-{}", name));
  for (const std::string& name : option.get_lnames())
    page.names.push_back(fmt::format("--{}", name));
  if (page.positional) page.names = {option.get_name(true)};
  return page;
}

CommandPage page_of(const CLI::App& command) {
  CommandPage page{command.get_name(), command.get_description(), command.get_footer(), {}};
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_group().empty()) page.options.push_back(page_of(*option));
  }
  std::stable_partition(page.options.begin(), page.options.end(),
                        [](const OptionPage& option) { return option.positional; });
  return page;
}

}  // namespace

void add_examples(CLI::App& command, const std::vector<Example>& examples) {
  std::string text = "Examples:\n";
  for (const Example& example : examples) {
    text += fmt::format("  {}\n      {}\n", example.line, example.what);
  }
  text.pop_back();  // CLI11 ends it
  command.footer(text);
}

std::string OptionPage::shown() const {
  const std::string text = positional || takes.empty()
                               ? fmt::format("{}", fmt::join(names, ", "))
                               : fmt::format("{} {}", fmt::join(names, ", "), takes);
  return repeats ? text + " ..." : text;
}

std::vector<CommandPage> command_pages(const CLI::App& app) {
  std::vector<CommandPage> pages{page_of(app)};
  for (const CLI::App* command : app.get_subcommands({})) {
    if (!command->get_group().empty()) pages.push_back(page_of(*command));
  }
  return pages;
}

}  // namespace camlaw::cli

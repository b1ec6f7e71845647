// SPDX-License-Identifier: MIT
// The one file that knows the parser's library.
#include "cli/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "cli/help.h"
#include "kinematics/laws/catalogue.h"
#include "numerics/text/names.h"
#include "output/document/terminal.h"

namespace camlaw::cli {
namespace {

std::string examples_text(const std::vector<Example>& examples) {
  std::string text = "Examples:\n" + example_lines(examples);
  text.pop_back();  // CLI11 ends it
  return text;
}

CLI::Option* added(CLI::App& app, const Option& option) {
  if (option.is_switch()) {  // "--json=3" is an error
    return app.add_flag(option.names, *std::get<bool*>(option.target), option.help)
        ->disable_flag_override();
  }
  CLI::Option* result = nullptr;
  if (const auto* list = std::get_if<std::vector<std::string>*>(&option.target)) {
    result = app.add_option(option.names, **list, option.help);
    if (!option.is_positional()) result->allow_extra_args(false);
  } else if (const auto* text = std::get_if<std::string*>(&option.target)) {
    result = app.add_option(option.names, **text, option.help);
  } else {
    result = app.add_option(option.names, *std::get<std::optional<std::string>*>(option.target),
                            option.help);
  }
  result->type_name(option.takes)->required(option.required);
  if (option.words.empty()) return result;
  CLI::Validator is_known = CLI::IsMember(option.words);
  return result->delimiter(',')->check(is_known.description(""));  // `takes` has the words
}

/// What --help says of an option: which others it does not go with, an error says where it matters.
class HelpText : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text = CLI::Formatter::make_option_opts(option);
    text = text.substr(0, text.find(" Excludes:"));
    text = text.substr(0, text.find(" REQUIRED"));  // brackets in the usage mark what is not
    return text == " " + option->get_name() ? "" : text;
  }
};

void add_options(CLI::App& app, const std::vector<Option>& options) {
  for (const Option& option : options) {
    CLI::Option* const its = added(app, option);
    if (!option.excludes.empty()) its->excludes(app.get_option(option.excludes));
  }
}

/// What to say of an unknown word: the commands that are near.
std::string with_near_commands(const CommandTree& program, const std::string& word) {
  std::vector<std::string> known, listed;
  for (const Command& command : program.commands) {
    known.push_back(command.name);
    if (command.is_listed) listed.push_back(command.name);
  }
  const auto near = near_names(word, known);
  return fmt::format(
      "there is no command '{}'; {}", word,
      near.empty() ? fmt::format("there are {}", fmt::join(listed, ", ")) : did_you_mean(near));
}

/// What to say of words that a command does not take.
std::string extra_words(const CLI::App& command, const std::vector<std::string>& extras) {
  std::vector<std::string> options;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  }
  const std::string& first = extras.front();
  const bool is_option = first.starts_with('-');
  const auto near = is_option ? near_names(first, options) : std::vector<std::string>{};
  return fmt::format("{} does not take '{}'{}", command.get_name(), fmt::join(extras, " "),
                     !is_option     ? "; a value with blanks needs quotes"
                     : near.empty() ? ""
                                    : "; " + did_you_mean(near));
}

std::string usage_error(const CommandTree& program, const CLI::App& app,
                        const CLI::ParseError& error, const std::string& word) {
  const auto commands = app.get_subcommands();
  if (commands.empty() && !word.empty()) {
    return word.front() == '-' ? fmt::format("there is no option '{}'; '{} --help' shows the usage",
                                             word, program.name)
                               : with_near_commands(program, word);
  }
  if (commands.empty() && word.empty()) {
    return fmt::format("a command is required; '{} --help' lists them", program.name);
  }
  std::string what = error.what();
  constexpr std::string_view kOverride = " was given a disallowed flag override";
  if (what.ends_with(kOverride)) {
    what = fmt::format("--{} takes no value", what.substr(0, what.size() - kOverride.size()));
  }
  const std::string called =
      commands.empty() ? program.name : program.name + " " + commands.front()->get_name();
  if (!commands.empty() && !commands.front()->remaining().empty()) {
    what = extra_words(*commands.front(), commands.front()->remaining());
  }
  return fmt::format("{}{} '{} --help' shows the usage", what, what.ends_with('?') ? "" : ";",
                     called);
}

}  // namespace

std::vector<Option> common_options(bool* quiet) {
  return {{"-q,--quiet", quiet, takes::kNothing,
           "print only what was asked for: no progress, no list of the files written"}};
}

namespace {

/// "camlaw help fit" is "camlaw fit --help", and "camlaw help" is "camlaw --help". Throws
/// std::invalid_argument for "camlaw help fitt".
std::vector<const char*> with_help_last(const CommandTree& program, int argc,
                                        const char* const* argv) {
  std::vector<const char*> words(argv, argv + argc);
  if (argc < 2 || std::string_view(words[1]) != "help") return words;
  words.erase(words.begin() + 1);
  const auto is_asked = [&](const Command& command) { return command.name == words[1]; };
  const auto& all = program.commands;
  const bool is_option = words.size() == 1 || words[1][0] == '-';
  if (!is_option && std::none_of(all.begin(), all.end(), is_asked)) {
    throw std::invalid_argument(with_near_commands(program, words[1]));
  }
  words.push_back("--help");
  return words;
}

/// The words of a command line, with the two words that an option takes joined as in quotes:
/// "--sample sobol 64". The second is a whole number.
std::vector<std::string> with_pairs_joined(const CommandTree& program,
                                           const std::vector<const char*>& words) {
  std::vector<std::string> result;
  const std::vector<Option>* options = nullptr;  // of the command, once it is named
  const auto takes_two = [&](std::string_view word) {
    return options != nullptr &&
           std::any_of(options->begin(), options->end(), [&](const Option& o) {
             return o.takes == takes::kSampling && o.names == word;
           });
  };
  const auto is_whole = [](std::string_view word) {
    return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = words[i];
    const std::size_t equals = word.find('=');
    const bool is_first = !result.empty() && takes_two(result.back());
    const bool has_first = equals != std::string::npos && takes_two(word.substr(0, equals));
    result.push_back(word);
    if ((is_first || has_first) && i + 1 < words.size() && is_whole(words[i + 1])) {
      result.back() += fmt::format(" {}", words[++i]);
    }
    if (i == 0 || options != nullptr) continue;
    for (const Command& command : program.commands) {
      if (command.name == word) options = &command.options;
    }
  }
  return result;
}

}  // namespace

const Command* parsed(const CommandTree& program, int argc, const char* const* argv) {
  CLI::App app(program.help, program.name);
  app.formatter(std::make_shared<HelpText>());  // commands take it over
  app.set_help_flag("-h,--help", kHelpHelp);
  app.set_version_flag(kVersionOption, program.version, kVersionHelp);
  app.require_subcommand(1);
  bool quiet = false;
  const Command* called = nullptr;
  for (const Command& command : program.commands) {
    CLI::App* const its = app.add_subcommand(command.name, command.help);
    add_options(*its, command.options);
    add_options(*its, common_options(&quiet));
    if (!command.examples.empty()) its->footer(examples_text(command.examples));
    if (!command.is_listed) its->group("");
    its->callback([&called, &command] { called = &command; });
  }
  add_options(app, common_options(&quiet));
  app.footer(examples_text(program.examples));  // commands would take it over
  const std::vector<std::string> joined =
      with_pairs_joined(program, with_help_last(program, argc, argv));
  std::vector<const char*> words;
  for (const std::string& word : joined) words.push_back(word.c_str());
  try {
    app.parse(static_cast<int>(words.size()), words.data());
  } catch (const CLI::Success& request) {
    app.exit(request);
    return nullptr;
  } catch (const CLI::ParseError& error) {
    std::size_t word = 1;  // the first that is not an option of the program
    while (word < words.size() && app.get_option_no_throw(words[word]) != nullptr) ++word;
    throw std::invalid_argument(
        usage_error(program, app, error, word < words.size() ? words[word] : ""));
  }
  if (quiet) set_quiet(true);
  return called;
}

}  // namespace camlaw::cli

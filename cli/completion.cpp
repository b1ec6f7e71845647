// SPDX-License-Identifier: MIT
#include "cli/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "kinematics/laws/catalogue.h"
#include "machines/model/mechanism.h"
#include "machines/registry.h"
#include "optim/solvers/solver.h"
#include "problems/published/systems.h"

namespace camlaw::cli {
namespace {

template <typename List>
std::vector<std::string> names_of(const List& list) {
  std::vector<std::string> names;
  for (const auto& entry : list) {
    if (entry.name.find(' ') == std::string::npos) names.push_back(entry.name);
  }
  return names;
}

std::vector<std::string> solvers() {
  std::vector<std::string> names = optim::solver_names();
  names.insert(names.begin(), "auto");
  return names;
}

/// "{a,b}".
std::vector<std::string> words_in_braces(const std::string& text) {
  std::istringstream list(text.substr(1, text.size() - 2));
  std::vector<std::string> words;
  for (std::string word; std::getline(list, word, ',');) words.push_back(word);
  return words;
}

/// All long and short names of a page's options, in one line.
std::string option_words(const CommandPage& page) {
  std::vector<std::string> words;
  for (const OptionPage& option : page.options) {
    if (option.positional) continue;
    words.insert(words.end(), option.names.begin(), option.names.end());
  }
  return fmt::format("{}", fmt::join(words, " "));
}

std::string command_words(const std::vector<CommandPage>& pages) {
  std::vector<std::string> words;
  for (std::size_t i = 1; i < pages.size(); ++i) words.push_back(pages[i].name);
  return fmt::format("{}", fmt::join(words, " "));
}

/// One branch for each kind of value that any option takes.
std::string bash_values(const std::vector<CommandPage>& pages) {
  std::map<std::string, Candidates> kinds;
  for (const CommandPage& page : pages) {
    for (const OptionPage& option : page.options) {
      if (!option.takes.empty()) kinds[option.takes] = candidates(option.takes);
    }
  }
  std::string text;
  for (const auto& [kind, values] : kinds) {
    if (values.words.empty() && !values.files && !values.folders) continue;
    text += fmt::format("    '{}')\n", kind);
    if (values.files || values.folders) text += "      compopt -o filenames 2>/dev/null\n";
    text += fmt::format(
        "      mapfile -t COMPREPLY < <(compgen{}{} -- \"$2\") ;;\n",
        values.words.empty() ? "" : fmt::format(" -W '{}'", fmt::join(values.words, " ")),
        values.files     ? " -f"
        : values.folders ? " -d"
                         : "");
  }
  return text;
}

/// What follows the options of a command that take values, and its first positional.
std::string bash_kinds(const CommandPage& page) {
  std::string text;
  for (const OptionPage& option : page.options) {
    if (option.positional || option.takes.empty()) continue;
    for (const std::string& name : option.names) {
      text += fmt::format("    '{} {}') kind='{}' ;;\n", page.name, name, option.takes);
    }
  }
  return text;
}

std::string positional_kind(const CommandPage& page) {
  const auto first = std::find_if(page.options.begin(), page.options.end(),
                                  [](const OptionPage& option) { return option.positional; });
  return first == page.options.end() ? "" : first->takes;
}

}  // namespace

Candidates candidates(const std::string& kind) {
  if (kind.starts_with('{')) return {words_in_braces(kind)};
  if (kind == takes::kFile || kind == takes::kResult) return {{}, true, false};
  if (kind == takes::kFolder) return {{}, false, true};
  if (kind == takes::kLaw) return {names_of(catalogue()), true, false};
  if (kind == takes::kMechanism) return {names_of(problems::mechanisms()), true, false};
  if (kind == takes::kSolver) return {solvers()};
  if (kind == takes::kSystem) return {names_of(problems::reproducible_systems())};
  return {};
}

std::string bash_completion(const std::vector<CommandPage>& pages) {
  std::string kinds, words;
  for (std::size_t i = 1; i < pages.size(); ++i) {
    kinds += bash_kinds(pages[i]);
    words += fmt::format("    {}) options='{}' kind='{}' ;;\n", pages[i].name,
                         option_words(pages[i]), positional_kind(pages[i]));
  }
  return fmt::format(
      "# Completion for bash, printed by 'camlaw completion bash'.\n"
      "_camlaw_values() {{\n  case $1 in\n{}  esac\n}}\n\n"
      "_camlaw() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}\n"
      "  local command=${{COMP_WORDS[1]}} kind='' options=''\n  COMPREPLY=()\n"
      "  if ((COMP_CWORD == 1)); then\n"
      "    mapfile -t COMPREPLY < <(compgen -W '{} {}' -- \"$current\")\n    return\n  fi\n"
      "  case \"$command $before\" in\n{}  esac\n"
      "  if [[ -n $kind ]]; then\n    _camlaw_values \"$kind\" \"$current\"\n    return\n  fi\n"
      "  case $command in\n{}  esac\n"
      "  if [[ $current == -* ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$current\")\n"
      "  else\n    _camlaw_values \"$kind\" \"$current\"\n  fi\n}}\n"
      "complete -F _camlaw camlaw\n",
      bash_values(pages), command_words(pages), option_words(pages.front()), kinds, words);
}

}  // namespace camlaw::cli

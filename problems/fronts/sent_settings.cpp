// SPDX-License-Identifier: MIT
#include "problems/fronts/sent_settings.h"

#include <fmt/format.h>

#include <stdexcept>

#include "problems/fronts/problem_settings.h"

namespace camlaw::problems {

void add_settings_to(std::vector<std::string>& texts, const optim::StudySettings& settings) {
  texts.push_back(fmt::format("{}", settings.size()));
  for (const auto& [name, text] : settings) texts.insert(texts.end(), {name, text});
}

std::size_t SentTexts::count() { return std::stoul(text()); }

optim::StudySettings SentTexts::settings() {
  optim::StudySettings settings;
  for (std::size_t left = count(); left > 0; --left) {
    const std::string& name = text();
    settings[name] = text();
  }
  const std::string mine = problem_versions(), its = find_setting(settings, "versions");
  if (its == mine) return settings;
  throw std::invalid_argument(
      fmt::format("the worker program is of {}, the caller of {}", mine, its));
}

}  // namespace camlaw::problems

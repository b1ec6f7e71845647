// SPDX-License-Identifier: MIT
#include "problems/statement/profile_errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/text/units.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

/// A key, its unit, the largest value that is accepted, and what it takes the place of.
struct ProfileKey {
  const char* key;
  const char* unit;
  double most;
  std::optional<double> ProfileErrors::*own;
  std::optional<double> ProfileErrors::*instead = nullptr;
};

const std::vector<ProfileKey>& keys() {
  using E = ProfileErrors;
  static const std::vector<ProfileKey> all{{"waviness", "um", 1e4, &E::waviness},
                                           {"waves", "1", 1e5, &E::waves, &E::wavelength},
                                           {"wavelength", "mm", 1e4, &E::wavelength, &E::waves},
                                           {"form", "mm", 10, &E::form},
                                           {"chord", "mm", 10, &E::chord, &E::chord_step},
                                           {"chord_step", "deg", 45, &E::chord_step, &E::chord},
                                           {"loss", "1", 100, &E::loss}};
  return all;
}

const ProfileKey& key_named(std::string_view key) {
  return *std::find_if(keys().begin(), keys().end(),
                       [&](const ProfileKey& one) { return key == one.key; });
}

/// The key of what one takes the place of.
const char* excluded_by(const ProfileKey& key) {
  return std::find_if(keys().begin(), keys().end(),
                      [&](const ProfileKey& one) { return one.own == key.instead; })
      ->key;
}

void set(ProfileErrors& errors, const ProfileKey& key, double value) {
  if (!(value > 0 && value <= key.most)) {
    throw std::invalid_argument(fmt::format("{}: it must be above 0 and at most {}", key.key,
                                            with_unit(key.most, key.unit)));
  }
  if (key.own == &ProfileErrors::waves && value != std::round(value)) {
    throw std::invalid_argument(
        fmt::format("waves: a turn has a whole number of them; {:.10g} is given", value));
  }
  if (key.instead != nullptr) (errors.*key.instead).reset();
  errors.*key.own = value;
}

}  // namespace

std::vector<std::string> profile_keys() {
  std::vector<std::string> names;
  for (const ProfileKey& key : keys()) names.emplace_back(key.key);
  return names;
}

void set_profile_errors(ProfileErrors& errors,
                        const std::map<std::string, std::optional<std::string>>& stated) {
  for (const auto& [key, text] : stated) {
    if (!text) continue;
    const ProfileKey& own = key_named(key);
    const auto other = own.instead != nullptr ? stated.find(excluded_by(own)) : stated.end();
    if (other != stated.end() && other->second) {
      throw std::invalid_argument(
          fmt::format("{} and {} are both stated; state one of them", key, other->first));
    }
    set(errors, own, parse_quantity(*text, own.unit, own.unit, own.key));
  }
}

void check_profile_errors(const ProfileErrors& errors) {
  if (errors.waviness && !errors.has_length()) {
    throw std::invalid_argument(
        "waviness: state waves (their number in a turn) or wavelength (their length along the "
        "profile) too; the acceleration grows with the square of the number of waves");
  }
  if (errors.has_length() && !errors.waviness && !errors.form && !errors.loss) {
    throw std::invalid_argument(fmt::format(
        "{}: state what has so many waves: waviness, form, or the loss that is accepted",
        errors.waves ? "waves" : "wavelength"));
  }
}

ProfileErrors profile_errors_of(const ProblemStatement& problem) {
  return problem.profile ? *problem.profile : ProfileErrors{};
}

std::string words_of(const ProfileErrors& errors) {
  const std::string length = errors.waves        ? fmt::format("{:.10g} a turn", *errors.waves)
                             : errors.wavelength ? with_unit(*errors.wavelength, "mm") + " each"
                                                 : "";
  std::vector<std::string> parts;
  if (errors.waviness) {
    parts.push_back(fmt::format("waviness {} ({})", with_unit(*errors.waviness, "um"), length));
  }
  if (errors.form) {
    parts.push_back(
        fmt::format("a profile tolerance of {}{}", with_unit(*errors.form, "mm"),
                    length.empty() ? "" : fmt::format(" (no waves shorter than {})", length)));
  }
  if (errors.chord) parts.push_back("chords within " + with_unit(*errors.chord, "mm"));
  if (errors.chord_step) parts.push_back("chords of " + with_unit(*errors.chord_step, "deg"));
  if (errors.loss) {
    parts.push_back(fmt::format("peaks that grow by {:.6g} % at most", 100 * *errors.loss));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

void read_profile_errors(const Entry& file, ProblemStatement& problem) {
  const Entry* table = find(file, "profile");
  if (table == nullptr) return;
  expect(*table, Entry::Kind::Table, "a table, [profile]");
  check_keys(*table, profile_keys());
  auto errors = std::make_shared<ProfileErrors>();
  for (const Entry& entry : table->items) {
    const ProfileKey& key = key_named(entry.key);
    if (key.instead != nullptr && (*errors).*key.instead) {
      refuse(entry, fmt::format("{} is stated too; state one of them", excluded_by(key)));
    }
    const double value = quantity_of(entry, key.unit);
    located(entry, [&] { set(*errors, key, value); });
  }
  located(*table, [&] { check_profile_errors(*errors); });
  problem.profile = std::move(errors);
}

}  // namespace camlaw::problems

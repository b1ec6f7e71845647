// SPDX-License-Identifier: MIT
#include "cli/version_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/Version.hpp>
#include <nlohmann/json.hpp>

#include "optim/versions.h"
#include "output/document/short_version.h"
#include "output/export/solid/step_file.h"

namespace camlaw::cli {
namespace {

std::string fmt_version() {
  return fmt::format("fmt {}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
                     FMT_VERSION % 100);
}

std::string json_version() {
  return fmt::format("nlohmann-json {}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                     NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH);
}

}  // namespace

std::string version_text() {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}", short_version(),
                     fmt::join(optim::library_versions(), "\n"), problems::step_version(),
                     "cli11 " CLI11_VERSION, fmt_version(), json_version());
}

}  // namespace camlaw::cli

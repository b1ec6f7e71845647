// SPDX-License-Identifier: MIT
#include "problems/published/systems.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "numerics/text/csv_rows.h"
#include "numerics/text/file_text.h"
#include "problems/baseline.csv.h"
#include "problems/published/balancing_cam.toml.h"
#include "problems/published/cam_shape/reproduction.h"
#include "problems/published/die_press.toml.h"
#include "problems/published/motion_laws.toml.h"
#include "problems/published/sheet_delivery.toml.h"
#include "problems/published/signature_feeder.toml.h"
#include "problems/published/spine_cutter.toml.h"
#include "problems/published/table/stated_table.h"

namespace camlaw::problems {

namespace {

/// A system whose table is one of the program's files.
ReproducibleSystem stated(std::string name, std::string_view text) {
  const std::string file = "problems/published/" + name + ".toml";
  return {std::move(name), [file, text](const std::atomic<bool>* stop) {
            SystemReproduction result = reproduce_table(read_stated_table(text, file), stop);
            result.is_shipped = true;
            return result;
          }};
}

}  // namespace

const std::vector<ReproducibleSystem>& reproducible_systems() {
  static const std::vector<ReproducibleSystem> systems{
      stated("spine-cutter", data::spine_cutter),
      stated("balancing-cam", data::balancing_cam),
      stated("die-press", data::die_press),
      stated("sheet-delivery", data::sheet_delivery),
      stated("signature-feeder", data::signature_feeder),
      stated("motion-laws", data::motion_laws),
      {"cam-shape", [](const std::atomic<bool>* stop) {
         SystemReproduction result = reproduce_cam_shape(stop);
         result.is_shipped = true;
         return result;
       }}};
  return systems;
}

namespace {

/// Adds what a table's texts name that may be files of laws or motions beside it.
void add_files(const Entry& entry, const std::filesystem::path& folder,
               std::vector<std::string>& files) {
  if (entry.kind == Entry::Kind::Text) {
    const bool is_file = entry.text.ends_with(".json") || entry.text.ends_with(".csv");
    if (is_file) files.push_back((folder / entry.text).string());
  }
  for (const Entry& item : entry.items) add_files(item, folder, files);
}

}  // namespace

bool names_table_file(const std::string& name_or_path) {
  return name_or_path.ends_with(".toml") || name_or_path.find('/') != std::string::npos;
}

ReproducibleSystem find_reproducible(const std::string& name_or_path) {
  if (names_table_file(name_or_path)) {
    StatedTable table = read_stated_table(file_text(name_or_path, "table"), name_or_path);
    std::string name = table.name;
    std::vector<std::string> files{name_or_path};
    add_files(table.file, std::filesystem::path(name_or_path).parent_path(), files);
    return {std::move(name),
            [table = std::move(table)](const std::atomic<bool>* stop) {
              return reproduce_table(table, stop);
            },
            std::move(files)};
  }
  std::vector<std::string> known;
  for (const ReproducibleSystem& system : reproducible_systems()) {
    if (system.name == name_or_path) return system;
    known.push_back(system.name);
  }
  throw std::invalid_argument(
      fmt::format("'{}' is not a system; use {}, or the file of a table, which ends in .toml",
                  name_or_path, fmt::join(known, ", ")));
}

namespace {

optim::Finding read_finding(const std::string& text) {
  using optim::Finding;
  for (const Finding verdict : {Finding::Reproduced, Finding::Explained, Finding::Unexplained}) {
    if (text == to_string(verdict)) return verdict;
  }
  throw std::invalid_argument("baseline.csv: there is no verdict '" + text + "'");
}

struct Expected {
  std::string system, id;
  optim::Finding verdict;
};

std::vector<Expected> read_baseline() {
  std::vector<Expected> result;
  for (const CsvRow& row : csv_rows(data::baseline, {"system", "id", "verdict"})) {
    result.push_back({row.cells[0], row.cells[1], read_finding(row.cells[2])});
  }
  return result;
}

}  // namespace

std::vector<std::string> worsened(const SystemReproduction& result) {
  static const std::vector<Expected> baseline = read_baseline();
  std::vector<std::string> worse;
  if (!result.is_shipped) return worse;
  for (const Expected& expected : baseline) {
    if (expected.system != result.system) continue;
    const auto found =
        std::find_if(result.values.begin(), result.values.end(),
                     [&](const ReproducedValue& v) { return v.printed.id == expected.id; });
    if (found != result.values.end() && found->verdict <= expected.verdict) continue;
    worse.push_back(fmt::format("{}: {} was {} and is {}", expected.system, expected.id,
                                to_string(expected.verdict),
                                found == result.values.end() ? "gone" : to_string(found->verdict)));
  }
  return worse;
}

}  // namespace camlaw::problems

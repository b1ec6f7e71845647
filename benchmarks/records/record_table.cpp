// SPDX-License-Identifier: MIT
#include "benchmarks/records/record_table.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <set>

#include "benchmarks/timing.h"

namespace camlaw::benchmarks {
namespace {

std::string percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? ""
                    : fmt::format("{:.1f} %",
                                  100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string row(const std::string& name, const RecordTally& t) {
  const std::size_t single = t.records - t.split;
  double logarithms = 0;
  for (const double w : t.widths) logarithms += std::log(w) / static_cast<double>(t.widths.size());
  return fmt::format(
      "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", name, t.records, t.split,
      percent(t.right, single), percent(t.among, single),
      t.as_good.empty() ? "" : fmt::format("{:.0f}", median(t.as_good)), percent(t.trusted, single),
      percent(t.false_trust, single), percent(t.held, t.intervals),
      t.widths.empty() ? ""
                       : fmt::format("{:.2f}, {:.2f}", median(t.widths), std::exp(logarithms)));
}

}  // namespace

void RecordTally::add(const RecordVerdict& v) {
  ++records;
  if (!v.is_one_motion) {
    ++split;
    return;
  }
  right += v.is_right, among += v.is_among, trusted += v.trusted;
  false_trust += v.trusted && !v.is_among;
  as_good.push_back(static_cast<double>(v.as_good));
  if (!v.trusted) return;
  for (std::size_t j = 0; j < v.held.size(); ++j) {
    if (v.held[j]) ++intervals, held += *v.held[j];
    // 0 where the true law alone leaves the number open.
    if (v.width[j].value_or(0) > 0) widths.push_back(*v.width[j]);
  }
}

std::string record_table(const std::vector<RecordVerdict>& verdicts) {
  std::string table =
      "| records | number | not one motion | right law named | named or as good | as good, median "
      "| trusted | false trust | intervals that hold | width, median and geometric mean |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  using Which = std::function<bool(const RecordVerdict&)>;
  const std::vector<std::pair<std::string, Which>> rows{
      {"all", [](const auto&) { return true; }},
      {"displacement", [](const auto& v) { return v.order == 0; }},
      {"velocity", [](const auto& v) { return v.order == 1; }},
      {"acceleration", [](const auto& v) { return v.order == 2; }},
      {"displacement, not rounded", [](const auto& v) { return v.order == 0 && v.step == 0; }},
      {"rounded to less than the noise",
       [](const auto& v) { return v.order == 0 && v.step > 0 && v.step < 1; }},
      {"to 1 to 5 times the noise",
       [](const auto& v) { return v.order == 0 && v.step >= 1 && v.step < 5; }},
      {"to 5 times the noise and more", [](const auto& v) { return v.order == 0 && v.step >= 5; }},
      {"noise below 1e-4", [](const auto& v) { return v.order == 0 && v.noise < 1e-4; }},
      {"noise from 1e-4 to 1e-3",
       [](const auto& v) { return v.order == 0 && v.noise >= 1e-4 && v.noise < 1e-3; }},
      {"noise from 1e-3 to 1e-2", [](const auto& v) { return v.order == 0 && v.noise >= 1e-3; }}};
  for (const auto& [name, which] : rows) {
    RecordTally tally;
    for (const RecordVerdict& v : verdicts) {
      if (which(v)) tally.add(v);
    }
    if (tally.records > 0) table += row(name, tally);
  }
  return table;
}

std::vector<RecordVerdict> read_verdicts(const std::string& file) {
  std::vector<RecordVerdict> verdicts;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) verdicts.push_back(verdict_of_line(line));
  return verdicts;
}

void simulate_records(const std::string& file, std::uint64_t first, std::uint64_t count,
                      Disturbance disturbance) {
  std::set<std::uint64_t> known;
  for (const RecordVerdict& v : read_verdicts(file)) known.insert(v.number);
  std::ofstream out(file, std::ios::app);
  for (std::uint64_t number = first; number < first + count; ++number) {
    if (known.contains(number)) continue;
    out << line_of(verdict_of(number, disturbance)) << std::endl;  // whole lines, whatever comes
  }
}

}  // namespace camlaw::benchmarks

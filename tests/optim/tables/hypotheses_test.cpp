// SPDX-License-Identifier: MIT
#include "optim/tables/hypotheses.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

namespace camlaw::optim::hypotheses_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
using Causes = std::vector<std::pair<std::size_t, int>>;

Hypothesis hypothesis(const std::string& name, int alternatives, bool unstated = false) {
  Hypothesis result{name, "as stated", {}, unstated};
  for (int k = 1; k <= alternatives; ++k) result.alternatives.push_back(std::to_string(k));
  return result;
}

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// --- An independent judge: every assignment of the full product, scored by the definition.
// -----------

using Key = std::tuple<std::size_t, std::size_t, std::size_t, int, Assignment>;

Assignment only(const std::vector<std::size_t>& depends, const Assignment& choice) {
  Assignment result(choice.size(), 0);
  for (const std::size_t h : depends) result[h] = choice[h];
  return result;
}

double value(const PrintedTable& table, std::size_t row, const Assignment& choice) {
  for (const std::size_t h : table.depends[row])
    if (table.hypotheses[h].unstated && choice[h] == 0) return kNan;
  return table.model(row, only(table.depends[row], choice));
}

Key judge(const PrintedTable& table, const Assignment& choice) {
  std::size_t lost = 0;
  std::size_t misprints = 0;
  for (std::size_t row = 0; row < table.printed.size(); ++row) {
    const double ours = value(table, row, choice);
    if (agrees(table.printed[row], ours)) continue;
    const bool misprint = table.allow_misprints && one_digit_misprint(table.printed[row], ours);
    ++(misprint ? misprints : lost);
  }
  std::size_t departures = misprints;
  int ranks = 0;
  for (const int c : choice) {
    departures += c != 0;
    ranks += c;
  }
  return {lost, departures, misprints, ranks, choice};
}

std::vector<Key> judge_all(const PrintedTable& table) {
  std::vector<Key> keys;
  Assignment choice(table.hypotheses.size(), 0);
  for (;;) {
    keys.push_back(judge(table, choice));
    std::size_t h = 0;
    while (h < choice.size() &&
           ++choice[h] > static_cast<int>(table.hypotheses[h].alternatives.size()))
      choice[h++] = 0;
    if (h == choice.size()) break;
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

void check_against_full_product(const PrintedTable& table) {
  const Reproduction found = reproduce(table);
  const std::vector<Key> keys = judge_all(table);
  const auto& [lost, departures, misprints, ranks, choice] = keys.front();
  REQUIRE(found.departures == choice);
  REQUIRE(found.held == table.printed.size() - lost);
  REQUIRE(found.misprints == misprints);
  REQUIRE(found.departed + found.misprints == departures);
  std::vector<Assignment> equals;
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (std::get<0>(keys[i]) == lost && std::get<1>(keys[i]) == departures)
      equals.push_back(std::get<4>(keys[i]));
  REQUIRE(found.more_equals == (equals.size() > kMaxEquals));
  if (equals.size() > kMaxEquals) equals.resize(kMaxEquals);
  REQUIRE(found.equals == equals);
}

void check_rows_against_definition(const PrintedTable& table) {
  const Reproduction found = reproduce(table);
  REQUIRE(found.rows.size() == table.printed.size());
  REQUIRE(found.reproduced + found.explained + found.unexplained == table.printed.size());
  std::size_t held = 0;
  for (std::size_t row = 0; row < found.rows.size(); ++row) {
    const Explanation& e = found.rows[row];
    const PrintedNumber print = table.printed[row];
    const double as_stated = value(table, row, Assignment(table.hypotheses.size(), 0));
    const double explained = value(table, row, found.departures);
    REQUIRE((e.value == as_stated || (std::isnan(e.value) && std::isnan(as_stated))));
    REQUIRE((e.explained_value == explained ||
             (std::isnan(e.explained_value) && std::isnan(explained))));
    REQUIRE((e.verdict == Finding::Reproduced) == agrees(print, as_stated));
    REQUIRE(e.broken == (agrees(print, as_stated) && !agrees(print, explained)));
    const bool misprint = table.allow_misprints && one_digit_misprint(print, explained);
    REQUIRE(e.misprint == misprint);
    held += misprint || agrees(print, explained);
    if (e.verdict != Finding::Explained) {
      REQUIRE(e.causes.empty());
      continue;
    }
    Assignment part(table.hypotheses.size(), 0);
    for (const auto& [h, k] : e.causes) {
      REQUIRE(found.departures[h] == k);
      part[h] = k;
    }
    const auto fits = [&](const Assignment& c) {
      const double ours = value(table, row, c);
      return e.misprint ? one_digit_misprint(print, ours) : agrees(print, ours);
    };
    REQUIRE(fits(part));
    for (const auto& [h, k] : e.causes) {  // and none of the causes is idle
      Assignment less = part;
      less[h] = 0;
      REQUIRE_FALSE(fits(less));
    }
  }
  REQUIRE(found.held == held);
}

/// The finaliser of splitmix64: a well-mixed number for each number.
std::uint64_t scramble(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// A table whose rows are lookups in random numbers: nothing smooth for a search to lean on. Few
/// distinct values, so that rows hold under many assignments, ties are common and conflicts too.
PrintedTable random_table(std::mt19937& random, int distinct, double nan_share) {
  const auto draw = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  PrintedTable table;
  table.name = "random";
  const int hypotheses = draw(0, 5);
  for (int h = 0; h < hypotheses; ++h)
    table.hypotheses.push_back(hypothesis("h" + std::to_string(h), draw(0, 4), draw(0, 4) == 0));
  const int rows = draw(1, 6);
  for (int row = 0; row < rows; ++row) {
    table.printed.push_back({draw(0, distinct) + 0.1 * draw(0, 1), draw(0, 1)});
    std::vector<std::size_t> depends;
    for (int h = 0; h < hypotheses; ++h)
      if (draw(0, 2) != 0) depends.push_back(at(h));
    std::shuffle(depends.begin(), depends.end(), random);
    table.depends.push_back(depends);
  }
  table.allow_misprints = draw(0, 1) == 1;
  const std::uint64_t seed = random();
  table.model = [=](std::size_t row, std::span<const int> choice) {
    std::uint64_t mixed = scramble(seed + row);
    for (const int c : choice) mixed = scramble(mixed + static_cast<std::uint64_t>(c));
    if (static_cast<double>(mixed % 1000) < 1000.0 * nan_share) return kNan;
    const int whole = static_cast<int>((mixed >> 20) % (static_cast<std::uint64_t>(distinct) + 1));
    return whole + 0.1 * static_cast<double>((mixed >> 50) % 2);
  };
  return table;
}

TEST_CASE("the search finds what the full product finds, ties included") {
  std::mt19937 random(20240704);
  for (int trial = 0; trial < 600; ++trial) {
    CAPTURE(trial);
    const PrintedTable table =
        random_table(random, trial % 3 == 0 ? 12 : 2 + trial % 5, 0.1 * (trial % 4));
    check_against_full_product(table);
    check_rows_against_definition(table);
  }
}

// --- The spine cutter's tables (docs: reference data "spine-cutter")
// ---------------------------------

constexpr double kOuterRadius = 25.0;  // mm
double contact_angle(double depth) { return 2.0 * std::acos(1.0 - depth / kOuterRadius); }

TEST_CASE("the blades in contact are explained by 21 blades instead of 17") {
  constexpr std::array<double, 8> kBlades{17, 16, 18, 19, 20, 21, 22, 24};
  constexpr std::array<double, 4> kDepth{0.4, 0.6, 0.8, 1.0};
  PrintedTable table;
  table.name = "table 1";
  table.printed = {{20.5, 1}, {25.2, 1}, {29.1, 1}, {32.5, 1},
                   {1.2, 1},  {1.47, 2}, {1.7, 1},  {1.9, 1}};
  table.hypotheses = {hypothesis("blades", 7), hypothesis("idle", 3)};
  table.depends = {{}, {}, {}, {}, {0, 1}, {0}, {0}, {0}};
  table.model = [&](std::size_t row, std::span<const int> choice) {
    const double angle = contact_angle(kDepth[row % 4]);
    if (row < 4) return angle * 180.0 / std::numbers::pi;
    return angle * kBlades[at(choice[0])] / (2.0 * std::numbers::pi);
  };
  const Reproduction found = reproduce(table);
  CHECK(found.departures == Assignment{5, 0});
  CHECK(found.equals.empty());
  CHECK(found.reproduced == 4);
  CHECK(found.explained == 4);
  CHECK(found.departed == 1);
  CHECK(found.misprints == 0);
  CHECK(found.rows[5].causes == Causes{{0, 5}});
  CHECK(found.rows[5].value == Approx(contact_angle(0.6) * 17 / (2.0 * std::numbers::pi)));
  CHECK(found.rows[0].verdict == Finding::Reproduced);
}

struct Peaks {
  double velocity = 0.0;
  double acceleration = 0.0;
};

/// Peaks of s' = a q + b q^2 + c q^3, q = x (1 - x), read off `steps` equal steps.
Peaks read_off(std::array<double, 3> coefficients, int steps) {
  const auto [a, b, c] = coefficients;
  Peaks peaks;
  for (int i = 0; i <= steps; ++i) {
    const double x = static_cast<double>(i) / steps;
    const double q = x * (1.0 - x);
    peaks.velocity = std::max(peaks.velocity, std::abs(q * (a + q * (b + q * c))));
    peaks.acceleration =
        std::max(peaks.acceleration, std::abs((1.0 - 2.0 * x) * (a + q * (2.0 * b + q * 3.0 * c))));
  }
  return peaks;
}

// Hypotheses of table 2; hypothesis 1 is the factor in the force.
constexpr std::size_t kDepthInput = 0;
constexpr std::size_t kGridInput = 2;
constexpr std::size_t kFirstA = 3;
constexpr std::size_t kSecondA = 4;

/// Table 2: peak force and minimum radius of six laws. The source leaves the coefficient A of the
/// two degree-7 laws open; the cosine and the cubic peak on every grid.
PrintedTable inertia_table(std::size_t* calls) {
  PrintedTable table;
  table.name = "table 2";
  table.printed = {{5.34, 2},  {4.33, 2},  {3.75, 2},  {4.56, 2},  {3.54, 2},  {3.63, 2},
                   {46.86, 2}, {37.21, 2}, {34.55, 2}, {33.08, 2}, {35.56, 2}, {37.21, 2}};
  table.hypotheses = {hypothesis("depth", 7), hypothesis("factor", 2), hypothesis("grid", 40),
                      hypothesis("A of the first", 71, true),
                      hypothesis("A of the second", 71, true)};
  table.depends = {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1}, {0, 1}, {0, 1, 2}, {0, 1, 2},
                   {2, 3},       {2, 4},       {},     {},     {2},       {2}};
  auto cache = std::make_shared<std::map<std::pair<int, int>, Peaks>>();
  const auto polynomial = [cache](std::size_t law, int grid, int rank) {
    Peaks& peaks = cache->try_emplace({static_cast<int>(law) * 100 + rank, grid}).first->second;
    if (peaks.velocity > 0.0) return peaks;
    const double a = rank - 1.0;
    const double alpha = law == 4 ? -3.0 : -5.0;
    const std::array<double, 3> coefficients =
        law < 2 ? std::array{0.0, a, 140.0 - 14.0 * a / 3.0}
                : std::array{6.0 + 0.6 * alpha, -3.0 * alpha, 0.0};
    return peaks = read_off(coefficients, grid == 0 ? 400 : 4 + grid);
  };
  const auto peaks = [polynomial](std::size_t law, std::span<const int> choice) -> Peaks {
    using std::numbers::pi;
    if (law == 2) return {pi / 2.0, pi * pi / 2.0};
    if (law == 3) return {1.5, 6.0};
    return polynomial(law, choice[kGridInput], law < 2 ? choice[kFirstA + law] : 0);
  };
  table.model = [peaks, calls](std::size_t row, std::span<const int> choice) {
    ++*calls;
    const Peaks law = peaks(row % 6, choice);
    if (row >= 6)
      return 40.0 * law.velocity / (std::numbers::pi * std::tan(std::numbers::pi / 6.0));
    constexpr std::array<double, 8> kDepth{0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.2};  // mm
    constexpr std::array<double, 3> kFactor{2.0, 4.0, 1.0};
    const double path = 1e-3 * std::numbers::pi * 2.0 * (kOuterRadius - kDepth[at(choice[0])]);
    return 2.4 * law.acceleration * kFactor[at(choice[1])] * 0.040 * 0.3 * 0.3 / (path * path);
  };
  return table;
}

TEST_CASE("the forces are explained by another depth, a 20-step grid and two open coefficients") {
  std::size_t calls = 0;
  const Reproduction found = reproduce(inertia_table(&calls));
  CHECK(found.departures == Assignment{6, 0, 16, 7, 49});  // h = 1.0, N = 20, A = 6 and 48
  CHECK(found.held == 11);
  CHECK(found.unexplained == 1);
  CHECK(found.rows[8].verdict ==
        Finding::Unexplained);  // the cosine's radius: 34.64, printed 34.55
  CHECK(found.rows[8].explained_value == Approx(34.6410).margin(1e-4));
  CHECK(found.rows[0].causes == Causes{{kDepthInput, 6}, {kGridInput, 16}, {kFirstA, 7}});
  CHECK(found.rows[1].causes == Causes{{kDepthInput, 6}, {kSecondA, 49}});
  CHECK(found.rows[2].causes == Causes{{kDepthInput, 6}});
  CHECK(found.rows[7].causes == Causes{{kSecondA, 49}});
  CHECK(std::isnan(found.rows[0].value));
  CHECK(found.evaluations == calls);
  // No grid but a misprint (5.39 printed as 5.34) is as small; fewer misprints win.
  CHECK(found.equals == std::vector<Assignment>{{6, 0, 0, 7, 49}});
}

// --- Rules, one by one
// -------------------------------------------------------------------------------

/// Each row's value by the choice of the only hypothesis that it depends on.
PrintedTable lookup_table(std::vector<PrintedNumber> printed,
                          std::vector<std::vector<double>> values, std::vector<std::size_t> depends,
                          std::size_t hypotheses) {
  PrintedTable table;
  table.name = "lookup";
  table.printed = std::move(printed);
  for (std::size_t h = 0; h < hypotheses; ++h) {
    std::size_t alternatives = 0;
    for (std::size_t row = 0; row < depends.size(); ++row)
      if (depends[row] == h) alternatives = values[row].size() - 1;
    table.hypotheses.push_back(hypothesis("h" + std::to_string(h), static_cast<int>(alternatives)));
  }
  for (const std::size_t h : depends) table.depends.push_back({h});
  table.model = [values, depends](std::size_t row, std::span<const int> choice) {
    return values[row][at(choice[depends[row]])];
  };
  return table;
}

TEST_CASE("a table that agrees as stated keeps every hypothesis as stated") {
  const Reproduction found =
      reproduce(lookup_table({{1.5, 1}, {2.5, 1}}, {{1.5, 1.5, 9.0}, {2.5, 2.5, 2.5}}, {0, 1}, 2));
  CHECK(found.departures == Assignment{0, 0});
  CHECK(found.equals.empty());
  CHECK(found.reproduced == 2);
  CHECK(found.departed == 0);
}

TEST_CASE("a hypothesis is preferred to a misprint of the same row") {
  const Reproduction found = reproduce(lookup_table({{58.97, 2}}, {{59.97, 58.97}}, {0}, 1));
  CHECK(found.departures == Assignment{1});
  CHECK(found.misprints == 0);
  CHECK(found.equals == std::vector<Assignment>{{0}});  // as few departures: the misprint
  CHECK_FALSE(found.rows[0].misprint);
}

TEST_CASE("one misprint is preferred to two hypotheses") {
  PrintedTable table = lookup_table({{58.97, 2}}, {{59.97, 1.0}}, {0}, 2);
  table.hypotheses[1] = hypothesis("h1", 1);
  table.depends = {{0, 1}};
  table.model = [](std::size_t, std::span<const int> c) {
    return c[0] + c[1] == 2 ? 58.97 : 59.97;
  };
  const Reproduction found = reproduce(table);
  CHECK(found.departures == Assignment{0, 0});
  CHECK(found.misprints == 1);
  CHECK(found.rows[0].verdict == Finding::Explained);
  CHECK(found.rows[0].misprint);
  CHECK(found.rows[0].causes.empty());

  table.allow_misprints = false;
  const Reproduction strict = reproduce(table);
  CHECK(strict.departures == Assignment{1, 1});
  CHECK(strict.rows[0].causes == Causes{{0, 1}, {1, 1}});
}

TEST_CASE("a misprint can rest on a departure") {
  const Reproduction found =
      reproduce(lookup_table({{30.0, 1}, {58.97, 2}}, {{15.0, 30.0}, {29.98, 59.97}}, {0, 0}, 1));
  CHECK(found.departures == Assignment{1});
  CHECK(found.rows[1].misprint);
  CHECK(found.rows[1].causes == Causes{{0, 1}});
  CHECK(found.departed + found.misprints == 2);
}

TEST_CASE(
    "an unstated input is settled only if that explains a row, and is never asked as stated") {
  PrintedTable table =
      lookup_table({{6.5, 1}, {7.5, 1}}, {{kNan, 6.1, 6.5}, {kNan, 1.0, 2.0}}, {0, 1}, 2);
  table.hypotheses[0].unstated = table.hypotheses[1].unstated = true;
  table.allow_misprints = false;
  const auto model = table.model;
  table.model = [model](std::size_t row, std::span<const int> choice) {
    if (choice[row] == 0) throw std::logic_error("asked for an input that is not stated");
    return model(row, choice);
  };
  const Reproduction found = reproduce(table);
  CHECK(found.departures == Assignment{2, 0});
  CHECK(found.departed == 1);
  CHECK(std::isnan(found.rows[0].value));
  CHECK(found.rows[0].verdict == Finding::Explained);
  CHECK(found.rows[1].verdict == Finding::Unexplained);
  CHECK(std::isnan(found.rows[1].explained_value));
}

TEST_CASE("ties are listed in order of plausibility") {
  const Reproduction found =
      reproduce(lookup_table({{14.0, 0}}, {{19.0, 12.0, 14.2, 13.9, 14.4}}, {0}, 1));
  CHECK(found.departures == Assignment{2});
  // Stated and first alternative are one-digit misprints: as few departures or one more.
  CHECK(found.equals == std::vector<Assignment>{{3}, {4}, {0}});
  CHECK_FALSE(found.more_equals);
}

TEST_CASE("no more ties are listed than announced") {
  std::vector<double> values(151, 14.0);
  values[0] = 1000.0;
  const Reproduction found = reproduce(lookup_table({{14.0, 0}}, {values}, {0}, 1));
  CHECK(found.departures == Assignment{1});
  CHECK(found.equals.size() == kMaxEquals);
  CHECK(found.equals.back() == Assignment{101});
  CHECK(found.more_equals);
}

TEST_CASE("of many ties the most plausible are listed, whatever the order of the search") {
  PrintedTable table;
  table.name = "ties";
  table.hypotheses = {hypothesis("a", 20, true), hypothesis("b", 20, true)};
  table.printed = {{14.0, 0}, {15.0, 0}};
  table.depends = {{0, 1}, {1}};  // so that b is searched before a
  table.model = [](std::size_t row, std::span<const int>) { return row == 0 ? 14.0 : 15.0; };
  check_against_full_product(table);
  CHECK(reproduce(table).more_equals);
}

TEST_CASE("where nothing explains anything all stays as stated") {
  const Reproduction found =
      reproduce(lookup_table({{1.11, 2}, {2.22, 2}}, {{5.0, 6.0, 7.0}, {kNan, kNan}}, {0, 1}, 2));
  CHECK(found.departures == Assignment{0, 0});
  CHECK(found.held == 0);
  CHECK(found.unexplained == 2);
  CHECK(found.equals.empty());
  CHECK(found.rows[0].explained_value == 5.0);
}

TEST_CASE("a row that agrees as stated and breaks under the winner is counted lost and marked") {
  const Reproduction found = reproduce(lookup_table(
      {{1.1, 1}, {2.2, 1}, {3.3, 1}}, {{1.1, 9.9}, {0.0, 2.2}, {0.0, 3.3}}, {0, 0, 0}, 1));
  CHECK(found.departures == Assignment{1});
  CHECK(found.held == 2);
  CHECK(found.rows[0].verdict == Finding::Reproduced);
  CHECK(found.rows[0].broken);
  CHECK(found.rows[0].explained_value == 9.9);
  CHECK(found.broken == 1);
  CHECK(found.reproduced == 1);
  CHECK(found.explained == 2);
}

TEST_CASE("a departure that breaks as many rows as it explains is not made") {
  const Reproduction found =
      reproduce(lookup_table({{1.1, 1}, {2.2, 1}}, {{1.1, 9.9}, {0.0, 2.2}}, {0, 0}, 1));
  CHECK(found.departures == Assignment{0});
  CHECK(found.rows[1].verdict == Finding::Unexplained);
}

TEST_CASE("the model is called once for each sub-choice, with the other entries at zero") {
  std::mt19937 random(5);
  for (int trial = 0; trial < 50; ++trial) {
    PrintedTable table = random_table(random, 3, 0.1);
    std::set<std::pair<std::size_t, Assignment>> seen;
    std::size_t calls = 0;
    const auto model = table.model;
    table.model = [&](std::size_t row, std::span<const int> choice) {
      const Assignment copy(choice.begin(), choice.end());
      REQUIRE(copy == only(table.depends[row], copy));
      seen.emplace(row, copy);
      ++calls;
      return model(row, choice);
    };
    CHECK(reproduce(table).evaluations == calls);
    CHECK(seen.size() == calls);
  }
}

TEST_CASE("a table without rows or hypotheses is reproduced trivially") {
  PrintedTable table;
  table.model = [](std::size_t, std::span<const int>) { return 1.0; };
  CHECK(reproduce(table).rows.empty());
  table.printed = {{1.0, 0}};
  table.depends = {{}};
  CHECK(reproduce(table).reproduced == 1);
}

TEST_CASE("bad tables are refused with the table's name and the fault") {
  const PrintedTable good = lookup_table({{1.5, 1}}, {{1.5, 2.0}}, {0}, 1);
  const auto complaint = [&](auto spoil) {
    PrintedTable table = good;
    spoil(table);
    try {
      reproduce(table);
    } catch (const std::invalid_argument& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  CHECK(complaint([](PrintedTable&) {}) == "accepted");
  CHECK(complaint([](PrintedTable& t) { t.model = nullptr; }) == "table 'lookup': no model");
  CHECK(complaint([](PrintedTable& t) { t.depends.emplace_back(); }) ==
        "table 'lookup': 1 printed values, but depends has 2 rows");
  CHECK(complaint([](PrintedTable& t) { t.depends[0] = {3}; }) ==
        "table 'lookup': row 0 depends on hypothesis 3; there are 1");
  CHECK(complaint([](PrintedTable& t) {
          t.depends[0] = {0, 0};
        }) == "table 'lookup': row 0 depends twice on 'h0'");
  CHECK(complaint([](PrintedTable& t) { t.printed[0].decimals = -1; }) ==
        "table 'lookup': row 0 has -1 decimals; use 0 to 15");
  CHECK(complaint([](PrintedTable& t) { t.printed[0].value = kNan; }) ==
        "table 'lookup': row 0 prints nan, which is not finite");
  CHECK(complaint([](PrintedTable& t) { t.hypotheses.resize(65); }) ==
        "table 'lookup': 65 hypotheses; at most 64");
  CHECK(complaint([](PrintedTable& t) {
          t.hypotheses.assign(4, hypothesis("wide", 99));
          t.depends[0] = {0, 1, 2, 3};
        }) == "table 'lookup': row 0 depends on more than 8388608 combinations");
}

}  // namespace
}  // namespace camlaw::optim::hypotheses_test

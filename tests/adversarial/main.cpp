// SPDX-License-Identifier: MIT
// camlaw_adversary: problems that were made to be hard, solved by the program and judged by code
// that shares nothing with it.
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

#include "tests/adversarial/rules.h"

namespace camlaw::adversary {
namespace {

struct Options {
  std::uint64_t seed = 1, from = 0, count = 100, every = 1, offset = 0;
  std::string kind, record;
  bool show = false, check = false, quiet = false;
};

/// One line of the record.
struct Line {
  std::uint64_t index = 0;
  std::string kind, said, wrong;  ///< each kind of wrong once, such as "ad"; "-" where none
  bool global = false, right = false, smooth = false, feasible = false, other_valley = false;
  double solve_s = 0, judge_s = 0;
};

std::string to_text(const Line& l) {
  return fmt::format("{} {} {} {} {}{}{}{}{} {:.4f} {:.4f}", l.index, l.kind, l.said, l.wrong,
                     l.global ? 1 : 0, l.right ? 1 : 0, l.smooth ? 1 : 0, l.feasible ? 1 : 0,
                     l.other_valley ? 1 : 0, l.solve_s, l.judge_s);
}

std::optional<Line> from_text(const std::string& text) {
  std::istringstream in(text);
  Line l;
  std::string flags;
  if (!(in >> l.index >> l.kind >> l.said >> l.wrong >> flags >> l.solve_s >> l.judge_s)) return {};
  if (flags.size() != 5) return {};
  l.global = flags[0] == '1', l.right = flags[1] == '1', l.smooth = flags[2] == '1';
  l.feasible = flags[3] == '1', l.other_valley = flags[4] == '1';
  return l;
}

Line line_of(std::uint64_t index, const Case& test, const Outcome& outcome) {
  Line l;
  l.index = index;
  l.kind = test.kind;
  l.said = outcome.crashed ? "crashed" : word(outcome.answer.said);
  for (const Wrong& wrong : outcome.wrong) {
    if (l.wrong.find(wrong.kind) == std::string::npos) l.wrong += wrong.kind;
  }
  if (l.wrong.empty()) l.wrong = "-";
  l.global = outcome.answer.global;
  l.right = outcome.right;
  l.smooth = test.smooth;
  l.feasible = outcome.truth.best.has_value();
  l.other_valley = outcome.other_valley;
  l.solve_s = outcome.solve_s;
  l.judge_s = outcome.judge_s;
  return l;
}

void print_table(const std::vector<Line>& lines) {
  std::map<std::string, std::map<std::string, double>> rows;
  const auto note = [&](const std::string& row, const Line& l) {
    auto& r = rows[row];
    ++r["cases"];
    ++r[l.said];
    r["global"] += l.global;
    r["right"] += l.right;
    r["valley"] += l.other_valley;
    r["open"] += l.feasible && l.said == "failed";
    if (l.feasible) ++r["possible"], r["possible certified"] += l.said == "certified";
    if (l.feasible && l.smooth) ++r["smooth"], r["smooth certified"] += l.said == "certified";
    for (const char c : l.wrong) r[std::string(1, c)] += 1;
    r["wrong"] += l.wrong != "-";
    r["solve"] += l.solve_s;
    r["judge"] += l.judge_s;
  };
  for (const Line& l : lines) note(l.kind, l), note("~ all", l);
  fmt::print(
      "{:<12}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7} "
      "|{:>6}{:>6}{:>6}{:>6}{:>6}{:>6}{:>6}{:>6} |{:>9}{:>9}\n",
      "class", "cases", "cert.", "global", "feas.", "infeas", "failed", "crash", "right?", "valley",
      "open", "a", "b", "c", "d", "e", "f", "g", "wrong", "solve/s", "judge/s");
  for (auto& [name, r] : rows) {
    fmt::print(
        "{:<12}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7} "
        "|{:>6}{:>6}{:>6}{:>6}{:>6}{:>6}{:>6}{:>6} |{:>9.1f}{:>9.1f}\n",
        name, r["cases"], r["certified"], r["global"], r["feasible"], r["infeasible"], r["failed"],
        r["crashed"], r["right"], r["valley"], r["open"], r["a"], r["b"], r["c"], r["d"], r["e"],
        r["f"], r["g"], r["wrong"], r["solve"], r["judge"]);
  }
  for (auto& [name, r] : rows) {
    const auto share = [&](const std::string& of, const char* words) {
      if (!(r[of] > 0)) return;
      fmt::print("{}: of {} {} {} certified, {:.1f} %\n", name, r[of], words, r[of + " certified"],
                 100 * r[of + " certified"] / r[of]);
    };
    share("possible", "with a design");
    share("smooth", "smooth ones with a design");
  }
}

void show(const Case& test, const Outcome& outcome) {
  fmt::print("{}\n", test.text.empty() ? "(stated through the C++ API)" : test.text);
  const Answer& a = outcome.answer;
  fmt::print("said: {}{}: {}\n  objective {:.12g}, tolerance {:.3g}, {} starts, {} evaluations\n",
             outcome.crashed ? "crashed" : word(a.said), a.global ? " (global)" : "", a.reason,
             a.objective, a.objective_tolerance, a.starts, a.evaluations);
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    fmt::print("  {} = {:.12g}\n", test.plain.variables[i].name, a.x[i]);
  }
  for (const SaidLimit& l : a.limits) {
    fmt::print("  {} {:.12g} {} {:.9g}, {}, tolerance {:.3g}, price {:.6g}\n", l.name, l.value,
               l.is_upper ? "<=" : ">=", l.bound, l.met ? "met" : "NOT met", l.tolerance, l.price);
  }
  const Truth& t = outcome.truth;
  if (t.best) {
    fmt::print("judge: {:.12g} at", t.value);
    for (const double x : *t.best) fmt::print(" {:.12g}", x);
    fmt::print("\n");
  } else {
    fmt::print("judge: no design found{}\n", t.infeasible ? "; infeasible" : "");
  }
  if (t.bound) fmt::print("judge: no design beyond {:.12g}\n", *t.bound);
  if (outcome.right) fmt::print("judge: not beaten, and not certified\n");
  if (outcome.other_valley) fmt::print("judge: another valley is better\n");
  for (const Wrong& w : outcome.wrong) fmt::print("WRONG ({}): {}\n", w.kind, w.what);
  fmt::print("{:.3f} s solving, {:.3f} s judging\n", outcome.solve_s, outcome.judge_s);
}

int run(const Options& options) {
  std::map<std::uint64_t, Line> done;
  std::ofstream record;
  if (!options.record.empty()) {
    std::ifstream old(options.record);
    for (std::string text; std::getline(old, text);) {
      if (const auto line = from_text(text)) done[line->index] = *line;
    }
    record.open(options.record, std::ios::app);
  }
  std::vector<Line> lines;
  double worst_difference = 0;
  for (std::uint64_t i = options.from; i < options.from + options.count; ++i) {
    if (i % options.every != options.offset) continue;
    if (const auto old = done.find(i); old != done.end() && !options.show) {
      lines.push_back(old->second);
      continue;
    }
    const Case test = make_case(options.seed, i, options.kind);
    if (options.check) {
      std::string where;
      const double off = difference(test, Random(options.seed + 1, i), where);
      if (off > 1e-9) fmt::print("{} {}: off by {:.2g}: {}\n", test.kind, i, off, where);
      worst_difference = std::max(worst_difference, off);
      continue;
    }
    const Outcome outcome = judged(test, Random(options.seed + 1, i));
    if (options.show) {
      show(test, outcome);
    } else {
      if (outcome.crashed) fmt::print("{} {}: crashed: {}\n", test.kind, i, outcome.answer.reason);
      for (const Wrong& w : outcome.wrong) {
        fmt::print("{} {}: ({}) {}{}: {}\n", test.kind, i, w.kind, word(outcome.answer.said),
                   outcome.answer.global ? ", global" : "", w.what);
      }
    }
    lines.push_back(line_of(i, test, outcome));
    if (record.is_open()) record << to_text(lines.back()) << '\n' << std::flush;
    std::fflush(stdout);
  }
  if (options.check) {
    fmt::print("largest difference {:.2g}\n", worst_difference);
    return worst_difference > 1e-6;
  }
  print_table(lines);
  std::size_t failed = 0;
  for (const Line& l : lines) failed += l.wrong != "-" || l.said == "crashed";
  fmt::print("{} passed, {} failed\n", lines.size() - failed, failed);
  return failed > 0;
}

}  // namespace
}  // namespace camlaw::adversary

int main(int count, char** arguments) {
  using namespace camlaw::adversary;
  Options options;
  try {
    for (int i = 1; i < count; ++i) {
      const std::string key = arguments[i];
      const auto next = [&]() -> std::string {
        if (i + 1 >= count) throw std::invalid_argument(key + " needs a value");
        return arguments[++i];
      };
      if (key == "--seed")
        options.seed = std::stoull(next());
      else if (key == "--from")
        options.from = std::stoull(next());
      else if (key == "--count")
        options.count = std::stoull(next());
      else if (key == "--every")
        options.every = std::stoull(next());
      else if (key == "--offset")
        options.offset = std::stoull(next());
      else if (key == "--class")
        options.kind = next();
      else if (key == "--record")
        options.record = next();
      else if (key == "--check")
        options.check = true;
      else if (key == "--show") {
        options.show = true;
        options.from = std::stoull(next());
        options.count = 1;
      } else {
        throw std::invalid_argument("unknown option " + key);
      }
    }
    return run(options);
  } catch (const std::exception& error) {
    std::cerr << "camlaw_adversary: " << error.what() << '\n';
    return 2;
  }
}

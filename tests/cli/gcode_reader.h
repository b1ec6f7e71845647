// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// A small controller for tests: it runs programs of straight and circular moves in one plane.
namespace camlaw::cli {

struct GcodeRun {
  /// Where the tool went at the feed, arcs in steps of 0.2 deg or less: none rises by more than
  /// 1e-5 mm above its chord.
  std::vector<Eigen::Vector2d> cut;
  double feed = 0, clearance = 0, cut_depth = 0;
  bool in_inches = false;
  std::vector<int> compensation = {};    ///< G41, G42, G40 in their order
  std::vector<std::size_t> passes = {};  ///< where in `cut` each way down begins
  double worst_radius_mismatch = 0;      ///< of an arc's end from the circle about its centre
};

namespace detail {

/// A line without comments, as words by their letters; G words apart.
struct Block {
  std::vector<int> g;
  std::map<char, double> words;
};

inline Block block_of(const std::string& line) {
  Block block;
  std::istringstream text(line.substr(0, line.find('(')));
  for (std::string word; text >> word;) {
    const double number = std::stod(word.substr(1));
    if (word[0] == 'G') {
      block.g.push_back(static_cast<int>(number));
    } else {
      block.words[word[0]] = number;
    }
  }
  return block;
}

}  // namespace detail

/// Throws where the program moves before units and plane are stated, at the feed without one, in
/// the plane below the clearance at rapid speed, or does not end.
inline GcodeRun run_gcode(const std::string& program) {
  GcodeRun run;
  Eigen::Vector2d at(0, 0);
  double z = 1e9;
  bool ready = false, ended = false;
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    if (line == "%" || line.starts_with("(")) continue;
    const auto block = detail::block_of(line);
    const auto word = [&](char letter, double standard) {
      const auto found = block.words.find(letter);
      return found == block.words.end() ? standard : found->second;
    };
    if (block.words.contains('M')) ended = word('M', 0) == 30;
    if (block.g.size() > 2) {
      ready =
          block.g == std::vector{21, 17, 90, 40, 94} || block.g == std::vector{20, 17, 90, 40, 94};
      run.in_inches = block.g.front() == 20;
      continue;
    }
    if (block.g.size() == 2) {
      // Compensation begins or ends on a straight move.
      if (block.g.front() != 1) throw std::runtime_error("compensation on no straight move");
      run.compensation.push_back(block.g.back());
    }
    if (block.g.empty()) continue;
    const int g = block.g.front();
    const Eigen::Vector2d to(word('X', at.x()), word('Y', at.y()));
    run.feed = word('F', run.feed);
    if (!ready) throw std::runtime_error("a move before G21 G17 G90 G40 G94: " + line);
    if (g == 0) {
      if (to != at && z < run.clearance) throw std::runtime_error("a rapid move in the cut");
      z = word('Z', z);
      if (to == at) run.clearance = z;
    } else if (!(run.feed > 0)) {
      throw std::runtime_error("a cut without feed");
    } else if (g == 1) {
      if (block.words.contains('Z')) {
        run.cut_depth = z = word('Z', z);
        run.passes.push_back(run.cut.size());
      }
      run.cut.push_back(to);
    } else if (g == 2 || g == 3) {
      const Eigen::Vector2d centre = at + Eigen::Vector2d(word('I', 0), word('J', 0));
      const Eigen::Vector2d a = at - centre, b = to - centre;
      run.worst_radius_mismatch =
          std::max(run.worst_radius_mismatch, std::abs(a.norm() - b.norm()));
      const double turn = 2 * std::numbers::pi, begin = std::atan2(a.y(), a.x());
      double sweep = std::atan2(b.y(), b.x()) - begin;
      if (g == 3 && sweep <= 0) sweep += turn;
      if (g == 2 && sweep >= 0) sweep -= turn;
      const double step = std::min(turn / 1800, std::sqrt(8e-5 / a.norm()));
      const int steps = static_cast<int>(std::abs(sweep) / step) + 1;
      for (int i = 1; i < steps; ++i) {
        const double share = static_cast<double>(i) / steps, angle = begin + share * sweep;
        const double radius = (1 - share) * a.norm() + share * b.norm();
        run.cut.push_back(centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
      }
      run.cut.push_back(to);
    } else {
      throw std::runtime_error("a code that nobody knows: " + line);
    }
    at = to;
  }
  if (!ended) throw std::runtime_error("the program does not end with M30");
  return run;
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#include "problems/published/cam_shape/reproduction.h"

#include "problems/published/cam_shape/solve.h"

namespace camlaw::problems {
namespace {

constexpr int kSuite = 1000;  // points of the value that is not from COPS

double valve_opening(int n, bool widened, const std::atomic<bool>* stop) {
  if (!widened) return solve_cam_shape(n, stop).objective;
  return cam_shape(n).objective().response.function().value(cam_shape_by_ipopt_defaults(n));
}

}  // namespace

SystemReproduction reproduce_cam_shape(const std::atomic<bool>* stop) {
  std::vector<PrintedValue> printed = printed_cam_shapes();
  optim::PrintedTable table;
  table.name = "cam-shape";
  table.hypotheses = {{"rows", "as published", {"each widened by 1e-8, Ipopt's default"}}};
  std::vector<int> points;
  for (const PrintedValue& row : printed) {
    points.push_back(points_of(row));
    table.printed.push_back(row.number);
    table.depends.emplace_back();
    if (points.back() == kSuite) table.depends.back().push_back(0);
  }
  table.model = [points, stop](std::size_t row, std::span<const int> choice) {
    return valve_opening(points[row], choice[0] != 0, stop);
  };
  return reproduce_system(
      "cam-shape", "COPS cam shape: valve opening of n radii",
      "E. D. Dolan, J. J. More, T. S. Munson, Benchmarking Optimization Software with COPS 3.0, "
      "ANL/MCS-TM-273, 2004; CUTEst, CAMSHAPE; n = 1000 from a public test suite",
      std::move(printed), table);
}

}  // namespace camlaw::problems

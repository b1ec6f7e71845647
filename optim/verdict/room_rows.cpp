// SPDX-License-Identifier: MIT
#include "optim/verdict/room_rows.h"

#include "optim/cycle/scales.h"
#include "optim/verdict/limits.h"

namespace camlaw::optim {
namespace {

class SearchedRooms final : public RoomRows {
 public:
  SearchedRooms(const Problem& problem, Design x) : problem_(problem) {
    problem_.objectives = {no_objective()};
    scales_ = scales(problem_, x);
  }

  std::size_t limits() const override { return problem_.constraints.size(); }
  std::vector<double> slack() const override { return std::vector<double>(limits(), 0.0); }
  void room(std::span<const double> designs, std::size_t count,
            std::span<double> room) const override {
    const std::size_t n = problem_.variables.size();
    for (std::size_t k = 0; k < count; ++k) {
      const auto reports = limit_reports(problem_, scales_, designs.subspan(k * n, n), false);
      for (std::size_t i = 0; i < reports.size(); ++i) {
        room[i * count + k] = reports[i].margin + reports[i].tolerance;
      }
    }
  }

 private:
  Problem problem_;
  Scales scales_;
};

}  // namespace

std::unique_ptr<RoomRows> searched_rooms(const Problem& problem, Design x) {
  return std::make_unique<SearchedRooms>(problem, x);
}

}  // namespace camlaw::optim

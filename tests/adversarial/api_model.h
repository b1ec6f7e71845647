// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "tests/adversarial/plain_problem.h"

/// Problems that are stated through the C++ API: formulas of the design, or of design and angle.
namespace camlaw::adversary {

struct ApiModel final : Model {
  struct Response {
    std::function<double(const Point& x, double angle)> value;
    bool curve = false;
    std::function<double(const Point& x)> magnitude = {};
  };
  std::vector<Response> responses;
  double from = 0, to = 1;  ///< angles of the curves
  bool is_affine = false;
  std::vector<Spot> besides;

  std::unique_ptr<Look> look(const Point& x) const override {
    return std::make_unique<ApiLook>(*this, x);
  }
  bool is_curve(int r) const override { return responses[static_cast<std::size_t>(r)].curve; }
  bool affine() const override { return is_affine; }
  std::vector<Spot> special() const override { return besides; }

 private:
  class ApiLook final : public Look {
   public:
    ApiLook(const ApiModel& model, Point x) : model_(model), x_(std::move(x)) {}
    double value(int r, const Spot& at) const override {
      return model_.responses[static_cast<std::size_t>(r)].value(x_, angle(at));
    }
    double magnitude(int r) const override {
      const auto& f = model_.responses[static_cast<std::size_t>(r)].magnitude;
      return f ? f(x_) : 0;
    }
    double angle(const Spot& at) const override {
      return model_.from + (model_.to - model_.from) * at.u;
    }

   private:
    const ApiModel& model_;
    Point x_;
  };
};

}  // namespace camlaw::adversary

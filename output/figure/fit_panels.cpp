// SPDX-License-Identifier: MIT
#include "output/figure/fit_panels.h"

#include "numerics/linear/statistics.h"

namespace camlaw::cli {

void draw(FitPicture picture, Figure& figure) {
  constexpr std::size_t kDots = 120, kResiduals = 2000;  // more would hide the curve, be a blot
  const std::vector<std::size_t> order = optim::order_of(picture.place);
  const std::size_t count = order.size();
  Panel data, left;
  data.title = picture.title;
  data.x = left.x = picture.x;
  left.y = {.label = picture.left, .unit = picture.y.unit};
  data.y = std::move(picture.y);
  Markers dots{.name = picture.dots, .colour = "#555555", .filled = false, .size = 2.5};
  Markers residuals{.name = "residuals", .colour = "#0072b2", .size = 1.5};
  for (std::size_t k = 0; k < count; k += count / kDots + 1) {
    dots.points.push_back({picture.place[order[k]], picture.value[order[k]]});
  }
  for (std::size_t k = 0; k < count; k += count / kResiduals + 1) {
    residuals.points.push_back({picture.place[order[k]], -picture.residual[order[k]]});
  }
  picture.model.colour = "#d55e00";
  data.lines.push_back(std::move(picture.model));
  data.markers.push_back(std::move(dots));
  left.markers.push_back(std::move(residuals));
  figure.panels.push_back(std::move(data));
  figure.panels.push_back(std::move(left));
}

}  // namespace camlaw::cli

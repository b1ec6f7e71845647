// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "output/figure/chart.h"
#include "problems/published/sheet_delivery/trade_off.h"

/// The sheet delivery's trade-off in print.
namespace camlaw::cli {

std::string delivery_text(std::span<const problems::DeliveryChoice> choices);
std::string delivery_csv(std::span<const problems::DeliveryChoice> choices);
std::string delivery_json(std::span<const problems::DeliveryChoice> choices);
Figure delivery_figure(std::span<const problems::DeliveryChoice> choices);

}  // namespace camlaw::cli

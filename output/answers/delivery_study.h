// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "output/document/document.h"
#include "output/figure/chart.h"
#include "problems/published/sheet_delivery/trade_off.h"

/// The sheet delivery's trade-off in print.
namespace camlaw::cli {

Document delivery_document(std::span<const problems::DeliveryChoice> choices);
/// Its choices, one row each.
Table delivery_table(std::span<const problems::DeliveryChoice> choices);
Figure delivery_figure(std::span<const problems::DeliveryChoice> choices);

}  // namespace camlaw::cli

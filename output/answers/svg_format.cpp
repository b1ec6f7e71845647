// SPDX-License-Identifier: MIT
#include "output/answers/export_formats.h"
#include "output/answers/export_output.h"
#include "output/export/curve_svg.h"

namespace camlaw::cli {
namespace {

std::string drawing(const Exported& e) {
  return problems::svg_text(e.curves, e.accuracy.unit, e.design.statement.title, comments_of(e));
}

}  // namespace

FormatRow svg_format() {
  using F = problems::CurveForm;
  return {.name = "svg",
          .endings = {".svg"},
          .forms = {F::Lines, F::Arcs, F::Spline},
          .text = drawing,
          .rounding = 2e-6};
}

}  // namespace camlaw::cli

// SPDX-License-Identifier: MIT
#pragma once

#include "output/answers/front_answer.h"
#include "output/document/json.h"
#include "output/report/design_figure.h"
#include "problems/law_files/json_text.h"

/// A front as data for the scripts of a report.
namespace camlaw::cli {

/// The points that are shown: all, or of very many some that lie evenly, the knee among them.
std::vector<std::size_t> shown_points(const FrontAnswer& answer);

/// A point of the front as a design of its own.
problems::ProblemStatement design_of(const FrontAnswer& answer, const optim::FrontPoint& point);

/// "peak drive torque, N m".
std::string named_with_unit(const std::string& name, const std::string& unit);

/// The panels that every design is drawn in, with their words. Where designs and curves are very
/// many only those stay that a front is read with (motions, loads, what is sought or limited, what
/// the picture follows), and as many others as there is room for.
struct FrontPanels {
  Figure figure;
  std::vector<PanelWords> words;
};
FrontPanels front_panels(const FrontAnswer& answer, const std::vector<std::size_t>& shown);

/// Objectives, the pairs of them that are drawn, and the knee. `still` is front_figure().
Json objectives_json(const FrontAnswer& answer, const std::vector<std::size_t>& shown,
                     const Figure& still);

/// Samples of each curve and of each picture: as many as leave all designs within `bytes`, where
/// one of them takes `few_bytes` with the fewest samples and `many_bytes` with the most.
struct SampleRange {
  int few = 12, many = 240;
};
int samples_within(double bytes, std::size_t designs, double few_bytes, double many_bytes,
                   const SampleRange& range = {});

/// Each shown design: its curves, what is said of it, its mechanism as SVG.
Json designs_json(const FrontAnswer& answer, const std::vector<std::size_t>& shown,
                  const Figure& panels);

}  // namespace camlaw::cli

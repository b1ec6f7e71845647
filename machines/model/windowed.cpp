// SPDX-License-Identifier: MIT
#include "machines/model/windowed.h"

#include <algorithm>
#include <stdexcept>

#include "machines/model/cycle.h"
#include "machines/model/law_binding.h"
#include "numerics/text/names.h"
#include "optim/cycle/window_curve.h"

namespace camlaw::problems {

std::pair<double, double> window_at(const CycleWindow& window, const Cycle& cycle,
                                    const Member& law) {
  if (window.segment.empty()) return {window.from, window.to};
  std::vector<NamedSpan> spans;
  if (law.family->spans) spans = law.family->spans(law.arguments);
  const auto span = std::find_if(spans.begin(), spans.end(),
                                 [&](const NamedSpan& s) { return s.name == window.segment; });
  if (span == spans.end()) {
    std::vector<std::string> names;
    for (const NamedSpan& s : spans) names.push_back(s.name);
    refuse_name("no segment is called", window.segment, names);
  }
  const double begin = cycle.stretches.front().begin, end = cycle.stretches.back().end;
  return {begin + (end - begin) * span->begin, begin + (end - begin) * span->end};
}

std::shared_ptr<const optim::Curve> windowed(std::shared_ptr<const optim::Curve> curve,
                                             const CycleWindow& window,
                                             const MechanismResponse& response,
                                             const Binding& binding) {
  if (window.segment.empty()) {
    return std::make_shared<optim::WindowCurve>(std::move(curve),
                                                optim::Window{window.from, window.to});
  }
  return std::make_shared<optim::WindowCurve>(
      std::move(curve), [window, cycle = response.cycle, law = binding.law](optim::Design x) {
        return window_at(window, *cycle, law->member_at(x));
      });
}

}  // namespace camlaw::problems

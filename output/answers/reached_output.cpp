// SPDX-License-Identifier: MIT
#include "output/answers/reached_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numerics/text/units.h"
#include "output/document/formatting.h"
#include "problems/law_files/json_text.h"

namespace camlaw::cli {

std::string share_text(double share) {
  const double left = 1 - share;
  const int decimals = left > 0 && left < 0.01
                           ? std::min(12, 1 - static_cast<int>(std::floor(std::log10(left))))
                           : 2;
  return fmt::format("{:.{}f} %", 100 * share, decimals);
}

namespace {

Table reliability_table(const problems::ReachedReliability& reached) {
  Table table{.key = "reliability",
              .columns = {names("reliability of", "name"), numbers("asked for", "wanted"),
                          numbers("of all parts", "share"), numbers("at least", "lower"),
                          numbers("at most", "upper"), words("it is", "reach")}};
  for (const problems::ReachedShare& limit : reached.limits) {
    table.add({limit.name,
               {share_text(limit.wanted), limit.wanted},
               {std::isnan(limit.share) ? "not calculated" : share_text(limit.share),
                to_json(limit.share)},
               {share_text(limit.between.lower), limit.between.lower},
               {share_text(limit.between.upper), limit.between.upper},
               std::string(to_string(limit.reach))});
  }
  return table;
}

}  // namespace

Document reached_document(const problems::ReachedReliability& reached) {
  Document document;
  if (!reached.limits.empty()) {
    document.say("\n");
    document.add(reliability_table(reached));
    if (reached.samples > 0)
      document.say(
          fmt::format("(from {} parts that the search did not have, at a confidence of 95 %)\n",
                      reached.samples));
    document.fact("reliability_samples", reached.samples);
  }
  if (reached.objective) {
    const problems::ReachedObjective& o = *reached.objective;
    if (!o.cut_short.empty()) {
      document.say(
          fmt::format("\n{} over parts that the search did not have was not worked out: {}\n",
                      o.name, o.cut_short));
      return document;
    }
    document.say(fmt::format(
        "\n{}: {} over {} parts that the search did not have, between {} and {} at a "
        "confidence of 95 %\n",
        o.name, with_unit(in_digits(o.value, 6), o.unit), o.samples, in_digits(o.between.lower, 6),
        with_unit(in_digits(o.between.upper, 6), o.unit)));
    document.fact("robust_objective", Json{{"name", o.name},
                                           {"value", to_json(o.value)},
                                           {"lower", to_json(o.between.lower)},
                                           {"upper", to_json(o.between.upper)},
                                           {"samples", o.samples},
                                           {"unit", o.unit}});
  }
  return document;
}

}  // namespace camlaw::cli

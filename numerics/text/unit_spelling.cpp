// SPDX-License-Identifier: MIT
#include "numerics/text/unit_spelling.h"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>

namespace camlaw {
namespace {

struct Spelling {
  std::string_view written, meant;
};

/// Signs that stand for others, wherever they are. The degree sign is a name.
constexpr std::array kSigns{Spelling{"²", "2"}, Spelling{"³", "3"}, Spelling{"·", " "},
                            Spelling{"⋅", " "}, Spelling{"⁻¹", "-1"}};

constexpr std::array kNames{
    Spelling{"°", "deg"},      Spelling{"º", "deg"},      Spelling{"Grad", "deg"},
    Spelling{"U", "rev"},      Spelling{"Umdr", "rev"},   Spelling{"RPM", "rpm"},
    Spelling{"Nm", "N m"},     Spelling{"Nmm", "N mm"},   Spelling{"Ncm", "N cm"},
    Spelling{"kNm", "kN m"},   Spelling{"mNm", "mN m"},   Spelling{"kgm", "kg m"},
    Spelling{"kgmm", "kg mm"}, Spelling{"kgcm", "kg cm"}, Spelling{"gmm", "g mm"},
    Spelling{"gcm", "g cm"},   Spelling{"Zoll", "inch"},  Spelling{"sec", "s"},
    Spelling{"msec", "ms"}};

constexpr std::array<std::string_view, 22> kAngles{
    "rad",        "mrad",   "urad",       "µrad",        "μrad",   "radian", "radians", "deg",
    "gon",        "rev",    "revolution", "revolutions", "turn",   "turns",  "degree",  "degrees",
    "arc_degree", "arcdeg", "arc_minute", "arc_second",  "arcmin", "arcsec"};

}  // namespace

std::string spelled_out(std::string_view written) {
  std::string text(written);
  if (text == "\"" || text == "''") return "inch";
  for (const Spelling& sign : kSigns) {
    boost::replace_all(text, std::string(sign.written), std::string(sign.meant));
  }
  std::string result;
  std::size_t done = 0;
  for_each_name(text, [&](std::string_view name) {
    const auto at = static_cast<std::size_t>(name.data() - text.data());
    result.append(text, done, at - done);
    done = at + name.size();
    const auto* known = std::find_if(kNames.begin(), kNames.end(),
                                     [&](const Spelling& s) { return s.written == name; });
    result += known == kNames.end() ? name : known->meant;
  });
  return result.append(text, done);
}

std::optional<std::string> ambiguous(std::string_view written) {
  // Names that the database of units reads in a sense that no engineer means.
  constexpr std::array kDoubtful{
      Spelling{"grad",
               "'grad' may mean degrees or hundredths of a right angle; write deg (or Grad) for "
               "the first, gon for the second"},
      Spelling{"e",
               "'e' would be the elementary charge; a power of ten needs its exponent, as in 1e3"},
      Spelling{"PS",
               "'PS' would be petasiemens; write the metric horsepower as 735.49875 W, or give "
               "kW"}};
  std::optional<std::string> why;
  for_each_name(written, [&](std::string_view name) {
    const auto* doubt = std::find_if(kDoubtful.begin(), kDoubtful.end(),
                                     [&](const Spelling& s) { return s.written == name; });
    if (!why && doubt != kDoubtful.end()) why = doubt->meant;
  });
  return why;
}

bool counts_turns(std::string_view unit) {
  constexpr std::array<std::string_view, 7> kRates{"1/min",    "min-1", "min^-1", "1/minute",
                                                   "minute-1", "Hz",    "kHz"};
  return std::find(kRates.begin(), kRates.end(), unit) != kRates.end();
}

bool is_angle_name(std::string_view name) {
  return std::find(kAngles.begin(), kAngles.end(), name) != kAngles.end();
}

}  // namespace camlaw

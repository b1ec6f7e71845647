// SPDX-License-Identifier: MIT
#include "output/answers/profile_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "output/document/formatting.h"
#include "problems/law_files/json_text.h"

namespace camlaw::cli {
namespace {

using problems::ProfileAnswer, problems::ProfileEffect, problems::WaveEffects;

std::string short_digits(double value) { return in_digits(value, 4); }

Table effects_table(const std::string& key, const std::vector<ProfileEffect>& effects) {
  Table table{.key = key,
              .columns = {words("", "name"), numbers("as drawn", "as_drawn"),
                          numbers("at worst", "worst"), numbers("change", "change"),
                          words("unit", "unit"), numbers("at", "at"), words("proved", "proved")}};
  for (const ProfileEffect& effect : effects) {
    const double change = effect.worst - effect.as_drawn;
    const bool has_share = effect.as_drawn != 0;
    const double share = change / std::abs(effect.as_drawn);
    table.add({effect.name,
               {short_digits(effect.as_drawn), effect.as_drawn},
               {short_digits(effect.worst), effect.worst},
               {has_share ? fmt::format("{:+.2f} %", 100 * share) : "", change},
               effect.unit,
               {effect.at ? fmt::format("{:.1f} deg", *effect.at) : "",
                effect.at ? Json(*effect.at) : Json(nullptr)},
               yes_or_no(effect.proved)});
  }
  return table;
}

std::string length_of(const problems::ProfileErrors& errors) {
  if (errors.waves) return fmt::format("{:.10g} waves a turn, even in cam angle", *errors.waves);
  return fmt::format("waves of {:.6g} mm along the profile", *errors.wavelength);
}

void say_lost(const std::vector<ProfileEffect>& effects, Document& document) {
  for (const ProfileEffect& effect : effects) {
    if (!effect.name.starts_with("least ") || effect.worst >= 0 || effect.as_drawn < 0) continue;
    document.say("  below 0 a follower that is not held by a groove leaves the cam\n");
  }
}

void say_bridging(const WaveEffects& waves, Document& document) {
  if (!waves.bridged_from) return;
  if (waves.valley_share >= 1) {
    document.say(fmt::format(
        "  such waves are too steep: at amplitudes of {} um and more the follower no longer "
        "reaches "
        "into their valleys, strikes from crest to crest, and its acceleration has no bound\n",
        short_digits(*waves.bridged_from)));
    return;
  }
  document.say(fmt::format(
      "  the follower reaches into every valley; at amplitudes of {} um and more it would not\n",
      short_digits(*waves.bridged_from)));
}

void say_left_out(const WaveEffects& waves, Document& document) {
  constexpr double kWorthSaying = 1e-3;  // of the changes, of which three digits are shown
  if (!waves.left_out || *waves.left_out < kWorthSaying) return;
  document.say(
      fmt::format("  waves of this height are not small compared with the cam: the changes may be "
                  "off by about {:.2g} "
                  "%{}\n",
                  100 * *waves.left_out,
                  *waves.left_out > problems::kMostLeftOut ? ", so that nothing is proved" : ""));
}

void add_waviness(const ProfileAnswer& answer, Document& document) {
  const WaveEffects& waves = *answer.waviness;
  document.say(fmt::format(
      "\nwaviness: an amplitude of {} um, {}, at the phase that is worst at each angle\n",
      short_digits(waves.amplitude), length_of(answer.errors)));
  if (!waves.effects.empty()) document.add(effects_table("waviness", waves.effects));
  document.say(fmt::format("  the follower deviates by {} {} at most\n",
                           short_digits(waves.displacement), answer.displacement_unit));
  say_lost(waves.effects, document);
  say_bridging(waves, document);
  say_left_out(waves, document);
  document.fact("waviness_left_out", waves.left_out);
  document.fact("waviness_displacement", waves.displacement);
  document.fact("waviness_valley_share", waves.valley_share);
  document.fact("waviness_bridged_from", waves.bridged_from);
}

void add_form(const ProfileAnswer& answer, Document& document) {
  const WaveEffects& form = *answer.form;
  document.say(fmt::format(
      "\nprofile tolerance: a zone {} mm wide; the follower deviates by {} {} at most\n",
      short_digits(*answer.errors.form), short_digits(form.displacement),
      answer.displacement_unit));
  document.fact("form_displacement", form.displacement);
  document.fact("form_bounds_acceleration", !form.effects.empty());
  if (!answer.errors.has_length()) {
    document.say(
        "  it does not bound the acceleration: within the zone short waves may make it as large as "
        "you like.\n  State waves (or wavelength): the shortest that are left, by the filter of "
        "the "
        "measurement or by the tool\n");
    return;
  }
  if (!form.effects.empty()) {
    document.say(fmt::format("  any error in the zone without waves shorter than {}:\n",
                             length_of(answer.errors)));
    document.add(effects_table("form", form.effects));
  }
  say_lost(form.effects, document);
  say_bridging(form, document);
  say_left_out(form, document);
  document.fact("form_left_out", form.left_out);
}

void add_chords(const ProfileAnswer& answer, Document& document) {
  problems::ProfileErrors chords;
  chords.chord = answer.errors.chord;
  chords.chord_step = answer.errors.chord_step;
  document.say(fmt::format("\n{}: what their corners do\n", problems::words_of(chords)));
  document.add(effects_table("chords", answer.chords));
  say_lost(answer.chords, document);
  document.say(
      answer.chords.size() > 2
          ? "  on convex stretches the roller rounds the corners: finer chords make the ripple of "
            "the velocity smaller,\n  and the accelerations shorter but not smaller\n"
          : "  a jump of the velocity is an impact: its acceleration has no bound, however fine "
            "the chords\n");
}

void add_shop(const ProfileAnswer& answer, Document& document) {
  document.say(fmt::format(
      "\nthe tolerance the shop must hold so that no peak grows by more than {:.4g} % (the "
      "acceleration is {} {} as drawn)\n",
      100 * *answer.errors.loss, short_digits(answer.acceleration), answer.acceleration_unit));
  const bool by_length = answer.errors.wavelength.has_value();
  Table table{
      .key = "shop",
      .columns = {by_length ? numbers("waves, mm", "wavelength") : numbers("waves a turn", "waves"),
                  words("for the", "of"), numbers("amplitude, um", "amplitude"),
                  numbers("profile tolerance, um", "form"), words("proved", "proved"),
                  words("", "by_theory")}};
  for (const problems::ShopLimit& limit : answer.shop) {
    const double length = by_length ? *limit.wavelength : *limit.waves;
    table.add({{in_digits(length, 6), length},
               limit.of,
               {short_digits(limit.amplitude), limit.amplitude},
               {limit.form ? short_digits(*limit.form) : "",
                limit.form ? Json(*limit.form) : Json(nullptr)},
               yes_or_no(limit.proved),
               {limit.by_theory ? "or more" : "", limit.by_theory}});
  }
  document.add(std::move(table));
  const bool any_more = std::any_of(answer.shop.begin(), answer.shop.end(),
                                    [](const auto& limit) { return limit.by_theory; });
  if (any_more) {
    document.say(
        "  or more: up to this amplitude the theory of small waves holds, and the peak allows "
        "more\n");
  }
  document.say(
      "  amplitude: of such waves; profile tolerance: width of the zone for any error without "
      "shorter ones\n");
}

}  // namespace

Document profile_document(const ProfileAnswer& answer) {
  Document document;
  document.say("errors of the profile: " + problems::words_of(answer.errors) + "\n");
  document.fact("peak_acceleration", answer.acceleration);
  document.fact("acceleration_unit", answer.acceleration_unit);
  document.fact("displacement_unit", answer.displacement_unit);
  if (answer.waviness) add_waviness(answer, document);
  if (answer.form) add_form(answer, document);
  if (!answer.chords.empty()) add_chords(answer, document);
  if (!answer.shop.empty()) add_shop(answer, document);
  return document;
}

Document with_profile(const problems::ProblemStatement& design, const ProfileAnswer& answer,
                      std::optional<Document> variation) {
  Document document = variation ? std::move(*variation) : Document();
  if (!variation && !design.title.empty()) document.say(design.title + "\n");
  if (!variation) document.fact("title", design.title);
  document.say("\n");
  document.add("profile", profile_document(answer));
  return document;
}

}  // namespace camlaw::cli

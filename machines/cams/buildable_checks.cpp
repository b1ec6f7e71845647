// SPDX-License-Identifier: MIT
#include "machines/cams/buildable_checks.h"

#include <algorithm>
#include <string_view>

#include "machines/cams/elastic_contact.h"

namespace camlaw::problems {
namespace {

/// Every input that a check of a cam has.
const std::vector<BuildableInput>& known_inputs() {
  static const std::vector<BuildableInput> all{
      {"wheel_radius", "mm", "radius of the grinding wheel", 50},
      {"wall", "mm", "required wall between profile and bore; by default a quarter of bore_radius",
       5},
      {"keyway_depth", "mm",
       "how far the corner of the hub's keyway lies beyond bore_radius; the wall begins there",
       3.3},
      {"arm_width", "mm", "width of the arm, and of its eye around the pivot", 16},
      {"free_length", "mm", "free length of the spring", 100},
      {"solid_length", "mm", "solid length of the spring, with all its coils closed", 30},
      {"solid_angle", "deg", "deflection at which the spring of the arm is solid", 60},
      {"allowable_pressure", "MPa", "permissible Hertz pressure of the material", 1200}};
  return all;
}

/// Just below 1, where a cusp begins or a follower jams, so that these fail beyond every tolerance.
double below_one(const StatedNumber&) { return 1 - 1e-5; }
/// Just above a cusp, in mm.
double above_cusp(const StatedNumber&) { return 1e-3; }
double nothing(const StatedNumber&) { return 0; }
double whole(const StatedNumber&) { return 1; }
double round_the_wheel(const StatedNumber& stated) { return -1 / *stated("wheel_radius"); }
double wall(const StatedNumber& stated) {
  const auto own = stated("wall");
  return stated("keyway_depth").value_or(0) + (own ? *own : *stated("bore_radius") / 4);
}
double half_the_arm(const StatedNumber& stated) { return stated("arm_width").value_or(0) / 2; }
double until_solid(const StatedNumber& stated) {
  return *stated("free_length") - *stated("solid_length");
}
double solid_angle(const StatedNumber& stated) { return *stated("solid_angle"); }
double allowable_pressure(const StatedNumber& stated) { return *stated("allowable_pressure"); }

BuildableCheck undercut(const std::string& of, Closure closure = Closure::Any) {
  return {.name = of + "undercut",
          .fault = "the profile is undercut",
          .response = of + "undercut",
          .is_upper = true,
          .bound = below_one,
          .closure = closure};
}

/// Hollows of a profile; where it is undercut, what a tool would do there says nothing.
Checks hollows(const std::string& of, const std::vector<std::string>& after,
               Closure closure = Closure::Any) {
  return {{.name = of + "hollow",
           .fault = "the tool does not fit into a hollow of the profile",
           .response = of + "tool_fit",
           .is_upper = true,
           .bound = whole,
           .needs = {"cutter_radius"},
           .closure = closure,
           .after = after},
          {.name = of + "hollow_of_the_wheel",
           .fault = "the grinding wheel does not fit into a hollow of the profile",
           .response = of + "profile_curvature",
           .is_upper = false,
           .bound = round_the_wheel,
           .needs = {"wheel_radius"},
           .closure = closure,
           .after = after}};
}

BuildableCheck wall_of(const std::string& of) {
  return {.name = of + "wall",
          .fault = "the wall around the bore is too thin",
          .response = of + "wall",
          .is_upper = false,
          .bound = wall,
          .needs = {"bore_radius"},
          .input = "wall",
          .standard = "a quarter of bore_radius"};
}

/// What must be stated of loads: a default is nobody's statement.
std::vector<std::string> loads(Closure closure) {
  std::vector<std::string> needs{"speed"};
  if (closure != Closure::Form) needs.insert(needs.end(), {"spring_rate", "spring_preload"});
  return needs;
}
/// One of these is what moves with the follower.
std::vector<std::string> masses() { return {"mass", "inertia"}; }

BuildableCheck stress(const char* name, const char* response, const char* after, Closure closure) {
  BuildableCheck check{.name = name,
                       .fault = "the contact pressure exceeds what the material can carry",
                       .response = response,
                       .is_upper = true,
                       .bound = allowable_pressure,
                       .needs = loads(closure),
                       .one_of = masses(),
                       .closure = closure,
                       .after = {after}};
  check.needs.insert(check.needs.begin(), {"allowable_pressure", "face_width"});
  return check;
}

/// Has the checks of what is pressed together wait for contact, where a mechanism can lose it.
void await_contact(Checks& checks) {
  const std::string contact = "contact";
  const bool has_it = std::any_of(checks.begin(), checks.end(),
                                  [&](const auto& check) { return check.name == contact; });
  for (BuildableCheck& check : checks) {
    const auto& needs = check.needs;
    const bool is_pressed =
        std::find(needs.begin(), needs.end(), "allowable_pressure") != needs.end();
    if (has_it && is_pressed && check.closure != Closure::Form) check.after.push_back(contact);
  }
}

/// Drops names that are neither a parameter of the mechanism nor an input.
void keep_known(std::vector<std::string>& names, const Mechanism& mechanism) {
  std::erase_if(names, [&](const std::string& name) {
    const auto is_it = [&](const auto& known) { return known.name == name; };
    const std::vector<MechanismParameter>& parameters = mechanism.parameters;
    const std::vector<BuildableInput>& inputs = known_inputs();
    return std::none_of(parameters.begin(), parameters.end(), is_it) &&
           std::none_of(inputs.begin(), inputs.end(), is_it);
  });
}

void add(Checks& all, const Checks& more) { all.insert(all.end(), more.begin(), more.end()); }

/// Whether a check has an input, needed or in place of a standard.
bool has_input(const BuildableCheck& check, const std::string& name) {
  const bool has_bore =
      std::find(check.needs.begin(), check.needs.end(), "bore_radius") != check.needs.end();
  if (name == "keyway_depth") return has_bore;
  return check.input == name ||
         std::find(check.needs.begin(), check.needs.end(), name) != check.needs.end();
}

}  // namespace

Checks undercut_checks() { return {undercut("")}; }

Checks hollow_checks() { return hollows("", {}); }

Checks roller_checks() {
  // A groove is cut by a tool that goes inside it: hollows of one flank say nothing of that.
  Checks all{undercut(""),
             undercut("outer_", Closure::Form),
             {.name = "groove_tool",
              .fault = "the tool does not fit into the groove",
              .response = "groove_fit",
              .is_upper = true,
              .bound = whole,
              .needs = {"cutter_radius", "roller_radius"},
              .closure = Closure::Form}};
  add(all, hollows("", {"undercut"}, Closure::Force));
  return all;
}

Checks face_checks() {
  return {{.name = "undercut",
           .fault = "the profile is undercut",
           .response = "profile_radius",
           .is_upper = false,
           .bound = above_cusp}};
}

Checks conjugate_checks() {
  Checks all;
  for (const char* const which : {"", "second_"}) {
    const std::string of = which;
    all.push_back(undercut(of));
    add(all, hollows(of, {of + "undercut"}));
    all.push_back(wall_of(of));
  }
  add(all, stress_checks());
  return all;
}

Checks force_closure_checks(const FollowerWords& words) {
  const bool slides = std::string_view(words.stroke) == kSliding.stroke;
  BuildableCheck spring{.name = "spring",
                        .fault = "the spring is solid",
                        .response = "spring_deflection",
                        .is_upper = true,
                        .bound = slides ? until_solid : solid_angle};
  spring.needs = {"spring_rate", "spring_preload"};
  if (slides) {
    spring.needs.insert(spring.needs.end(), {"free_length", "solid_length"});
  } else {
    spring.needs.push_back("solid_angle");
  }
  return {{.name = "contact",
           .fault = "the follower leaves the cam",
           .response = words.force_name,
           .is_upper = false,
           .bound = nothing,
           .needs = loads(Closure::Force),
           .one_of = masses(),
           .closure = Closure::Force},
          spring};
}

Checks wall_checks() { return {wall_of("")}; }

Checks pivot_checks() {
  return {{.name = "pivot",
           .fault = "the cam collides with the pivot of its arm",
           .response = "pivot_clearance",
           .is_upper = false,
           .bound = half_the_arm,
           .input = "arm_width",
           .standard = "an arm without width",
           .closure = Closure::Force}};
}

Checks shaft_checks() {
  const auto shaft = [](const std::string& of) {
    return BuildableCheck{.name = of + "shaft",
                          .fault = "the cam collides with the turret's shaft",
                          .response = of + "shaft_clearance",
                          .is_upper = false,
                          .bound = nothing,
                          .needs = {"shaft_radius"}};
  };
  return {shaft(""), shaft("second_")};
}

Checks rib_checks() {
  Checks all;
  for (const char* const end : {"root_", "tip_"}) {
    for (const char* const flank : {"", "second_"})
      all.push_back(undercut(std::string(flank) + end));
  }
  all.push_back(wall_of(""));
  all.push_back(stress("stress", "tip_contact_stress", "tip_undercut", Closure::Any));
  return all;
}

Checks ring_checks() {
  return {{.name = "rollers",
           .fault = "neighbouring rollers of the turret overlap",
           .response = "roller_gap",
           .is_upper = false,
           .bound = nothing}};
}

Checks roller_stress_checks() {
  return {stress("stress", "contact_stress", "undercut", Closure::Force),
          stress("groove_stress", "groove_stress", "undercut", Closure::Form)};
}

Checks arm_checks() {
  return {{.name = "arm",
           .fault = "the arm collides with the cam",
           .response = "arm_clearance",
           .is_upper = false,
           .bound = half_the_arm,
           .needs = {"arm_width"},
           .closure = Closure::Force}};
}

Checks guide_checks() {
  return {{.name = "guide",
           .fault = "friction in the guide jams the follower",
           .response = "guide_fraction",
           .is_upper = true,
           .bound = below_one,
           .needs = {"guide_friction"}}};
}

Checks stress_checks() { return {stress("stress", "contact_stress", "undercut", Closure::Any)}; }

Mechanism checked(Mechanism mechanism, const std::vector<Checks>& checks) {
  for (const Checks& some : checks) add(mechanism.checks, some);
  await_contact(mechanism.checks);
  add_elastic_checks(mechanism);
  for (BuildableCheck& check : mechanism.checks) {
    keep_known(check.needs, mechanism);
    keep_known(check.one_of, mechanism);
    if (check.one_of.size() == 1) {  // no choice
      check.needs.push_back(check.one_of.front());
      check.one_of.clear();
    }
  }
  for (const BuildableInput& input : known_inputs()) {
    const bool asked = std::any_of(mechanism.checks.begin(), mechanism.checks.end(),
                                   [&](const auto& check) { return has_input(check, input.name); });
    if (asked) mechanism.inputs.push_back(input);
  }
  return mechanism;
}

}  // namespace camlaw::problems

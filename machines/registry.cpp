// SPDX-License-Identifier: MIT
#include "machines/registry.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <mutex>

#include "numerics/text/names.h"

namespace camlaw::problems {
namespace {

/// Mechanisms in the order of their listing, a line for each: the name, the function that makes it,
/// which the machine's file defines, and its name in earlier programs, which files may have.
#define CAMLAW_MACHINES(MACHINE)                                                             \
  MACHINE("disc-cam-roller", roller_cam, "")                                                 \
  MACHINE("disc-cam-flat", flat_cam, "")                                                     \
  MACHINE("disc-cam-knife-edge", knife_edge_cam, "disc-cam-knife")                           \
  MACHINE("disc-cam-conjugate", conjugate_cam, "")                                           \
  MACHINE("disc-cam-oscillating-roller", oscillating_roller_cam, "disc-cam-swinging-roller") \
  MACHINE("disc-cam-leading-roller", leading_roller_cam, "")                                 \
  MACHINE("disc-cam-oscillating-flat", oscillating_flat_cam, "disc-cam-swinging-flat")       \
  MACHINE("end-cam", end_cam, "")                                                            \
  MACHINE("end-cam-oscillating", oscillating_end_cam, "end-cam-swinging")                    \
  MACHINE("linear-cam", linear_cam, "")                                                      \
  MACHINE("parallel-index-cam", parallel_index_cam, "")                                      \
  MACHINE("indexing-barrel", barrel_index_cam, "")                                           \
  MACHINE("globoidal-cam", globoidal_cam, "")                                                \
  MACHINE("geneva", planar_geneva, "")                                                       \
  MACHINE("geneva-spherical", spherical_geneva, "")                                          \
  MACHINE("servo-axis", servo_axis, "")                                                      \
  MACHINE("linear-servo-axis", linear_servo_axis, "")                                        \
  MACHINE("follower-train", follower_train, "")                                              \
  MACHINE("law", normalised_law, "")                                                         \
  MACHINE("helical-spring", helical_spring, "")                                              \
  MACHINE("disc-springs", disc_springs, "")                                                  \
  MACHINE("spine-cutter", spine_cutter, "")                                                  \
  MACHINE("die-press", die_press, "")                                                        \
  MACHINE("sheet-delivery", sheet_delivery, "")                                              \
  MACHINE("signature-feeder", signature_feeder, "")                                          \
  MACHINE("balancing-cam", planar_balancing_cam, "")                                         \
  MACHINE("balancing-cam-spherical", spherical_balancing_cam, "")

}  // namespace

#define CAMLAW_DECLARED(name, make, earlier) Mechanism make##_mechanism();
CAMLAW_MACHINES(CAMLAW_DECLARED)
#undef CAMLAW_DECLARED

namespace {

/// Each is made when it is first asked for, since all of them take milliseconds.
struct Listed {
  const char* name;
  Mechanism (*make)();
  const char* earlier;
};
#define CAMLAW_LISTED(name, make, earlier) {name, make##_mechanism, earlier},
constexpr Listed kListed[] = {CAMLAW_MACHINES(CAMLAW_LISTED)};
#undef CAMLAW_LISTED
constexpr std::size_t kMechanisms = std::size(kListed);

std::vector<Mechanism>& storage() {
  static std::vector<Mechanism> all(kMechanisms);
  return all;
}

const Mechanism& made(std::size_t i) {
  static std::array<std::once_flag, kMechanisms> flags;
  std::call_once(flags[i], [i] { storage()[i] = kListed[i].make(); });
  return storage()[i];
}

}  // namespace

const std::vector<Mechanism>& mechanisms() {
  for (std::size_t i = 0; i < kMechanisms; ++i) made(i);
  return storage();
}

const Mechanism* known_mechanism(std::string_view name) {
  for (std::size_t i = 0; i < kMechanisms; ++i) {
    const Listed& listed = kListed[i];
    if (name == listed.name || (!name.empty() && name == listed.earlier)) return &made(i);
  }
  return nullptr;
}

const Mechanism& find_mechanism(std::string_view name) {
  if (const Mechanism* known = known_mechanism(name)) return *known;
  std::vector<std::string> names;
  for (const Listed& listed : kListed) names.emplace_back(listed.name);
  refuse_name("there is no mechanism", name, names, "'camlaw mechanisms' lists all");
}

std::shared_ptr<const Mechanism> listed(const Mechanism& mechanism) {
  return {std::shared_ptr<const Mechanism>(), &mechanism};
}

std::string_view earlier_name(const Mechanism& mechanism) {
  const auto* const listed =
      std::find_if(std::begin(kListed), std::end(kListed),
                   [&](const Listed& l) { return l.name == mechanism.name; });
  return listed == std::end(kListed) ? "" : listed->earlier;
}

}  // namespace camlaw::problems

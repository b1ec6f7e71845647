// SPDX-License-Identifier: MIT
#include "machines/registry.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <mutex>

#include "machines/balancing_cam/mechanism.h"
#include "machines/cams/cams.h"
#include "machines/die_press/mechanism.h"
#include "machines/follower_train/mechanism.h"
#include "machines/geneva/mechanism.h"
#include "machines/index_drives/index_drives.h"
#include "machines/normalised_law/normalised_law.h"
#include "machines/servo_axis/mechanism.h"
#include "machines/sheet_delivery/mechanism.h"
#include "machines/signature_feeder/mechanism.h"
#include "machines/spine_cutter/mechanism.h"
#include "machines/springs/springs.h"
#include "numerics/text/names.h"

namespace camlaw::problems {
namespace {

/// Mechanisms by name, in the order of the listing: cams, what indexes, axes and followers,
/// springs, published machines. Each is made when it is first asked for, since all of them
/// take milliseconds.
struct Listed {
  const char* name;
  Mechanism (*make)();
  const char* earlier = "";  ///< its name in earlier programs, which files may have
};
constexpr Listed kListed[] = {
    {"disc-cam-roller", roller_cam_mechanism},
    {"disc-cam-flat", flat_cam_mechanism},
    {"disc-cam-knife-edge", knife_edge_cam_mechanism, "disc-cam-knife"},
    {"disc-cam-conjugate", conjugate_cam_mechanism},
    {"disc-cam-oscillating-roller", oscillating_roller_cam_mechanism, "disc-cam-swinging-roller"},
    {"disc-cam-leading-roller", leading_roller_cam_mechanism},
    {"disc-cam-oscillating-flat", oscillating_flat_cam_mechanism, "disc-cam-swinging-flat"},
    {"end-cam", end_cam_mechanism},
    {"end-cam-oscillating", oscillating_end_cam_mechanism, "end-cam-swinging"},
    {"linear-cam", linear_cam_mechanism},
    {"parallel-index-cam", parallel_index_cam_mechanism},
    {"indexing-barrel", barrel_index_cam_mechanism},
    {"globoidal-cam", globoidal_cam_mechanism},
    {"geneva", planar_geneva_mechanism},
    {"geneva-spherical", spherical_geneva_mechanism},
    {"servo-axis", servo_axis_mechanism},
    {"linear-servo-axis", linear_servo_axis_mechanism},
    {"follower-train", follower_train_mechanism},
    {"law", normalised_law_mechanism},
    {"helical-spring", helical_spring_mechanism},
    {"disc-springs", disc_springs_mechanism},
    {"spine-cutter", spine_cutter_mechanism},
    {"die-press", die_press_mechanism},
    {"sheet-delivery", sheet_delivery_mechanism},
    {"signature-feeder", signature_feeder_mechanism},
    {"balancing-cam", planar_balancing_cam_mechanism},
    {"balancing-cam-spherical", spherical_balancing_cam_mechanism}};
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
  refuse_name("no mechanism is called", name, names, "'camlaw mechanisms' lists all");
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

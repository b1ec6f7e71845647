// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "optim/crew/parcels.h"

/// Whoever carries errands out, as a function of them.
namespace camlaw::optim {

inline Hands hands_of_crew(CrewRules rules) {
  const auto crew = std::make_shared<Crew>(std::move(rules));
  return [crew](Errands& errands, const Service& service) { crew->run(errands, service); };
}

/// Workers that a transport reaches; `transport` stays as long as what is returned.
inline Hands hands_beyond(std::shared_ptr<Transport> transport) {
  const auto force = std::make_shared<ParcelForce>(*transport);
  return [transport = std::move(transport), force](Errands& errands, const Service&) {
    force->run(errands);
  };
}

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "machines/model/mechanism.h"

/// Load cases: the same machine with other values of some parameters. A response in a case is a
/// response of the mechanism like any other, "fast.contact_stress".
namespace camlaw::problems {

/// The binding with what a case sets as constants, and the law that the machine has then.
Binding in_case(const Binding& binding,
                const std::vector<std::pair<std::size_t, double>>& parameters);

/// Whether a response depends on anything that the cases set.
bool differs(const MechanismResponse& response, const std::vector<LoadCase>& cases);

/// The mechanism with every response that differs, its peaks and its checks, in each case beside
/// what it has.
Mechanism with_cases(const Mechanism& mechanism, const std::vector<LoadCase>& cases);

/// "fast.contact_stress", of a peak "fast.peak_contact_stress"; the same name where it does not
/// differ.
std::string name_in_case(const Mechanism& mechanism, const std::string& response,
                         const LoadCase& load);

/// What is wanted of a response over all cases: the highest (or the lowest) of all as the part of
/// one curve, in which case k stands at the places from k times its length on.
struct WorstCase {
  std::shared_ptr<const MechanismResponse> response;
  ResponseName name;
};
/// `parts` are the response in each case, with the same part and window. Of numbers `is_upper` says
/// whether the highest is the worst.
WorstCase worst_case(std::shared_ptr<const Mechanism> mechanism, std::vector<ResponseName> parts,
                     const std::string& name, bool is_upper);
/// The mean of the response with the weights of the cases; of curves that of their parts.
WorstCase mean_over_cases(std::shared_ptr<const Mechanism> mechanism,
                          std::vector<ResponseName> parts, const std::vector<LoadCase>& cases,
                          const std::string& name);

/// Where the worst case of a response is: in which case, and the place there; of a number the case
/// alone.
struct PlaceInCase {
  std::string load_case;
  double place;
  std::size_t part;  ///< its number among the response's over_cases
};
std::optional<PlaceInCase> place_in_case(const ResponseName& name, double place);

}  // namespace camlaw::problems

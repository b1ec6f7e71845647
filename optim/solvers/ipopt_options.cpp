// SPDX-License-Identifier: MIT
#include "optim/solvers/ipopt_options.h"

#include <IpRegOptions.hpp>
#include <algorithm>
#include <limits>
#include <string_view>

namespace camlaw::optim {
namespace {

/// Options that camlaw relies on, and why; some of them later versions of Ipopt have. A name that
/// ends in * stands for all that begin so.
struct Reserved {
  const char* reason;
  std::vector<std::string_view> names;
};

const std::vector<Reserved>& reserved() {
  static const std::vector<Reserved> list{
      {"standard output is reserved for the answer, and a search writes no files",
       {"print_*", "file_print_level", "output_file", "sb", "suppress_all_output", "inf_pr_output",
        "ma77_print_level", "ma86_print_level", "ma97_print_level", "mumps_print_level",
        "spral_print_level", "pardiso_msglvl"}},
      {"options come by name, not from a file of Ipopt's", {"option_file_name"}},
      {"the limit of iterations is common to all solvers", {"max_iter"}},
      {"the time limit is common to all solvers", {"max_cpu_time", "max_wall_time"}},
      {"it follows from the tolerances of the problem's limits and objective",
       {"tol", "constr_viol_tol", "compl_inf_tol", "dual_inf_tol", "acceptable_tol"}},
      {"the program is scaled already, and tolerances are those of its scaled rows",
       {"nlp_scaling_*", "obj_scaling_factor"}},
      {"derivatives are exact and none is constant",
       {"hessian_approximation*", "limited_memory_*", "jacobian_approximation",
        "findiff_perturbation", "gradient_approximation", "hessian_constant", "grad_f_constant",
        "jac_c_constant", "jac_d_constant", "num_linear_variables"}},
      {"camlaw has a check of its own, which 'camlaw check --derivatives' does",
       {"derivative_test*", "point_perturbation_radius"}},
      {"a run begins with the multipliers that an earlier one has left",
       {"warm_start_init_point", "warm_start_same_structure", "warm_start_entire_iterate"}},
      {"camlaw recognises by it that the objective improves without bound",
       {"diverging_iterates_tol"}},
      {"bounds beyond 1e19 mean that there is none",
       {"nlp_lower_bound_inf", "nlp_upper_bound_inf"}},
      {"the answer would be lost", {"skip_finalize_solution_call"}}};
  return list;
}

bool matches(std::string_view pattern, std::string_view name) {
  if (!pattern.ends_with('*')) return pattern == name;
  return name.starts_with(pattern.substr(0, pattern.size() - 1));
}

std::string why_reserved(std::string_view name) {
  for (const Reserved& group : reserved()) {
    if (std::any_of(group.names.begin(), group.names.end(),
                    [&](std::string_view pattern) { return matches(pattern, name); })) {
      return group.reason;
    }
  }
  return "";
}

void take_number_bounds(const Ipopt::RegisteredOption& option, NativeRule& rule) {
  if (option.HasLower()) rule.lower = option.LowerNumber(), rule.above_lower = option.LowerStrict();
  if (option.HasUpper()) rule.upper = option.UpperNumber(), rule.below_upper = option.UpperStrict();
}

/// Ipopt counts in int.
void take_integer_bounds(const Ipopt::RegisteredOption& option, NativeRule& rule) {
  rule.lower = option.HasLower() ? option.LowerInteger() : std::numeric_limits<Ipopt::Index>::min();
  rule.upper = option.HasUpper() ? option.UpperInteger() : std::numeric_limits<Ipopt::Index>::max();
}

void take_texts(const Ipopt::RegisteredOption& option, NativeRule& rule) {
  for (const auto& entry : option.GetValidStrings()) {
    if (entry.value_ == "*") {  // any text
      rule.texts.clear();
      return;
    }
    rule.texts.push_back(entry.value_);
  }
}

NativeRule rule_of(const Ipopt::RegisteredOption& option) {
  NativeRule rule;
  rule.name = option.Name();
  rule.reserved = why_reserved(rule.name);
  switch (option.Type()) {
    case Ipopt::OT_Number:
      take_number_bounds(option, rule);
      break;
    case Ipopt::OT_Integer:
      rule.kind = NativeRule::Kind::Integer;
      take_integer_bounds(option, rule);
      break;
    default:
      rule.kind = NativeRule::Kind::Text;
      take_texts(option, rule);
  }
  return rule;
}

/// A number may be given as an integer: the option's own type decides.
void pass_on(Ipopt::OptionsList& list, const NativeOptions& options) {
  const std::vector<NativeRule>& rules = ipopt_rules();
  for (const auto& [name, value] : options) {
    const auto rule = std::find_if(rules.begin(), rules.end(),
                                   [&, &wanted = name](const auto& r) { return r.name == wanted; });
    if (rule->kind == NativeRule::Kind::Text) {
      list.SetStringValue(name, std::get<std::string>(value));
    } else if (rule->kind == NativeRule::Kind::Integer) {
      list.SetIntegerValue(name, static_cast<Ipopt::Index>(std::get<std::int64_t>(value)));
    } else {
      list.SetNumericValue(name, number_of(value));
    }
  }
}

void set_warm_start(Ipopt::OptionsList& list) {
  list.SetStringValue("warm_start_init_point", "yes");
  // The start is an optimum but for angles that were added: a larger barrier would leave it.
  constexpr double kBarrier = 1e-5, kPush = 1e-6;
  list.SetNumericValue("mu_init", kBarrier);
  for (const char* push :
       {"warm_start_bound_push", "warm_start_bound_frac", "warm_start_slack_bound_push",
        "warm_start_slack_bound_frac", "warm_start_mult_bound_push"}) {
    list.SetNumericValue(push, kPush);
  }
}

}  // namespace

const std::vector<NativeRule>& ipopt_rules() {
  static const std::vector<NativeRule> rules = [] {
    const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
    std::vector<NativeRule> all;
    for (const auto& [name, option] : application->RegOptions()->RegisteredOptionsList()) {
      all.push_back(rule_of(*option));
    }
    return all;
  }();
  return rules;
}

void set_ipopt_options(Ipopt::OptionsList& list, const SolverOptions& options, bool warm) {
  list.SetIntegerValue("print_level", 0);
  list.SetStringValue("sb", "yes");
  list.SetIntegerValue("max_iter", options.max_iterations);
  list.SetNumericValue("tol", options.tolerance);
  list.SetNumericValue("constr_viol_tol", options.tolerance);
  list.SetNumericValue("compl_inf_tol", options.tolerance);
  list.SetNumericValue("dual_inf_tol", 1e3 * options.tolerance);
  // Where rounding keeps the last digits away, five iterations show it as well as Ipopt's fifteen.
  list.SetNumericValue("acceptable_tol", 1e2 * options.tolerance);
  list.SetIntegerValue("acceptable_iter", 5);
  // The program is scaled already, and its bounds are meant: Ipopt would widen them by 1e-8, which
  // is what lets it answer problems with designs that they exclude.
  list.SetStringValue("nlp_scaling_method", "none");
  list.SetNumericValue("bound_relax_factor", 0);
  list.SetStringValue("honor_original_bounds", "no");
  if (warm) set_warm_start(list);
  pass_on(list, options.native);
}

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "optim/solvers/nlopt_evaluator.h"
#include "optim/solvers/nlopt_methods.h"

/// A program handed to NLopt. For nlopt.cpp alone.
namespace camlaw::optim {

struct DestroyNlopt {
  void operator()(nlopt_opt opt) const { nlopt_destroy(opt); }
};
using NloptHandle = std::unique_ptr<nlopt_opt_s, DestroyNlopt>;

/// How often a run of the method may evaluate.
long evaluation_limit(const NloptMethod& method, const SolverOptions& options);

/// One run of one method. The evaluator must know a defined point, the start.
class NloptSearch {
 public:
  NloptSearch(const NloptMethod& method, const Program& program, const SolverOptions& options,
              Evaluator& evaluator);
  NloptSearch(const NloptSearch&) = delete;
  NloptSearch& operator=(const NloptSearch&) = delete;

  /// From y to y.
  nlopt_result run(std::vector<double>& y);
  /// NLopt's own words on a failure; null where it has none.
  const char* words() const { return nlopt_get_errmsg(opt_.get()); }

 private:
  /// Some of the program's sides as one vector-valued function.
  struct Group {
    /// Where an entry of the program's Jacobian goes in the group's dense one.
    struct Slope {
      std::size_t entry, place;
      double sign;
    };
    NloptSearch* search;
    bool equations;
    std::vector<Side> sides;
    std::vector<Slope> slopes;
  };

  NloptHandle create(nlopt_algorithm algorithm) const;
  NloptHandle create_inner() const;
  NloptHandle create_outer(const NloptHandle& inner);
  void configure();
  Group group(bool equations, std::vector<Side> sides);
  nlopt_result add_rows();
  nlopt_result sweep(std::vector<double>& y);

  const NloptPoint& evaluate(std::span<const double> y, bool with_derivatives);
  double undefined_side(const Side& side) const;
  bool is_halted_ags() const;
  static double objective(unsigned n, const double* y, double* gradient, void* search);
  static void sides(unsigned m, double* values, unsigned n, const double* y, double* gradients,
                    void* group);

  const NloptMethod& method_;
  const Program& program_;
  const SolverOptions& options_;
  const long evaluation_limit_;
  const bool wrapped_;
  Evaluator& evaluator_;
  long round_;         // evaluations of a global method in one round of a Lagrangian
  double offset_ = 0;  // added to the objective
  std::vector<Group> groups_;
  NloptHandle opt_;
};

}  // namespace camlaw::optim

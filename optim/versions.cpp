// SPDX-License-Identifier: MIT
#include "optim/versions.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <boost/version.hpp>

#include "optim/fit/ceres_search.h"
#include "optim/pareto/nsga2.h"
#include "optim/solvers/solver.h"
#include "optim/study/record.h"

namespace camlaw::optim {

std::vector<std::string> library_versions() {
  std::vector<std::string> all = solver_versions();
  all.insert(all.end(), {ceres_version(), pagmo_version(), sqlite_version(),
                         fmt::format("eigen {}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                     EIGEN_MINOR_VERSION),
                         fmt::format("boost {}.{}.{}", BOOST_VERSION / 100000,
                                     BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)});
  return all;
}

}  // namespace camlaw::optim

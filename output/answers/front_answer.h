// SPDX-License-Identifier: MIT
#pragma once

#include "optim/study/recorded_executor.h"
#include "output/answers/design_value.h"
#include "problems/fronts/front_study.h"
#include "problems/fronts/ruler.h"
#include "problems/fronts/stored_front.h"
#include "problems/statement/buildable.h"

namespace camlaw::cli {

/// A front with what it is the front of.
struct FrontAnswer {
  const problems::FrontStudy& study;
  const optim::Front& front;
  std::optional<problems::FrontRuler> ruler;
  std::vector<std::string> warnings;  ///< what stands beside the verdicts, warnings_of(*this)
  std::vector<problems::Buildability> built;  ///< of each point
  std::vector<optim::RecordFault> faults;     ///< of the record that it was read from
  std::vector<std::string> notes;             ///< what is to be said of that record
  problems::Resuming resuming = problems::Resuming::NoRecord;

  FrontAnswer(const problems::FrontStudy& study, const optim::Front& front);
  /// Of a record.
  FrontAnswer(const problems::FrontStudy& study, const problems::StoredFront& stored);

  /// The same answer of a study and a front that are the same, but for where they are and for what
  /// may stop the study.
  FrontAnswer(const problems::FrontStudy& study, const optim::Front& front,
              const FrontAnswer& other);

  /// A point's option of each choice but the law, and the values of its variables, with units.
  std::vector<DesignValue> values(const optim::FrontPoint& point) const;
  /// The law of a point in a few words, of a program its segments; empty where the mechanism takes
  /// none.
  std::string law(const optim::FrontPoint& point) const;
  /// Its family's name; of programs, where there are several, "program 2".
  std::string family(const optim::FrontPoint& point) const;
  std::vector<optim::Costs> costs() const;
  /// How many of its points cannot be built.
  std::size_t failing() const;
  /// A cost as the objective's value.
  double value(std::size_t objective, double cost) const;
};

}  // namespace camlaw::cli

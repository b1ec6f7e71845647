// SPDX-License-Identifier: MIT
#include "machines/model/design_rows.h"

#include "machines/model/curve_row.h"
#include "machines/model/jumps.h"
#include "machines/model/law_binding.h"
#include "machines/model/recorded_response.h"
#include "numerics/formula/blocks/formula_blocks.h"
#include "numerics/formula/expression.h"

namespace camlaw::problems {
namespace {

/// Of the parameters' values where the motion comes first.
Formula motion_first(const MechanismResponse& response, const Binding& binding) {
  return Formula::record(kOfPlace + binding.parameters.size(), [&](std::span<const Expression> u) {
    std::vector<Expression> parameters(binding.constants.begin(), binding.constants.end());
    for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
      parameters[binding.parameters[k]] = u[kOfPlace + k];
    }
    return response.write(parameters, u.first(kOfPlace));
  });
}

class RecordedRows final : public DesignRows {
 public:
  RecordedRows(const MechanismResponse& response, const Binding& binding)
      : cycle_(*response.cycle),
        law_(law_of_cam(binding.law, response.cam)),
        formula_(motion_first(response, binding)),
        blocks_({&formula_, 1}, kOfPlace),
        may_jump_(may_jump(recorded_for(binding, response.write, kOfPlace, {}))) {}

  Motion motion_at(optim::Place place) const override {
    const Stretch& stretch = cycle_.stretch_at(place);
    const PlaceMotion motion(law_, cycle_, stretch, law_place(stretch, place, may_jump_),
                             {true, true, true, true});
    const auto known = motion.at({}, 0).value;
    return {known[0], known[1], known[2], known[3], motion.place_at({}, 0).value[0]};
  }
  void values(const Motion& motion, std::span<const std::span<const double>> parameters,
              std::span<double> result) const override {
    const std::array<std::span<double>, 1> row{result};
    blocks_(motion, parameters, row);
  }

 private:
  Cycle cycle_;
  std::shared_ptr<const LawBinding> law_;
  Formula formula_;
  FormulaBlocks blocks_;
  bool may_jump_;
};

}  // namespace

std::unique_ptr<DesignRows> design_rows(const MechanismResponse& response, const Binding& binding) {
  if (!response.write || !response.cycle || !response.held.empty()) return nullptr;
  if (!law_of_cam(binding.law, response.cam)->variables().empty()) return nullptr;
  return std::make_unique<RecordedRows>(response, binding);
}

}  // namespace camlaw::problems

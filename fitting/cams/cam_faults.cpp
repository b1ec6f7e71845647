// SPDX-License-Identifier: MIT
#include "fitting/cams/cam_faults.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

using Complex = std::complex<double>;

/// Values over the turn, straight between their places.
class AroundTurn {
 public:
  explicit AroundTurn(std::vector<std::pair<double, double>> values) : values_(std::move(values)) {
    std::sort(values_.begin(), values_.end());
    const auto first = values_.front(), last = values_.back();
    values_.insert(values_.begin(), {last.first - kTurnDegrees, last.second});
    values_.emplace_back(first.first + kTurnDegrees, first.second);
  }

  double operator()(double place) const {
    const double at = in_period(place, 0, kTurnDegrees);
    const auto next = std::lower_bound(values_.begin() + 1, values_.end() - 1,
                                       std::pair(at, -std::numeric_limits<double>::infinity()));
    const auto& [x0, y0] = *(next - 1);
    const auto& [x1, y1] = *next;
    return x1 > x0 ? y0 + (y1 - y0) * (at - x0) / (x1 - x0) : y1;
  }

 private:
  std::vector<std::pair<double, double>> values_;
};

/// A column of values per sample of the lift, in the samples' unit.
template <class Value>
std::function<double(double)> column(const MeasuredCam& cam, const Value& value) {
  const double unit = cam.unit();
  std::vector<std::pair<double, double>> values;
  for (const LiftSample& sample : cam.lift.samples()) {
    if (!sample.outlying) values.emplace_back(sample.phi / kDegree, value(sample) / unit);
  }
  // Shared: a std::function is copied often.
  return [around = std::make_shared<AroundTurn>(std::move(values))](double place) {
    return (*around)(place);
  };
}

/// The normal at the contact in the frame, where the cam turns counterclockwise.
Complex normal_in_frame(const MeasuredCam& cam, const LiftSample& sample) {
  const Complex own =
      cam.lift.rotation() == Rotation::Clockwise ? std::conj(sample.normal) : sample.normal;
  return own * std::polar(1.0, sample.phi);
}

/// The follower's coordinate q in w(q, size) must keep the contact's distance along its normal N:
/// dq = -Re(dw/dsize conj N) / Re(dw/dq conj N) per change of the size.
PossibleFault own_size(const MeasuredCam& cam, const char* name,
                       const std::function<Complex(const LiftSample&)>& moved) {
  return {FaultKind::OwnSize, {name}, {column(cam, [&](const LiftSample& sample) {
            return -std::real(moved(sample) * std::conj(normal_in_frame(cam, sample))) *
                   sample.follows;
          })}};
}

constexpr const char *kRollerRadius = "roller_radius", *kOffset = "offset",
                     *kArmLength = "arm_length", *kPivotDistance = "pivot_distance";

/// The sizes that may be other ones, as faults name them.
std::map<std::string_view, double*> sizes_of(MeasuredFollower& follower) {
  if (auto* roller = std::get_if<TranslatingRoller>(&follower)) {
    return {{kRollerRadius, &roller->roller_radius}, {kOffset, &roller->offset}};
  }
  if (auto* arm = std::get_if<OscillatingRoller>(&follower)) {
    return {{kRollerRadius, &arm->roller_radius},
            {kArmLength, &arm->arm_length},
            {kPivotDistance, &arm->pivot_distance}};
  }
  return {};
}

PossibleFault roller_radius(const MeasuredCam& cam) {
  return {FaultKind::OwnSize,
          {kRollerRadius},
          {column(cam, [](const LiftSample& sample) { return sample.follows; })}};
}

}  // namespace

PossibleFault centre_of(const MeasuredCam& cam) {
  return {FaultKind::OffCentre,
          {"centre_x", "centre_y"},
          {column(cam, [](const LiftSample& s) { return s.follows * std::real(s.normal); }),
           column(cam, [](const LiftSample& s) { return s.follows * std::imag(s.normal); })}};
}

std::vector<PossibleFault> possible_faults(const MeasuredCam& cam) {
  std::vector<PossibleFault> faults{centre_of(cam), drift(0, kTurnDegrees, kTurnDegrees)};
  if (std::holds_alternative<TranslatingRoller>(cam.lift.follower())) {
    faults.push_back(roller_radius(cam));
    faults.push_back(own_size(cam, kOffset, [](const LiftSample&) { return Complex(1, 0); }));
    faults.back().may_be_far = true;
  }
  if (std::holds_alternative<OscillatingRoller>(cam.lift.follower())) {
    faults.push_back(roller_radius(cam));
    faults.push_back(
        own_size(cam, kPivotDistance, [](const LiftSample&) { return Complex(1, 0); }));
    const double zero = cam.lift.coordinate(0);
    // The arm is seen in the mirror where the cam turns clockwise.
    const double sense = cam.lift.rotation() == Rotation::Clockwise ? 1 : -1;
    faults.push_back(own_size(cam, kArmLength, [zero, sense](const LiftSample& sample) {
      return -std::polar(1.0, sense * (zero + sample.s));
    }));
  }
  return faults;
}

MeasuredFollower with_less(MeasuredFollower follower, const std::string& name, double less) {
  for (const auto& [size, value] : sizes_of(follower)) {
    if (size == name) *value -= less;
  }
  return follower;
}

}  // namespace camlaw::problems

// SPDX-License-Identifier: MIT
#include "output/report/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "machines/model/known_names.h"
#include "output/figure/chart_svg.h"

namespace camlaw::cli {
namespace {

const char* kind_text(BodyMotion::Kind kind) {
  using K = BodyMotion::Kind;
  return kind == K::Turn ? "turn" : kind == K::Slide ? "slide" : "harmonic";
}

/// As motion.js reads it: the kind, the curve or "cycle", its value as drawn, then the numbers.
std::string step_text(const BodyMotion& step, const std::map<std::string, double>& drawn_at) {
  const bool by_cycle = step.curve.empty();
  return fmt::format("{} {} {:.9g} {:.9g} {:.6g} {:.6g} {:.9g}", kind_text(step.kind),
                     by_cycle ? "cycle" : step.curve, by_cycle ? 0 : drawn_at.at(step.curve),
                     step.factor, step.about.x, step.about.y, step.phase);
}

/// A polyline as the `d` of a path has it.
std::string path_text(const std::vector<DrawnPoint>& points) {
  std::string path;
  for (const DrawnPoint& p : points) {
    path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : "L", p.x, p.y);
  }
  return path;
}

/// The stretches of a curve whose points are all on the near side, as drawn and as motion.js draws
/// them: those of `one`, and where there is an `other`, each with its stretch back along that.
std::string near_parts(const std::vector<SpunPoint>& one, const std::vector<SpunPoint>& other) {
  const auto drawn = [](const SpunPoint& p) { return DrawnPoint{p.right, p.up}; };
  std::string text;
  for (std::size_t begin = 0, end = 0; end <= one.size(); ++end) {
    const bool is_near =
        end < one.size() && one[end].near >= 0 && (other.empty() || other[end].near >= 0);
    if (is_near) continue;
    std::vector<DrawnPoint> part;
    for (std::size_t i = begin; i < end; ++i) part.push_back(drawn(one[i]));
    for (std::size_t i = end; i > begin && !other.empty(); --i) part.push_back(drawn(other[i - 1]));
    if (end > begin + 1) text += path_text(part) + (other.empty() ? "" : "Z");
    begin = end + 1;
  }
  return text;
}

/// "RIGHT UP NEAR, RIGHT UP NEAR": a curve as motion.js reads it.
std::string spun_text(const std::vector<SpunPoint>& curve) {
  std::string text;
  for (const SpunPoint& p : curve) {
    text += fmt::format("{}{:.1f} {:.1f} {:.1f}", text.empty() ? "" : ",", p.right, p.up, p.near);
  }
  return text;
}

std::string spun_path(std::string_view kind, const std::vector<SpunPoint>& one,
                      const std::vector<SpunPoint>& other) {
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, near_parts(one, other));
}

}  // namespace

void Scene::body(std::string_view name, const std::vector<BodyMotion>& steps) {
  std::string motion;
  for (const BodyMotion& step : steps) {
    motion += (motion.empty() ? "" : "; ") + step_text(step, drawn_at_);
  }
  if (open_) bodies_ += "</g>\n";
  bodies_ += fmt::format("<g class=\"body\"{}><title>{}</title>\n",
                         motion.empty() ? "" : fmt::format(" data-motion=\"{}\"", motion),
                         xml_escape(name));
  open_ = true;
}

std::set<std::string> Scene::follows() const {
  std::set<std::string> curves;
  for (const auto& [curve, value] : drawn_at_) curves.insert(curve);
  return curves;
}

void Scene::polyline(std::string_view kind, const std::vector<DrawnPoint>& points, bool closed) {
  bodies_ +=
      fmt::format("<path class=\"{}\" d=\"{}{}\"/>\n", kind, path_text(points), closed ? "Z" : "");
}

void Scene::spun(std::string_view kind, const std::vector<SpunPoint>& curve) {
  bodies_ +=
      fmt::format("<g data-spun=\"{}\">\n{}</g>\n", spun_text(curve), spun_path(kind, curve, {}));
}

void Scene::spun_groove(const std::vector<SpunPoint>& one, const std::vector<SpunPoint>& other) {
  bodies_ += fmt::format("<g data-spun=\"{}|{}\">\n{}{}{}</g>\n", spun_text(one), spun_text(other),
                         spun_path("groove", one, other), spun_path("edge", one, {}),
                         spun_path("edge", other, {}));
}

void Scene::text(DrawnPoint middle, double height, std::string_view words) {
  // The picture's y axis is upwards, that of letters downwards.
  bodies_ += fmt::format(
      "<text transform=\"scale(1,-1)\" x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\">{}</text>\n",
      middle.x, -(middle.y - 0.35 * height), height, xml_escape(words));
}

void Scene::circle(std::string_view kind, DrawnPoint centre, double radius) {
  bodies_ += fmt::format("<circle class=\"{}\" cx=\"{:.3f}\" cy=\"{:.3f}\" r=\"{:.3f}\"/>\n", kind,
                         centre.x, centre.y, radius);
}

void Scene::segment(std::string_view kind, DrawnPoint from, DrawnPoint to) {
  bodies_ +=
      fmt::format("<line class=\"{}\" x1=\"{:.3f}\" y1=\"{:.3f}\" x2=\"{:.3f}\" y2=\"{:.3f}\"/>\n",
                  kind, from.x, from.y, to.x, to.y);
}

void Scene::roller(DrawnPoint centre, double radius) {
  circle("roller", centre, radius);
  circle("pin", centre, 0.15 * radius);
}

void Scene::arrow_head(DrawnPoint tip, DrawnPoint direction, double length) {
  const double norm = std::hypot(direction.x, direction.y);
  const DrawnPoint along{length * direction.x / norm, length * direction.y / norm};
  const DrawnPoint across{-0.4 * along.y, 0.4 * along.x};
  polyline("head",
           {{tip.x + along.x, tip.y + along.y},
            {tip.x + across.x, tip.y + across.y},
            {tip.x - across.x, tip.y - across.y}},
           true);
}

void Scene::turn_arrow(DrawnPoint centre, double radius, double turning, double angle) {
  constexpr double kReach = 30, kSteps = 20;  // deg; pieces
  const double sense = turning < 0 ? -1 : 1;
  std::vector<DrawnPoint> arc;
  DrawnPoint along{};
  for (int i = 0; i <= kSteps; ++i) {
    const double at = (angle + sense * kReach * i / kSteps) * std::numbers::pi / 180;
    arc.push_back({centre.x + radius * std::cos(at), centre.y + radius * std::sin(at)});
    along = {-sense * std::sin(at), sense * std::cos(at)};
  }
  polyline("arrow", arc, false);
  arrow_head(arc.back(), along, 0.07 * radius);
  for (const DrawnPoint& p : arc) include(p, 0.07 * radius);
}

void Scene::straight_arrow(DrawnPoint from, DrawnPoint to) {
  segment("arrow", from, to);
  const DrawnPoint along{to.x - from.x, to.y - from.y};
  arrow_head(to, along, 0.2 * std::hypot(along.x, along.y));
  include(from), include(to, 0.1 * std::hypot(along.x, along.y));
}

void Scene::include(DrawnPoint p) {
  if (!window_) window_ = {p, p};
  auto& [low, high] = *window_;
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

void Scene::include(DrawnPoint centre, double radius) {
  include({centre.x - radius, centre.y - radius});
  include({centre.x + radius, centre.y + radius});
}

std::string Scene::svg() const {
  const auto& [low, high] = window_.value();
  const double margin = 0.04 * std::max(high.x - low.x, high.y - low.y);
  const double width = high.x - low.x + 2 * margin, height = high.y - low.y + 2 * margin;
  return fmt::format(
             "<svg class=\"scene\" role=\"img\" aria-label=\"{}\" viewBox=\"{:.2f} {:.2f} {:.2f} "
             "{:.2f}\">\n<g transform=\"scale(1,-1)\">\n",
             xml_escape(title_), low.x - margin, -(high.y + margin), width, height) +
         bodies_ + (open_ ? "</g>\n" : "") + "</g></svg>\n";
}

SceneCurves::SceneCurves(const problems::ProblemStatement& design, int points)
    : curves_(problems::curves_of(design)), points_(points) {}

bool SceneCurves::has(const std::string& name) const {
  return std::any_of(curves_.begin(), curves_.end(),
                     [&](const optim::Response& curve) { return curve.name == name; });
}

const std::vector<double>& SceneCurves::values(const std::string& name) const {
  const auto known = known_.find(name);
  if (known != known_.end()) return known->second;
  const auto curve = trace(name);
  const std::vector<double> breaks = curve->breaks();
  const auto places = optim::even_places(breaks.front(), breaks.back(), points_);
  return known_[name] = curve->values(places);
}

std::vector<double> SceneCurves::slopes(const std::string& name) const {
  const auto curve = trace(name);
  const std::vector<double> breaks = curve->breaks();
  std::vector<double> result;
  for (const optim::Place& place : optim::even_places(breaks.front(), breaks.back(), points_)) {
    result.push_back(curve->at(place)[1]);
  }
  return result;
}

std::unique_ptr<optim::Trace> SceneCurves::trace(const std::string& name) const {
  const auto curve =
      std::find_if(curves_.begin(), curves_.end(),
                   [&](const optim::Response& response) { return response.name == name; });
  if (curve == curves_.end()) throw std::logic_error("no curve " + name);
  return curve->curve().trace({});
}

std::vector<DrawnPoint> SceneCurves::points(const std::string& name) const {
  const std::vector<double>&x = values(name + "_x"), &y = values(name + "_y");
  std::vector<DrawnPoint> result;
  for (std::size_t i = 0; i < x.size(); ++i) result.push_back({x[i], y[i]});
  return result;
}

bool has_parameter(const problems::ProblemStatement& design, std::string_view name) {
  return problems::parameter_called(*design.mechanism, name).has_value();
}

void draw_pushed_roller(Scene& scene, DrawnPoint centre, double radius, const std::string& curve) {
  scene.body("roller", {{BodyMotion::Kind::Slide, 1, {0, 1}, curve}});
  scene.roller(centre, radius);
  scene.segment("stem", centre, {centre.x, centre.y + 2.2 * radius});
}

void draw_roller_arm(Scene& scene, DrawnPoint pivot, DrawnPoint centre, double radius) {
  scene.body("arm with its roller", {{BodyMotion::Kind::Turn, -1, pivot, "displacement"}});
  scene.segment("arm", pivot, centre);
  scene.roller(centre, radius);
  scene.body("pivot");
  scene.circle("pivot", pivot, 0.3 * radius);
}

std::optional<Scene> scene_of(const problems::ProblemStatement& design, int points) {
  for (const auto& draw :
       {balancing_scene, disc_scene, feeder_scene, geneva_scene, index_scene, plate_scene,
        spherical_geneva_scene, servo_scene, path_scene, slider_scene}) {
    if (std::optional<Scene> scene = draw(design, points)) return scene;
  }
  return {};
}

std::string scene_svg(const problems::ProblemStatement& design, int points) {
  const std::optional<Scene> scene = scene_of(design, points);
  return scene ? scene->svg() : "";
}

}  // namespace camlaw::cli

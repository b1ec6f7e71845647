// SPDX-License-Identifier: MIT
#include "optim/study/encoding.h"

#include "optim/crew/bytes.h"
#include "optim/search/options_bytes.h"

namespace camlaw::optim {

template <>
inline constexpr int kLast<Task::Kind> = static_cast<int>(Task::Kind::Sample);

template <class Archive, class S>
requires std::is_same_v<std::remove_const_t<S>, Standing>
void visit(Archive& archive, S& s) {
  archive(s.name), archive(s.unit), archive(s.margin), archive(s.angle);
  archive(s.met), archive(s.proved), archive(s.price);
}

template <class Archive, class P>
requires std::is_same_v<std::remove_const_t<P>, FrontPoint>
void visit(Archive& archive, P& p) {
  archive(p.part), archive(p.x), archive(p.objectives), archive(p.costs), archive(p.weights);
  archive(p.verdict), archive(p.reason), archive(p.is_global), archive(p.limits), archive(p.solver);
}

template <class Archive, class O>
requires std::is_same_v<std::remove_const_t<O>, Outcome>
void visit(Archive& archive, O& o) {
  archive(o.points), archive(o.infeasible), archive(o.evaluations), archive(o.failure);
  archive(o.died), archive(o.is_global);
}

/// Names every member, so that one which is added is not forgotten.
template <class Archive, class T>
requires std::is_same_v<std::remove_const_t<T>, Task>
void visit(Archive& archive, T& task) {
  auto& [kind, part, sought, bounds, origin, direction, starts, population, generations, seed] =
      task;
  archive(kind), archive(part), archive(sought), archive(bounds), archive(origin);
  archive(direction), archive(starts), archive(population), archive(generations), archive(seed);
}

template <class Archive, class O>
requires std::is_same_v<std::remove_const_t<O>, Order>
void visit(Archive& archive, O& order) { archive(order.task), archive(order.options); }

std::string encoded(const Outcome& outcome) { return bytes_of(outcome); }
std::string encoded(const Order& order) { return bytes_of(order); }
std::string encoded(const std::vector<std::string>& texts) { return bytes_of(texts); }

std::optional<Outcome> decoded(std::string_view bytes) { return value_of_bytes<Outcome>(bytes); }
std::optional<Order> decoded_order(std::string_view bytes) { return value_of_bytes<Order>(bytes); }
std::optional<std::vector<std::string>> decoded_texts(std::string_view bytes) {
  return value_of_bytes<std::vector<std::string>>(bytes);
}

}  // namespace camlaw::optim

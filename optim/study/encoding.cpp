// SPDX-License-Identifier: MIT
#include "optim/study/encoding.h"

#include <cstring>
#include <map>
#include <type_traits>

namespace camlaw::optim {
namespace {

/// Writes numbers, texts, lists and the structs below one after the other.
class Writer {
 public:
  std::string take() { return std::move(bytes_); }

  template <class T>
  void operator()(const T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      const auto* raw = reinterpret_cast<const char*>(&value);
      bytes_.append(raw, sizeof(T));
    } else {
      visit(*this, value);
    }
  }
  void operator()(const std::string& text) {
    (*this)(text.size());
    bytes_ += text;
  }
  template <class T>
  void operator()(const std::vector<T>& list) {
    (*this)(list.size());
    for (const T& item : list) (*this)(item);
  }
  template <class T>
  void operator()(const std::optional<T>& value) {
    (*this)(value.has_value());
    if (value) (*this)(*value);
  }
  template <class T>
  void operator()(const std::map<std::string, T>& table) {
    (*this)(table.size());
    for (const auto& [name, value] : table) (*this)(name), (*this)(value);
  }
  void operator()(const NativeValue& value) {
    (*this)(value.index());
    std::visit(*this, value);
  }

 private:
  std::string bytes_;
};

/// Reads them back; after bytes that are none of ours `good` is false.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}
  bool ended_well() const { return good_ && left_.empty(); }

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      if (!has(sizeof(T))) return;
      std::memcpy(&value, left_.data(), sizeof(T));
      left_.remove_prefix(sizeof(T));
    } else {
      visit(*this, value);
    }
  }
  void operator()(std::string& text) {
    const std::size_t size = count();
    text = left_.substr(0, size);
    left_.remove_prefix(size);
  }
  void operator()(bool& value) {
    unsigned char byte = 0;
    (*this)(byte);
    good_ = good_ && byte <= 1;
    value = byte == 1;
  }
  void operator()(Verdict& verdict) {
    int number = 0;
    (*this)(number);
    good_ = good_ && number >= 0 && number <= static_cast<int>(Verdict::Failed);
    verdict = good_ ? static_cast<Verdict>(number) : Verdict::Failed;
  }
  void operator()(Task::Kind& kind) {
    int number = 0;
    (*this)(number);
    good_ = good_ && number >= 0 && number <= static_cast<int>(Task::Kind::Scout);
    kind = good_ ? static_cast<Task::Kind>(number) : Task::Kind::Bounded;
  }
  /// Item by item: what is not a list of ours may claim to be longer than there is memory.
  template <class T>
  void operator()(std::vector<T>& list) {
    const std::size_t size = count();
    while (good_ && list.size() < size) (*this)(list.emplace_back());
  }
  template <class T>
  void operator()(std::optional<T>& value) {
    bool there = false;
    (*this)(there);
    if (there) (*this)(value.emplace());
  }
  template <class T>
  void operator()(std::map<std::string, T>& table) {
    for (std::size_t left = count(); good_ && left > 0; --left) {
      std::string name;
      (*this)(name);
      (*this)(table[name]);
    }
  }
  void operator()(NativeValue& value) {
    std::size_t kind = 0;
    (*this)(kind);
    if (kind == 0) (*this)(value.emplace<0>());
    if (kind == 1) (*this)(value.emplace<1>());
    if (kind == 2) (*this)(value.emplace<2>());
    good_ = good_ && kind < std::variant_size_v<NativeValue>;
  }

 private:
  bool has(std::size_t size) {
    good_ = good_ && size <= left_.size();
    return good_;
  }
  /// Of a list or text; no more than there are bytes.
  std::size_t count() {
    std::size_t size = 0;
    (*this)(size);
    return has(size) ? size : 0;
  }

  std::string_view left_;
  bool good_ = true;
};

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
requires std::is_same_v<std::remove_const_t<O>, OptimiseOptions>
void visit(Archive& archive, O& options) {
  auto& [solver, starts, seed, time_limit, spent, iterations, evaluations, memory, native, divides,
         stop, progress, candidate] = options;
  archive(solver), archive(starts), archive(seed), archive(time_limit), archive(spent);
  archive(iterations), archive(evaluations), archive(memory), archive(native), archive(divides);
}

template <class Archive, class O>
requires std::is_same_v<std::remove_const_t<O>, Order>
void visit(Archive& archive, O& order) { archive(order.task), archive(order.options); }

template <class T>
std::string bytes_of(const T& value) {
  Writer writer;
  writer(value);
  return writer.take();
}

/// None where the bytes are not those of one such value.
template <class T>
std::optional<T> value_of_bytes(std::string_view bytes) {
  Reader reader(bytes);
  T value;
  reader(value);
  if (!reader.ended_well()) return {};
  return value;
}

}  // namespace

std::string encoded(const Outcome& outcome) { return bytes_of(outcome); }
std::string encoded(const Order& order) { return bytes_of(order); }
std::string encoded(const std::vector<std::string>& texts) { return bytes_of(texts); }

std::optional<Outcome> decoded(std::string_view bytes) { return value_of_bytes<Outcome>(bytes); }
std::optional<Order> decoded_order(std::string_view bytes) { return value_of_bytes<Order>(bytes); }
std::optional<std::vector<std::string>> decoded_texts(std::string_view bytes) {
  return value_of_bytes<std::vector<std::string>>(bytes);
}

}  // namespace camlaw::optim

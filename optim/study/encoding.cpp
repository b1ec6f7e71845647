// SPDX-License-Identifier: MIT
#include "optim/study/encoding.h"

#include <cstring>
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
  /// Item by item: what is no list of ours may claim to be longer than there is memory.
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

}  // namespace

std::string encoded(const Outcome& outcome) {
  Writer writer;
  writer(outcome);
  return writer.take();
}

std::optional<Outcome> decoded(std::string_view bytes) {
  Reader reader(bytes);
  Outcome outcome;
  reader(outcome);
  if (!reader.ended_well()) return {};
  return outcome;
}

}  // namespace camlaw::optim

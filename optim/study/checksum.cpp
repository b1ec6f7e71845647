// SPDX-License-Identifier: MIT
#include "optim/study/checksum.h"

#include <bit>
#include <boost/crc.hpp>
#include <cmath>
#include <limits>

namespace camlaw::optim {
namespace {

constexpr int kBits = 64;  // CRC-64/XZ, with the polynomial of ECMA-182
constexpr std::uint64_t kPolynomial = 0x42f0e1eba9ea3693, kAll = ~std::uint64_t{0};

}  // namespace

struct Checksum::State {
  boost::crc_optimal<kBits, kPolynomial, kAll, kAll, true, true> crc;
};

Checksum::Checksum() : state_(std::make_unique<State>()) {}
Checksum::Checksum(Checksum&&) noexcept = default;
Checksum::~Checksum() = default;

void Checksum::add(std::string_view bytes) {
  state_->crc.process_bytes(bytes.data(), bytes.size());
}

void Checksum::add(char kind, std::string_view bytes) {
  add(kind, static_cast<std::int64_t>(bytes.size()));
  add(bytes);
}

void Checksum::add(char kind, double value) {
  const double plain = std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value + 0.0;
  add(kind, std::bit_cast<std::int64_t>(plain));
}

void Checksum::add(char kind, std::int64_t value) {
  state_->crc.process_byte(static_cast<unsigned char>(kind));
  for (int byte = 0; byte < 8; ++byte) {  // the lowest first, whatever the machine's order
    const auto bits = static_cast<std::uint64_t>(value) >> (8 * byte);
    state_->crc.process_byte(static_cast<unsigned char>(bits & 0xff));
  }
}

std::uint64_t Checksum::value() const { return state_->crc.checksum(); }

}  // namespace camlaw::optim

// SPDX-License-Identifier: MIT
#include "numerics/text/sha256.h"

#include <catch2/catch.hpp>
#include <string>

namespace camlaw::sha256_test {
namespace {

TEST_CASE("SHA-256 of the standard's examples is what the standard prints", "[text]") {
  // NIST, "Examples with intermediate values", SHA256.pdf, and SHA256ShortMsg.rsp for no bytes.
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256(std::string(1'000'000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("SHA-256 counts zeros and bytes above 127", "[text]") {
  // printf '\x00\xff' | sha256sum
  CHECK(sha256(std::string("\x00\xff", 2)) ==
        "06eb7d6a69ee19e5fbdf749018d3d2abfa04bcbd1365db312eb86dc7169389b8");
}

TEST_CASE("SHA-256 is right on either side of each length that fills a block", "[text]") {
  // head -c N /dev/zero | tr '\0' 'x' | sha256sum
  CHECK(sha256(std::string(55, 'x')) ==
        "d5e285683cd4efc02d021a5c62014694958901005d6f71e89e0989fac77e4072");
  CHECK(sha256(std::string(56, 'x')) ==
        "04c26261370ee7541549d16dee320c723e3fd14671e66a099afe0a377c16888e");
  CHECK(sha256(std::string(64, 'x')) ==
        "7ce100971f64e7001e8fe5a51973ecdfe1ced42befe7ee8d5fd6219506b5393c");
}

}  // namespace
}  // namespace camlaw::sha256_test

// SPDX-License-Identifier: Apache-2.0
// The _init functions write as much of a struct as the caller knows, and nothing of what lies behind it.
#include <gtest/gtest.h>

#include <abut/abut.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace {

struct Later {
  abut_query_options known;
  std::array<unsigned char, 24> appended;
};

Later filled_with(unsigned char byte) {
  std::array<unsigned char, sizeof(Later)> bytes{};
  bytes.fill(byte);
  return std::bit_cast<Later>(bytes);
}

TEST(Defaults, OfTheWholeStruct) {
  Later later = filled_with(0xab);
  abut_query_options_init(&later.known, sizeof later.known);
  EXPECT_EQ(later.known.struct_size, sizeof later.known);
  EXPECT_EQ(later.known.max_contacts, 4u);
  for (const unsigned char byte : later.appended) {
    EXPECT_EQ(byte, 0xab);
  }
}

TEST(Defaults, OfAnOlderAndShorterStruct) {
  Later later = filled_with(0xab);
  constexpr std::uint32_t older = offsetof(abut_query_options, margin);
  abut_query_options_init(&later.known, older);
  EXPECT_EQ(later.known.struct_size, older);
  EXPECT_EQ(later.known.algorithm, ABUT_ALGORITHM_AUTO);
  const Later untouched = filled_with(0xab);
  EXPECT_EQ(std::memcmp(&later.known.margin, &untouched.known.margin, sizeof later.known.margin), 0);
  EXPECT_EQ(later.known.max_contacts, untouched.known.max_contacts);
}

TEST(Defaults, OfANewerStructWhoseOtherFieldsAreZero) {
  Later later = filled_with(0xab);
  abut_query_options_init(&later.known, sizeof later);
  EXPECT_EQ(later.known.struct_size, sizeof later);
  EXPECT_EQ(later.known.max_contacts, 4u);
  for (const unsigned char byte : later.appended) {
    EXPECT_EQ(byte, 0);
  }
}

TEST(Defaults, NothingForSizesThatNoStructHas) {
  for (const std::uint32_t size : {0u, 3u, 4097u, 0xffffffffu}) {
    Later later = filled_with(0xab);
    const Later before = later;
    abut_query_options_init(&later.known, size);
    EXPECT_EQ(std::memcmp(&later, &before, sizeof later), 0) << size;
  }
}

}  // namespace

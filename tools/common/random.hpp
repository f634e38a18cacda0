// SPDX-License-Identifier: Apache-2.0
// Seeded random numbers. The distributions of the standard library differ from one implementation to the next;
// these do not.
#pragma once

#include <cstdint>

#include "vector.hpp"

namespace tools {

/// SplitMix64 (Steele, Lea and Flood 2014).
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  /// In [low, high).
  constexpr double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11U) * 0x1.0p-53);
  }

  /// Below `count`, which is not zero. The bias of the remainder is below 2^-50 for the small counts used here.
  constexpr std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }

  /// A direction in the unit ball's surface, by rejection: no trigonometry.
  Vec3 direction() {
    for (;;) {
      const Vec3 v{uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0)};
      const double square = dot(v, v);
      if (square > 0.01 && square <= 1.0) {
        return v * (1.0 / std::sqrt(square));
      }
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace tools

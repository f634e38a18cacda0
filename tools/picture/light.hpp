// SPDX-License-Identifier: Apache-2.0
// Shadows: rays from what the picture shows towards the sun and into the sky.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "look.hpp"
#include "picker.hpp"

namespace tools {

/// A ray and what it met.
struct Sample {
  abut_ray ray;
  abut_pick pick;
  std::uint32_t pattern;  // below pattern_count: which share of the sky and the sun this sample tests
};

/// Neighbouring samples with different patterns test different directions; together they cover sky and sun evenly.
inline constexpr std::uint32_t pattern_count = 16;

/// Light that reaches each sample.
[[nodiscard]] std::vector<Light> trace_light(const Picker& picker, const Look& look, std::span<const Sample> samples);

}  // namespace tools

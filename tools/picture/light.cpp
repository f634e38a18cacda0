// SPDX-License-Identifier: Apache-2.0
#include "light.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace tools {
namespace {

constexpr std::uint32_t sky_rays = 4;  // a sample
constexpr double sun_radius = 0.02;    // radians; wider than the real one, for soft shadows

// Van der Corput's sequence in base 2.
double radical_inverse(std::uint32_t n) {
  double result = 0.0;
  double digit = 0.5;
  for (; n > 0; n >>= 1U) {
    result += (n & 1U) != 0 ? digit : 0.0;
    digit *= 0.5;
  }
  return result;
}

// Directions about +Z, denser towards it by the cosine; entry pattern + pattern_count * k belongs to that pattern.
std::vector<Vec3> sky_directions() {
  constexpr std::uint32_t count = pattern_count * sky_rays;
  std::vector<Vec3> directions(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double square = (i + 0.5) / count;
    const double angle = 2.0 * std::numbers::pi * radical_inverse(i);
    const double radius = std::sqrt(square);
    // 5 has no factor in common with the count of patterns, so every pattern gets entries of all radii.
    const std::uint32_t pattern = (i * 5U) % pattern_count;
    directions[pattern + pattern_count * (i / pattern_count)] = {radius * std::cos(angle), radius * std::sin(angle),
                                                                 std::sqrt(1.0 - square)};
  }
  return directions;
}

// v, given about +Z, about a unit normal instead.
Vec3 about(const Vec3& normal, const Vec3& v) {
  const Vec3 aside = std::abs(normal.x) < 0.7 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 tangent = normalised(cross(normal, aside));
  return tangent * v.x + cross(normal, tangent) * v.y + normal * v.z;
}

// A point of the sun's disc for each pattern.
std::array<Vec3, pattern_count> sun_directions(const Vec3& sun) {
  std::array<Vec3, pattern_count> directions{};
  for (std::uint32_t i = 0; i < pattern_count; ++i) {
    const double angle = 2.0 * std::numbers::pi * radical_inverse(i);
    const double radius = sun_radius * std::sqrt((i + 0.5) / pattern_count);
    directions[(i * 5U) % pattern_count] =
        normalised(about(sun, {radius * std::cos(angle), radius * std::sin(angle), 1.0}));
  }
  return directions;
}

}  // namespace

std::vector<Light> trace_light(const Picker& picker, const Look& look, std::span<const Sample> samples) {
  const std::vector<Vec3> directions = sky_directions();
  const std::array<Vec3, pattern_count> suns = sun_directions(look.sun());
  const Reach reach = look.reach();
  std::vector<Light> lights(samples.size());
  std::vector<abut_ray> to_sun;
  std::vector<std::size_t> sun_sample;
  std::vector<abut_ray> to_sky;
  std::vector<std::size_t> sky_sample;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    if (sample.pick.geometry.slot == 0) {
      continue;
    }
    const Vec3 normal = look.normal(sample.ray, sample.pick);
    const bool away = dot(sample.pick.normal, sample.ray.direction) > 0.0;
    const Vec3 start = sample.pick.point + sample.pick.normal * (away ? -reach.lift : reach.lift);
    if (dot(normal, look.sun()) > 0.0) {
      to_sun.push_back({start, suns[sample.pattern], reach.sun});
      sun_sample.push_back(i);
    }
    for (std::uint32_t k = 0; k < sky_rays; ++k) {
      to_sky.push_back({start, about(normal, directions[sample.pattern + pattern_count * k]), reach.sky});
      sky_sample.push_back(i);
    }
  }
  const std::vector<abut_pick> sun_hits = picker.cast(to_sun, ABUT_COHERENCE_NONE);
  for (std::size_t i = 0; i < sun_hits.size(); ++i) {
    const bool is_lit = sun_hits[i].geometry.slot == 0 || look.lets_through(samples[sun_sample[i]].pick, sun_hits[i]);
    lights[sun_sample[i]].sun = is_lit ? 1.0 : 0.0;
  }
  const std::vector<abut_pick> sky_hits = picker.cast(to_sky, ABUT_COHERENCE_NONE);
  for (std::size_t i = 0; i < sky_hits.size(); ++i) {
    if (sky_hits[i].geometry.slot != 0) {
      // What is near covers the sky in full, what is at the reach not at all.
      lights[sky_sample[i]].sky -= (1.0 - sky_hits[i].distance / reach.sky) / sky_rays;
    }
  }
  return lights;
}

}  // namespace tools

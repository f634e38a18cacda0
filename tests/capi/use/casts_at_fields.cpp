// SPDX-License-Identifier: Apache-2.0
// Casts against distance fields of noise: whatever the centre of a body flies through deeper than a little stops it.
// Values between samples are found here; cells at the border of the grid are left out, where the border cuts the solid.
#include <cmath>
#include <random>

#include "moving.hpp"

namespace {

using namespace abut_test;

constexpr int side = 8;

struct Noise {
  std::vector<double> values;

  explicit Noise(std::mt19937_64& random) {
    for (int i = 0; i < side * side * side; ++i) values.push_back(double(random() >> 11) * 0x1p-52 - 0.7);
  }
  double sample(int i, int j, int k) const { return values.at(static_cast<std::size_t>((k * side + j) * side + i)); }
  double at(const abut_vec3& p) const {
    const auto cell = [](double x) { return std::clamp(static_cast<int>(x), 0, side - 2); };
    const int i = cell(p.x), j = cell(p.y), k = cell(p.z);
    const double x = p.x - i, y = p.y - j, z = p.z - k;
    const auto along_x = [&](int jj, int kk) { return std::lerp(sample(i, jj, kk), sample(i + 1, jj, kk), x); };
    const auto along_y = [&](int kk) { return std::lerp(along_x(j, kk), along_x(j + 1, kk), y); };
    return std::lerp(along_y(k), along_y(k + 1), z);
  }
};

TEST(CastAtADistanceField, PassesNoPieceOfIt) {
  constexpr std::uint64_t seed = 4;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) { return low + (high - low) * double(random() >> 11) * 0x1p-53; };
  constexpr abut_vec3 none{0, 0, 0};
  const Shape point = make_of_kind("point", {}), ball = make_sphere(0.15);
  int stopped = 0;
  for (int i = 0; i < 200; ++i) {
    const Noise noise(random);
    const Shape field = make_of_kind("distance_field", {side, side, side, 1, 1, 1, 0, 0, 0, 0}, noise.values);
    const auto place = [&] { return abut_vec3{between(1, 6), between(1, 6), between(1, 6)}; };
    const abut_pose start{place(), no_rotation};
    const abut_vec3 way = sum(place(), times(-1, start.position));
    if (noise.at(start.position) < 0.2) continue;
    double deep = 2;
    for (int k = 0; k <= 500 && deep > 1; ++k) {
      const double t = k / 500.0;
      deep = noise.at(sum(start.position, times(t, way))) < -0.02 ? t : deep;
    }
    for (const abut_shape* const body : {static_cast<abut_shape*>(point), static_cast<abut_shape*>(ball)}) {
      abut_cast_hit hit{};
      std::uint32_t found = 0;
      require(abut_pair_cast(body, &start, &way, field, &identity, &none, nullptr, &hit, &found));
      if (deep > 1) continue;
      ASSERT_EQ(found, 1U) << "cast " << i << ", deep at " << deep;
      ASSERT_LE(hit.fraction, deep + 1e-9) << "cast " << i;
      stopped += hit.fraction > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(stopped, 60);
}

}  // namespace

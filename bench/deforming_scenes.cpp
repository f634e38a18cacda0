// SPDX-License-Identifier: Apache-2.0
#include "deforming_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace bench {
namespace {

constexpr std::uint32_t side = 25;  // vertices along each side

// Where a vertex is at a time; u and v run from 0 to 1.
using Place = std::function<Point(double u, double v, double time)>;

std::vector<Point> places(const Place& place, double time, std::uint64_t seed) {
  // No two coordinates agree by construction, so that no answer hangs on rounding.
  Random random(seed);
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      Point p = place(i / (side - 1.0), j / (side - 1.0), time);
      for (double& coordinate : p) {
        coordinate += random.uniform(-5e-4, 5e-4);
      }
      points.push_back(p);
    }
  }
  return points;
}

Deforming sheet(const Place& place, std::size_t step, std::uint64_t seed) {
  Deforming mesh;
  const auto time = static_cast<double>(step);
  mesh.start = places(place, time, seed + step);
  mesh.end = places(place, time + 1, seed + step + 1);
  for (std::uint32_t i = 0; i + 1 < side; ++i) {
    for (std::uint32_t j = 0; j + 1 < side; ++j) {
      const std::uint32_t a = i * side + j, b = a + side;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
      mesh.edges.push_back({a, a + 1});
      mesh.edges.push_back({a, b});
      mesh.edges.push_back({a, b + 1});
    }
  }
  for (std::uint32_t i = 0; i + 1 < side; ++i) {
    const std::uint32_t last = side - 1;
    mesh.edges.push_back({i * side + last, (i + 1) * side + last});
    mesh.edges.push_back({last * side + i, last * side + i + 1});
  }
  std::ranges::sort(mesh.edges);
  return mesh;
}

}  // namespace

DeformingScene sheet_in_folds(std::size_t steps) {
  constexpr double folds = 6;
  const Place place = [](double u, double v, double time) -> Point {
    const double along = folds * u, fold = std::floor(along), rest = along - fold;
    const double up = std::fmod(fold, 2) < 1 ? rest : 1 - rest;
    const double tremble = 0.03 * std::sin(9 * u + 7 * v + 0.8 * time);
    return {0.02 * along + tremble, v, up + 0.2 * tremble};
  };
  DeformingScene scene{"deforming_folds", {}};
  for (std::size_t step = 0; step < steps; ++step) {
    scene.cases.push_back({sheet(place, step, 1000), {}, 0.01});
  }
  return scene;
}

DeformingScene two_sheets(std::size_t steps) {
  const Place below = [](double u, double v, double time) -> Point {
    return {2 * u, 2 * v, 0.1 * std::sin(6 * u + 0.4 * time) * std::cos(5 * v)};
  };
  // From a fifth of the side apart to a twentieth deep.
  const auto last = static_cast<double>(steps > 1 ? steps - 1 : 1);
  const Place above = [last](double u, double v, double time) -> Point {
    const double height = 0.4 - 0.35 * time / last;
    return {2 * u + 0.03, 2 * v + 0.02, height + 0.1 * std::cos(7 * u + 4 * v - 0.5 * time)};
  };
  DeformingScene scene{"deforming_two", {}};
  for (std::size_t step = 0; step < steps; ++step) {
    scene.cases.push_back({sheet(below, step, 2000), sheet(above, step, 3000), 0.05});
  }
  return scene;
}

}  // namespace bench

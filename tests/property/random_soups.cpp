// SPDX-License-Identifier: Apache-2.0
#include "random_soups.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "oracle/overlap.hpp"

namespace property {

bool happens(Random& random, double probability) { return between(random, 0, 1) < probability; }

namespace {

using oracle::Point;
using oracle::Soup;

std::size_t below(Random& random, std::size_t count) { return static_cast<std::size_t>(random() % count); }
std::uint32_t index(std::size_t i) { return static_cast<std::uint32_t>(i); }

}  // namespace

double roughness(Random& random) { return std::array{0.0, 1e-3, 0.05, 0.2}.at(below(random, 4)); }

namespace {

// A sheet about 2 wide.
Soup grid(Random& random) {
  Soup soup;
  const std::size_t columns = 3 + below(random, 4), rows = 3 + below(random, 3);
  const double rough = roughness(random), bend = between(random, -0.5, 0.5);
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const double x = 2 * static_cast<double>(i) / static_cast<double>(columns - 1) - 1;
      const double y = 2 * static_cast<double>(j) / static_cast<double>(rows - 1) - 1;
      soup.points.push_back({x, y, bend * x * x + rough * between(random, -1, 1)});
    }
  }
  for (std::size_t j = 0; j + 1 < rows; ++j) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const std::size_t a = j * columns + i, b = a + 1, c = b + columns, d = a + columns;
      soup.triangles.push_back({index(a), index(b), index(c)});
      soup.triangles.push_back({index(a), index(c), index(d)});
    }
  }
  return soup;
}

// A ball of rings and two poles, with bumps.
Soup blob(Random& random) {
  Soup soup;
  const std::size_t rings = 2 + below(random, 3), around = 4 + below(random, 4);
  const double rough = roughness(random), flat = between(random, 0.4, 1);
  const auto add = [&](double x, double y, double z) {
    const double radius = 1 + rough * between(random, -1, 1);
    soup.points.push_back({radius * x, radius * y, flat * radius * z});
  };
  add(0, 0, -1);
  for (std::size_t j = 0; j < rings; ++j) {
    const double tilt = std::numbers::pi * static_cast<double>(j + 1) / static_cast<double>(rings + 1);
    for (std::size_t i = 0; i < around; ++i) {
      const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around);
      add(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), -std::cos(tilt));
    }
  }
  add(0, 0, 1);
  const auto at = [&](std::size_t ring, std::size_t i) { return index(1 + ring * around + i % around); };
  for (std::size_t i = 0; i < around; ++i) {
    soup.triangles.push_back({0, at(0, i + 1), at(0, i)});
    for (std::size_t j = 0; j + 1 < rings; ++j) {
      soup.triangles.push_back({at(j, i), at(j, i + 1), at(j + 1, i + 1)});
      soup.triangles.push_back({at(j, i), at(j + 1, i + 1), at(j + 1, i)});
    }
    soup.triangles.push_back({index(soup.points.size() - 1), at(rings - 1, i), at(rings - 1, i + 1)});
  }
  return soup;
}

Soup box_of_triangles(Random& random) {
  const double x = between(random, 0.3, 1), y = between(random, 0.3, 1), z = between(random, 0.3, 1);
  return {{{-x, -y, -z}, {x, -y, -z}, {x, y, -z}, {-x, y, -z}, {-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}},
          {{0, 2, 1},
           {0, 3, 2},
           {4, 5, 6},
           {4, 6, 7},
           {0, 1, 5},
           {0, 5, 4},
           {2, 3, 7},
           {2, 7, 6},
           {1, 2, 6},
           {1, 6, 5},
           {3, 0, 4},
           {3, 4, 7}}};
}

// Triangles anywhere, through each other.
Soup scattered(Random& random) {
  Soup soup;
  const std::size_t count = 4 + below(random, 12);
  for (std::size_t i = 0; i < count; ++i) {
    Point middle{};
    for (double& x : middle) x = between(random, -1, 1);
    for (int corner = 0; corner < 3; ++corner) {
      Point p = middle;
      for (double& x : p) x += between(random, -0.5, 0.5);
      soup.points.push_back(p);
    }
    soup.triangles.push_back({index(3 * i), index(3 * i + 1), index(3 * i + 2)});
  }
  return soup;
}

Soup closed(Random& random) { return happens(random, 0.3) ? box_of_triangles(random) : blob(random); }

void make_dirty(Soup& soup, Random& random) {
  std::vector<std::array<std::uint32_t, 3>> dirty;
  for (std::array<std::uint32_t, 3> triangle : soup.triangles) {
    if (happens(random, 0.1)) continue;
    if (happens(random, 0.15)) std::swap(triangle[0], triangle[1]);
    dirty.push_back(triangle);
    if (happens(random, 0.1)) dirty.push_back(triangle);
    if (happens(random, 0.1)) {
      // A sliver along an edge, as far beside it as a millionth of its length.
      const Point &p = soup.points[triangle[0]], &q = soup.points[triangle[1]], &r = soup.points[triangle[2]];
      const Point middle = oracle::sum(oracle::sum({}, p, 0.5), q, 0.5);
      soup.points.push_back(oracle::sum(middle, oracle::sum(r, middle, -1), -1e-6));
      dirty.push_back({triangle[1], triangle[0], index(soup.points.size() - 1)});
    }
  }
  if (!dirty.empty()) soup.triangles = dirty;
}

void scale(Soup& soup, Random& random, double by) {
  const bool as_float = happens(random, 0.5);
  for (Point& p : soup.points) {
    for (double& x : p) x = as_float ? static_cast<double>(static_cast<float>(by * x)) : by * x;
  }
}

}  // namespace

oracle::Soup random_soup(Random& random, double by) {
  const std::size_t choice = below(random, 10);
  Soup soup = choice < 5 ? grid(random) : choice < 8 ? closed(random) : scattered(random);
  if (happens(random, 0.4)) make_dirty(soup, random);
  scale(soup, random, by);
  return soup;
}

oracle::Soup closed_soup(Random& random, double by) {
  Soup soup = closed(random);
  scale(soup, random, by);
  return soup;
}

}  // namespace property

// SPDX-License-Identifier: Apache-2.0
// A sheet of triangles that lies in folds, as a cloth does.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

import abut.math;

namespace abut_test {

struct FoldedSheet {
  std::vector<abut::Vec3> vertices;
  std::vector<std::uint32_t> triangles;
};

// side * side vertices, each moved at random by up to `noise`. Coordinates are multiples of 2^-14, so that sums of a
// few of them are exact in single precision too.
inline FoldedSheet folded_sheet(std::uint32_t side, double noise, std::mt19937& random) {
  FoldedSheet sheet;
  std::uniform_real_distribution<double> share(-noise, noise);
  const auto rounded = [](double value) { return std::ldexp(std::round(std::ldexp(value, 14)), -14); };
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const double along = 5.0 * i / (side - 1), fold = std::floor(along), rest = along - fold;
      const double height = std::fmod(fold, 2) < 1 ? rest : 1 - rest;
      sheet.vertices.push_back({rounded(0.05 * along + share(random)),
                                rounded(static_cast<double>(j) / (side - 1) + share(random)),
                                rounded(height + share(random))});
    }
  }
  for (std::uint32_t i = 0; i + 1 < side; ++i) {
    for (std::uint32_t j = 0; j + 1 < side; ++j) {
      const std::uint32_t a = i * side + j, b = a + side;
      sheet.triangles.insert(sheet.triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  return sheet;
}

// The same sheet with other numbers of vertices, another order of triangles, and other first corners and windings.
// new_number: of each vertex.
inline FoldedSheet renumbered(const FoldedSheet& sheet, std::mt19937& random, std::vector<std::uint32_t>& new_number) {
  new_number.resize(sheet.vertices.size());
  std::iota(new_number.begin(), new_number.end(), 0u);
  const auto shuffle = [&](std::vector<std::uint32_t>& list) {
    for (std::size_t i = list.size(); i > 1; --i) {
      std::swap(list[i - 1], list[random() % i]);
    }
  };
  shuffle(new_number);
  FoldedSheet out;
  out.vertices.resize(sheet.vertices.size());
  for (std::size_t i = 0; i < new_number.size(); ++i) {
    out.vertices[new_number[i]] = sheet.vertices[i];
  }
  std::vector<std::uint32_t> order(sheet.triangles.size() / 3);
  std::iota(order.begin(), order.end(), 0u);
  shuffle(order);
  for (const std::uint32_t triangle : order) {
    const std::size_t turn = random() % 3;
    const bool is_reversed = random() % 2 == 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t corner = (turn + (is_reversed ? 3 - i : i)) % 3;
      out.triangles.push_back(new_number[sheet.triangles[3 * std::size_t{triangle} + corner]]);
    }
  }
  return out;
}

}  // namespace abut_test

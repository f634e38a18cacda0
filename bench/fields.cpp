// SPDX-License-Identifier: Apache-2.0
// Distance fields of a ball of 101,568 triangles: how long they take to be made, and a value with its gradient. At the
// end how much memory a fine one takes.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ratios.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape.field_of_mesh;
import abut.pairs.registry;
import abut.shapes.distance_field;

namespace bench {
namespace {

// A ball of radius one: a cube whose faces are cut into squares, blown up.
struct Ball {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;

  Ball() {
    constexpr std::uint32_t squares = 92;
    for (std::size_t face = 0; face < 6; ++face) {
      const auto first = static_cast<std::uint32_t>(xyz.size() / 3);
      for (std::uint32_t j = 0; j <= squares; ++j) {
        for (std::uint32_t i = 0; i <= squares; ++i) {
          std::array<double, 3> at{};
          at.at(face % 3) = face < 3 ? 1 : -1;
          at.at((face + 1) % 3) = 2.0 * (face < 3 ? i : j) / squares - 1;
          at.at((face + 2) % 3) = 2.0 * (face < 3 ? j : i) / squares - 1;
          const double length = std::sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
          xyz.insert(xyz.end(), {at[0] / length, at[1] / length, at[2] / length});
          if (i < squares && j < squares) {
            const std::uint32_t a = first + j * (squares + 1) + i, b = a + 1, d = a + squares + 1, c = d + 1;
            triangles.insert(triangles.end(), {a, b, c, a, c, d});
          }
        }
      }
    }
  }
};

// The grid goes three cells beyond the triangles on each side.
abut::ShapeHandle made(const Ball& ball, int samples, bool is_smooth) {
  const double spacing = 2.0 / (samples - 7);
  abut::Result<abut::ShapeHandle> field =
      abut::make_field_of_mesh(ball.xyz, ball.triangles, {spacing, 3, false, is_smooth});
  if (!field) {
    throw std::runtime_error(field.error().message);
  }
  return std::move(field).value();
}

void add_build(const std::string& contender, const Ball& ball, bool is_smooth) {
  benchmark::RegisterBenchmark(("128^3 made of 101,568 triangles/" + contender).c_str(), [&ball, is_smooth](
                                                                                             benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
      benchmark::DoNotOptimize(made(ball, 128, is_smooth));
    }
  })->UseRealTime();
}

// Within three cells of the surface: all over it, or one close to the other.
std::vector<abut::Vec3> places(bool are_close) {
  std::mt19937_64 random(7);
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  constexpr std::size_t count = 1000;
  constexpr double band = 3 * 2.0 / 121;
  std::vector<abut::Vec3> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = are_close ? static_cast<double>(i) / count : share();
    const double up = are_close ? 0.1 + 0.1 * place : 2 * share() - 1, along = are_close ? place : 7 * share();
    const double across = std::sqrt(1 - up * up), radius = 1 + band * (2 * share() - 1);
    out.push_back({radius * across * std::cos(along), radius * across * std::sin(along), radius * up});
  }
  return out;
}

void add_queries(const std::string& contender, const abut::DistanceField& field, bool are_close) {
  const std::string cell = are_close ? "1000 values with gradients, close/" : "1000 values with gradients/";
  benchmark::RegisterBenchmark((cell + contender).c_str(), [&field, are_close](benchmark::State& state) {
    const std::vector<abut::Vec3> at = places(are_close);
    for ([[maybe_unused]] auto _ : state) {
      abut::Vec3 sum{0, 0, 0};
      for (const abut::Vec3& place : at) {
        const abut::FieldValue found = field.value_at(place);
        sum += found.value * found.gradient;
      }
      benchmark::DoNotOptimize(sum);
    }
  });
}

double mebibytes_in_use() {
  std::ifstream file("/proc/self/statm");
  double all = 0, resident = 0;
  file >> all >> resident;
  return resident * 4096 / 1048576;
}

void print_memory(const Ball& ball) {
  for (const bool is_smooth : {false, true}) {
    const double before = mebibytes_in_use();
    const auto start = std::chrono::steady_clock::now();
    const abut::ShapeHandle fine = made(ball, 1024, is_smooth);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto& field = std::get<abut::DistanceField>(fine);
    std::printf("1024^3, %s: %zu of %zu blocks hold samples; %.0f MiB, at most %.0f MiB so far; %.1f s\n",
                is_smooth ? "quadratic" : "linear", field.held_blocks(), field.all_blocks(),
                mebibytes_in_use() - before, static_cast<double>(usage.ru_maxrss) / 1024, took.count());
  }
}

int run() {
  const Ball ball;
  const abut::ShapeHandle linear = made(ball, 128, false), smooth = made(ball, 128, true);
  for (const auto& [contender, shape] : {std::pair("linear", &linear), std::pair("quadratic", &smooth)}) {
    add_build(contender, ball, shape == &smooth);
    for (const bool are_close : {false, true}) {
      add_queries(contender, std::get<abut::DistanceField>(*shape), are_close);
    }
  }
  const int status = run_and_compare({"linear", {"quadratic"}, {}, 1, "us", 1e-6});
  if (is_selected("memory")) {
    print_memory(ball);
  }
  return status;
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, bench::run); }

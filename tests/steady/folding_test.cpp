// SPDX-License-Identifier: Apache-2.0
// Sheets that fold, by their vertices, edges and faces: a step asks for no memory once its lists have grown.
#include <cmath>

#include "allocations.hpp"
#include "support.hpp"

namespace {

using namespace abut_test;
using steady::AllocationCounter;
using steady::Allocations;

constexpr std::uint32_t side = 9;
constexpr std::size_t period = 8;

// Waves that run along a sheet, so steep that it comes near itself.
std::vector<double> waves(std::size_t frame) {
  std::vector<double> xyz;
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const double phase = 1.1 * i + 0.785398 * static_cast<double>(frame % period);
      xyz.insert(xyz.end(), {0.03 * i, 0.1 * j, 0.3 * std::sin(phase) + 0.01 * std::cos(j)});
    }
  }
  return xyz;
}

std::vector<std::uint32_t> triangles() {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i + 1 < side; ++i) {
    for (std::uint32_t j = 0; j + 1 < side; ++j) {
      const std::uint32_t first = side * i + j;
      all.insert(all.end(), {first, first + side, first + side + 1, first, first + side + 1, first + 1});
    }
  }
  return all;
}

class SteadyFolds : public testing::TestWithParam<std::uint32_t> {};

TEST_P(SteadyFolds, AskForNothing) {
  for (const abut_geometry_flags flags : {0U, ABUT_GEOMETRY_FAST + 0U}) {
    for (const abut_closest_method method : {ABUT_CLOSEST_FEATURES, ABUT_CLOSEST_LOCAL_MINIMA, ABUT_CLOSEST_OF_FACES}) {
      abut_universe_options options = default_universe_options();
      options.tolerance_mode = ABUT_TOLERANCE_MARGIN;
      options.threads = GetParam();
      Universe universe(&options);
      abut_policy policy = default_policy();
      policy.detail = ABUT_DETAIL_ELEMENTS;
      policy.tolerance = 0.03;
      policy.method = method;
      require(abut_policy_set(universe, 0, 0, &policy));
      abut_geometry_options folding = default_geometry_options();
      folding.flags = ABUT_GEOMETRY_SELF_PAIRS | flags;
      std::array<abut_geometry_id, 2> sheets{};
      for (std::size_t which = 0; which < 2; ++which) {
        const Shape sheet = make_of_kind("mesh", {0}, waves(which), triangles());
        sheets.at(which) =
            universe.add_geometry(universe.add_part(at(0.01 * static_cast<double>(which), 0, 0)), sheet, folding);
      }
      std::vector<std::vector<double>> frames;
      for (std::size_t frame = 0; frame < period; ++frame) frames.push_back(waves(frame));
      std::size_t most = 0;
      // What the step asks for; an edit may ask for words of its call.
      const auto step = [&](std::size_t frame) {
        // The second one rests in every third frame.
        for (std::size_t which = 0; which < (frame % 3 == 0 ? 1U : 2U); ++which) {
          const std::vector<double>& xyz = frames[(frame + which) % period];
          require(abut_geometry_set_vertices(universe, sheets.at(which), 0, xyz.data(), xyz.size() / 3));
        }
        AllocationCounter counter;
        require(abut_universe_step(universe, 0.01));
        const abut_element_contact* contacts = nullptr;
        std::size_t count = 0;
        require(abut_universe_element_contacts(universe, &contacts, &count));
        most = std::max(most, count);
        return counter.stop();
      };
      for (std::size_t frame = 0; frame < 4 * period; ++frame) step(frame);
      EXPECT_GT(most, 50U) << "sheets that are not near show nothing";
      for (std::size_t frame = 0; frame < period; ++frame) {
        const Allocations found = step(frame);
        EXPECT_EQ(found.calls, 0U) << "method " << method << ", flags " << flags << found.first_places;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, SteadyFolds, testing::Values(1U, 3U));

}  // namespace

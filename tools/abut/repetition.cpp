// SPDX-License-Identifier: Apache-2.0
#include "repetition.hpp"

#include <array>

#include "common/random.hpp"
#include "turn.hpp"

namespace cli {
namespace {

constexpr std::uint64_t most_copies = 10'000'000;

void check_finite(const Node& node, const abut_vec3& position) {
  if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z)) {
    node.refuse("numbers that keep all copies within what a number can hold");
  }
}

std::string index_text(std::uint64_t index) { return "[" + std::to_string(index) + "]"; }

std::array<std::uint64_t, 3> read_counts(const Node& node) {
  if (!node.is_list() || node.size() != 3) {
    node.refuse("three whole numbers, [along x, along y, along z]");
  }
  const std::vector<Node> axes = node.list("counts");
  const std::array<std::uint64_t, 3> counts{axes[0].whole(1, most_copies), axes[1].whole(1, most_copies),
                                            axes[2].whole(1, most_copies)};
  if (counts[0] * counts[1] > most_copies || counts[0] * counts[1] * counts[2] > most_copies) {
    node.refuse("at most " + std::to_string(most_copies) + " copies");
  }
  return counts;
}

// Copies stand beside each other along the axes of the world.
std::vector<Copy> grid(const Node& node, const abut_pose& pose) {
  Fields fields(node);
  const auto counts = read_counts(fields.need("count"));
  const abut_vec3 spacing = fields.need("spacing").vector();
  const auto centred = fields.find("centred");
  fields.done();
  const auto last = [&](std::size_t axis) { return static_cast<double>(counts[axis] - 1); };
  const abut_vec3 extent{spacing.x * last(0), spacing.y * last(1), spacing.z * last(2)};
  const abut_vec3 start = centred && centred->flag() ? pose.position - extent * 0.5 : pose.position;
  check_finite(node, start);
  check_finite(node, start + extent);
  std::vector<Copy> copies;
  copies.reserve(counts[0] * counts[1] * counts[2]);
  for (std::uint64_t k = 0; k < counts[2]; ++k) {
    for (std::uint64_t j = 0; j < counts[1]; ++j) {
      for (std::uint64_t i = 0; i < counts[0]; ++i) {
        const abut_vec3 offset{spacing.x * static_cast<double>(i), spacing.y * static_cast<double>(j),
                               spacing.z * static_cast<double>(k)};
        copies.push_back({index_text(i) + index_text(j) + index_text(k), {start + offset, pose.orientation}});
      }
    }
  }
  return copies;
}

// Every orientation is as likely as any other: a point in the unit ball of four dimensions, brought to its surface.
abut_quat any_orientation(Random& random) {
  for (;;) {
    const double w = random.uniform(-1.0, 1.0);
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    const double z = random.uniform(-1.0, 1.0);
    const abut_quat q{w, x, y, z};
    if (const double size = norm(q); size > 0.1 && size <= 1.0) {
      return unit(q);
    }
  }
}

// Copies anywhere in a box around the position of the part.
std::vector<Copy> scatter(const Node& node, const abut_pose& pose) {
  Fields fields(node);
  const std::uint64_t count = fields.need("count").whole(1, most_copies);
  Random random(fields.need("seed").whole(0, UINT64_MAX));
  const abut_vec3 low = fields.need("minimum").vector();
  const Node high_node = fields.need("maximum");
  const abut_vec3 high = high_node.vector();
  const auto turned = fields.find("turned");
  const bool turn = turned && turned->flag();
  fields.done();
  if (high.x < low.x || high.y < low.y || high.z < low.z) {
    high_node.refuse("a corner that is not below \"minimum\" in any direction");
  }
  check_finite(node, high - low);
  check_finite(node, pose.position + low);
  check_finite(node, pose.position + high);
  std::vector<Copy> copies;
  copies.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double x = random.uniform(low.x, high.x);
    const double y = random.uniform(low.y, high.y);
    const double z = random.uniform(low.z, high.z);
    const abut_quat orientation = turn ? any_orientation(random) : pose.orientation;
    copies.push_back({index_text(i), {pose.position + abut_vec3{x, y, z}, orientation}});
  }
  return copies;
}

}  // namespace

std::vector<Copy> read_copies(Fields& fields, const abut_pose& pose) {
  const auto grid_node = fields.find("grid");
  const auto scatter_node = fields.find("scatter");
  if (grid_node && scatter_node) {
    scatter_node->refuse("either a grid or a scatter, not both");
  }
  if (grid_node) {
    return grid(*grid_node, pose);
  }
  if (scatter_node) {
    return scatter(*scatter_node, pose);
  }
  return {{"", pose}};
}

}  // namespace cli

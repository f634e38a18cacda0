// SPDX-License-Identifier: Apache-2.0
#include "near_pairs.hpp"

#include <algorithm>

namespace cli {
namespace {

struct Box {
  std::size_t geometry;
  abut_aabb bounds;
};

bool overlap(const abut_aabb& a, const abut_aabb& b) {
  const auto along = [&](double abut_vec3::* axis) {
    return a.minimum.*axis <= b.maximum.*axis && b.minimum.*axis <= a.maximum.*axis;
  };
  return along(&abut_vec3::x) && along(&abut_vec3::y) && along(&abut_vec3::z);
}

// By how much boxes grow so that all whom the tolerances let meet overlap.
double growth(const Scene& scene, const Geometry& geometry) {
  if (scene.universe.tolerance_mode != ABUT_TOLERANCE_MARGIN) {
    return 0.0;
  }
  double most = geometry.options.tolerance;
  for (const Policy& policy : scene.policies) {
    most = std::max(most, policy.policy.tolerance);
  }
  return most;
}

std::vector<Box> boxes_of(const World& world) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < world.scene().geometries.size(); ++i) {
    const Geometry& geometry = world.scene().geometries[i];
    const abut_pose pose = world.pose_of(i);
    abut_aabb box;
    check(abut_shape_aabb(world.shape_of(i), &pose, &box), "box of a geometry");
    const double by = growth(world.scene(), geometry);
    boxes.push_back({i, {box.minimum - abut_vec3{by, by, by}, box.maximum + abut_vec3{by, by, by}}});
  }
  return boxes;
}

}  // namespace

std::vector<NumberPair> near_pairs(const World& world) {
  std::vector<Box> boxes = boxes_of(world);
  std::ranges::sort(boxes, {}, [](const Box& box) { return std::pair(box.bounds.minimum.x, box.geometry); });
  std::vector<NumberPair> pairs;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].bounds.minimum.x <= boxes[i].bounds.maximum.x; ++j) {
      if (overlap(boxes[i].bounds, boxes[j].bounds)) {
        pairs.emplace_back(std::minmax(boxes[i].geometry, boxes[j].geometry));
      }
    }
  }
  // Fast and speculative geometries touch what their boxes at the end of a step do not reach.
  for (const abut_contact& contact : contacts_of(world.universe())) {
    pairs.emplace_back(std::minmax(world.number_of(contact.geometry_a), world.number_of(contact.geometry_b)));
  }
  for (const abut_element_contact& contact : world.element_contacts()) {
    pairs.emplace_back(std::minmax(world.number_of(contact.geometry_a), world.number_of(contact.geometry_b)));
  }
  std::ranges::sort(pairs);
  const auto repeated = std::ranges::unique(pairs);
  pairs.erase(repeated.begin(), repeated.end());
  // A mesh that meets itself is no pair of two.
  std::erase_if(pairs, [](const NumberPair& pair) { return pair.first == pair.second; });
  return pairs;
}

std::vector<KeptApart> kept_apart(const World& world) {
  const Gates gates(world);
  std::vector<KeptApart> kept;
  for (const std::string_view name : Gates::names()) {
    kept.push_back({name, 0, {}});
  }
  for (const NumberPair& pair : near_pairs(world)) {
    const auto gate = gates.closed(pair.first, pair.second);
    if (const auto its = std::ranges::find(kept, gate, &KeptApart::gate); its != kept.end()) {
      its->example = its->pairs == 0 ? pair : its->example;
      ++its->pairs;
    }
  }
  std::erase_if(kept, [](const KeptApart& its) { return its.pairs == 0; });
  return kept;
}

}  // namespace cli

// SPDX-License-Identifier: Apache-2.0
// Manifolds of bodies in a bumpy mesh: patches are few, stay as many where the body moves by a nanometre, and keep the
// deepest contact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "floors.hpp"
#include "scenes.hpp"
#include "shortfall.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::between;
using property::Random;
using property::ShapePtr;

constexpr double same_patch_cosine = 0.98;
constexpr abut_pose here{{0, 0, 0}, {1, 0, 0, 0}};

std::vector<abut_contact> contacts_of(const ShapePtr& mesh, const ShapePtr& body, const abut_pose& pose,
                                      bool is_reduced) {
  std::vector<abut_contact> contacts(800);
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  if (!is_reduced) options.max_contacts = 0;
  std::size_t found = 0;
  EXPECT_EQ(
      abut_pair_contacts(mesh.get(), &here, body.get(), &pose, &options, contacts.data(), contacts.size(), &found),
      ABUT_OK);
  EXPECT_LE(found, contacts.size());
  contacts.resize(std::min(found, contacts.size()));
  return contacts;
}

// Contacts come deepest first, and so do the first ones of the patches.
std::size_t patches_in(const std::vector<abut_contact>& contacts) {
  std::vector<abut_vec3> heads;
  for (const abut_contact& contact : contacts) {
    const abut_vec3& n = contact.normal;
    const bool is_known = std::any_of(heads.begin(), heads.end(), [&](const abut_vec3& head) {
      return head.x * n.x + head.y * n.y + head.z * n.z >= same_patch_cosine;
    });
    if (!is_known) heads.push_back(n);
  }
  return heads.size();
}

void check_patches(const ShapePtr& body, std::size_t most_patches, std::uint64_t seed) {
  const ShapePtr mesh = property::mesh_of(property::soup_of({20, 0.25, 0.05, false}, seed), ABUT_SIDES_BOTH);
  Random random(seed);
  int touching = 0;
  for (int place = 0; place < 150; ++place) {
    const abut_pose pose{{between(random, -1, 1), between(random, -1, 1), between(random, 0.05, 0.45)},
                         property::random_orientation(random)};
    const auto reduced = contacts_of(mesh, body, pose, true), all = contacts_of(mesh, body, pose, false);
    if (all.empty()) continue;
    ++touching;
    ASSERT_FALSE(reduced.empty());
    EXPECT_EQ(reduced.front().distance, all.front().distance) << property::text_of(pose);
    EXPECT_LE(patches_in(reduced), most_patches) << property::text_of(pose);
    for (int jitter = 0; jitter < 8; ++jitter) {
      abut_pose moved = pose;
      moved.position = property::moved(pose.position, property::random_direction(random), 1e-9);
      EXPECT_EQ(patches_in(contacts_of(mesh, body, moved, true)), patches_in(reduced)) << property::text_of(moved);
    }
  }
  EXPECT_GT(touching, 50) << "seed " << seed;
}

TEST(Patches, AreFewAndStable) {
  abut_shape* shape = nullptr;
  ASSERT_EQ(abut_box_create(0.4, 0.3, 0.2, &shape), ABUT_OK);
  check_patches(ShapePtr(shape), 12, 3);
  ASSERT_EQ(abut_sphere_create(0.4, &shape), ABUT_OK);
  check_patches(ShapePtr(shape), 4, 4);  // three planes, and the translation that leaves all
  ASSERT_EQ(abut_cylinder_create(0.25, 0.35, &shape), ABUT_OK);
  check_patches(ShapePtr(shape), 12, 5);
}

}  // namespace

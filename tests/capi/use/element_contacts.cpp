// SPDX-License-Identifier: Apache-2.0
// Element contacts of a universe: closest features of meshes that deform, against all pairs in more digits.
#include "element_contacts.hpp"

#include <cstring>

namespace {

using namespace abut_test;

constexpr double reach = 0.08;

void expect_all_pairs(const std::vector<abut_stencil>& stencils, const Surface& a, const Surface& b) {
  Told wanted = near_edges(a, b, reach);
  for (const NearVertex& its : near_vertices(a, b, reach)) wanted[its.features] = double(its.distance);
  expect_same(told(stencils), wanted);
  EXPECT_GT(wanted.size(), 50U);
}

// The same surface at a pose, in more digits.
Surface placed(const Surface& mesh, const abut_pose& pose) {
  const auto [w, x, y, z] = pose.orientation;
  const std::array<Wide3, 3> rows{
      Wide3{1 - 2 * (Wide(y) * y + Wide(z) * z), 2 * (Wide(x) * y - Wide(w) * z), 2 * (Wide(x) * z + Wide(w) * y)},
      Wide3{2 * (Wide(x) * y + Wide(w) * z), 1 - 2 * (Wide(x) * x + Wide(z) * z), 2 * (Wide(y) * z - Wide(w) * x)},
      Wide3{2 * (Wide(x) * z - Wide(w) * y), 2 * (Wide(y) * z + Wide(w) * x), 1 - 2 * (Wide(x) * x + Wide(y) * y)}};
  const Wide3 position{pose.position.x, pose.position.y, pose.position.z};
  Surface out = mesh;
  for (std::uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      out.xyz.at(3 * vertex + axis) = double(product(rows.at(axis), mesh.vertex(vertex)) + position.at(axis));
  }
  return out;
}

TEST(ElementContacts, OfASheetWithItselfAreThoseOfAllPairs) {
  for (const unsigned seed : {1U, 2U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    Surface mesh = folded_surface(12, 0.02, random);
    Cloths cloths(elements_policy(reach, ABUT_CLOSEST_ALL));
    cloths.add(mesh, ABUT_GEOMETRY_SELF_PAIRS);
    for (int frame = 0; frame < 3; ++frame) {
      cloths.step();
      expect_all_pairs(cloths.stencils(0, 0), mesh, mesh);
      mesh.xyz = moved(mesh, 0.02, random);
      cloths.move(0, mesh.xyz);
    }
  }
}

TEST(ElementContacts, OfTwoSheetsAreThoseOfAllPairs) {
  for (const unsigned seed : {1U, 2U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::array<Surface, 2> meshes{folded_surface(9, 0.03, random), folded_surface(10, 0.03, random)};
    const std::array<abut_pose, 2> poses{abut_pose{{3, 1, -2}, {0.8, 0, 0.6, 0}},
                                         abut_pose{{3.05, 1.02, -2}, {0.8, 0, 0.6, 0}}};
    Cloths cloths(elements_policy(reach, ABUT_CLOSEST_ALL));
    for (std::size_t which = 0; which < 2; ++which) cloths.add(meshes.at(which), 0, poses.at(which));
    for (int frame = 0; frame < 3; ++frame) {
      cloths.step();
      expect_all_pairs(cloths.stencils(0, 1), placed(meshes[0], poses[0]), placed(meshes[1], poses[1]));
      const std::size_t which = frame == 0 ? 1 : 0;
      meshes.at(which).xyz = moved(meshes.at(which), 0.02, random);
      cloths.move(which, meshes.at(which).xyz);
    }
  }
}

// Whatever the method and its fields say, a step answers as a search of the same elements does.
TEST(ElementContacts, AreThoseOfASearchByAnyMethod) {
  std::mt19937 random(3);
  const Surface rest = folded_surface(15, 0.002, random);
  const std::vector<double> later = moved(rest, 0.03, random);
  for (const abut_closest_method method : {ABUT_CLOSEST_FEATURES, ABUT_CLOSEST_OF_FACES, ABUT_CLOSEST_ALL,
                                           ABUT_CLOSEST_OF_VERTICES, ABUT_CLOSEST_LOCAL_MINIMA}) {
    SCOPED_TRACE(testing::Message() << "method " << method);
    auto options = elements_options(reach, method);
    options.rest_distance = 0.09;
    options.kinds = method == ABUT_CLOSEST_ALL ? 1U << ABUT_STENCIL_EDGE_EDGE : 0;
    options.cone_angle = 0.25;
    options.cone_factor = 0;
    options.flags = ABUT_ELEMENTS_FRONTS_ONLY;
    const ElementsOf elements(rest);
    require(abut_elements_set_vertices(elements, later.data(), nullptr, rest.vertex_count()));
    const auto wanted = closest_of(elements, nullptr, options);
    if (method == ABUT_CLOSEST_LOCAL_MINIMA) {
      auto others = options;
      std::swap(others.cone_angle, others.cone_factor);
      EXPECT_NE(closest_of(elements, nullptr, others).size(), wanted.size()) << "cones that show nothing";
    }

    abut_policy policy = elements_policy(reach, method);
    policy.rest_distance = options.rest_distance;
    policy.kinds = options.kinds;
    policy.cone_angle = options.cone_angle;
    policy.cone_factor = options.cone_factor;
    policy.flags = options.flags;
    policy.contact_distance = 0.03125;
    Cloths cloths(policy);
    cloths.add(rest, ABUT_GEOMETRY_SELF_PAIRS);
    cloths.step();
    cloths.move(0, later);
    cloths.step();
    const auto got = cloths.stencils(0, 0);
    ASSERT_EQ(got.size(), wanted.size());
    EXPECT_FALSE(got.empty());
    EXPECT_EQ(std::memcmp(got.data(), wanted.data(), got.size() * sizeof(abut_stencil)), 0);
    for (const abut_element_contact& its : cloths.contacts()) EXPECT_EQ(its.gap, its.stencil.distance - 0.03125);

    abut_policy found = default_policy();
    require(abut_policy_get(cloths.universe(), 0, 0, &found));
    EXPECT_EQ(std::memcmp(&found, &policy, sizeof found), 0);
  }
}

TEST(ElementContacts, RenumberingChangesNoDistance) {
  std::mt19937 random(7);
  const Surface mesh = folded_surface(14, 0.01, random);
  std::vector<std::uint32_t> number(mesh.vertex_count());
  for (std::uint32_t i = 0; i < number.size(); ++i) number[i] = i;
  std::shuffle(number.begin(), number.end(), random);
  Surface other{std::vector<double>(mesh.xyz.size()), {}};
  for (std::size_t i = 0; i < number.size(); ++i)
    std::copy_n(mesh.xyz.begin() + long(3 * i), 3, other.xyz.begin() + long(3 * number[i]));
  for (std::uint32_t face = std::uint32_t(mesh.face_count()); face-- > 0;) {
    const auto [a, b, c] = mesh.face(face);
    other.triangles.insert(other.triangles.end(), {number[c], number[b], number[a]});
  }
  const auto told_of = [&](const Surface& its, bool is_renumbered) {
    Cloths cloths(elements_policy(reach));
    cloths.add(its, ABUT_GEOMETRY_SELF_PAIRS);
    cloths.step();
    std::set<std::tuple<std::set<std::uint32_t>, std::uint32_t, double>> out;
    for (const abut_stencil& stencil : cloths.stencils(0, 0)) {
      std::set<std::uint32_t> vertices;
      for (const std::uint32_t vertex : stencil.vertices) vertices.insert(is_renumbered ? vertex : number[vertex]);
      out.insert({vertices, stencil.kind, stencil.distance});
    }
    return out;
  };
  EXPECT_GT(told_of(mesh, false).size(), 50U);
  EXPECT_EQ(told_of(mesh, false), told_of(other, true));
}

// But for their ages.
bool have_same_bits(std::vector<abut_element_contact> a, std::vector<abut_element_contact> b) {
  for (abut_element_contact& its : a) its.age = 0;
  for (abut_element_contact& its : b) its.age = 0;
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(abut_element_contact)) == 0);
}

// A sheet that folds, one that rests beside another one, and a ball that falls through all.
TEST(ElementContacts, AtRestAreKept) {
  std::mt19937 random(4);
  const Surface mesh = folded_surface(10, 0.02, random);
  Cloths cloths(elements_policy(reach));
  for (int i = 0; i < 3; ++i) cloths.add(mesh, ABUT_GEOMETRY_SELF_PAIRS, at(0.05 * i, 0, 0));
  cloths.step();
  const auto first = cloths.contacts();
  EXPECT_EQ(cloths.universe().stats().examined_pairs, 6U);
  cloths.step();
  EXPECT_EQ(cloths.universe().stats().examined_pairs, 0U);
  EXPECT_TRUE(have_same_bits(cloths.contacts(), first));
  // One moves: its own pair and both others are found anew, those of the two that rest are kept.
  cloths.move(1, moved(mesh, 0.01, random));
  cloths.step();
  EXPECT_EQ(cloths.universe().stats().examined_pairs, 3U);
  const auto later = cloths.contacts();
  EXPECT_FALSE(have_same_bits(later, first));
  const auto of_resting = [&](const std::vector<abut_element_contact>& all) {
    std::vector<abut_element_contact> out;
    std::copy_if(all.begin(), all.end(), std::back_inserter(out), [&](const auto& its) {
      return its.geometry_a != cloths.geometry(1) && its.geometry_b != cloths.geometry(1);
    });
    return out;
  };
  EXPECT_FALSE(of_resting(first).empty());
  EXPECT_TRUE(have_same_bits(of_resting(later), of_resting(first)));
  // And as if all were new.
  require(abut_universe_detect_all(cloths.universe()));
  EXPECT_EQ(cloths.universe().stats().examined_pairs, 6U);
  EXPECT_TRUE(have_same_bits(cloths.contacts(), later));
  EXPECT_TRUE(cloths.universe().contacts().empty());
}

// The id of two features is the same from frame to frame, and no two features of a pair have the same.
TEST(ElementContacts, HaveIdsThatStay) {
  std::mt19937 random(5);
  Surface mesh = folded_surface(12, 0.02, random);
  Cloths cloths(elements_policy(reach));
  cloths.add(mesh, ABUT_GEOMETRY_SELF_PAIRS);
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;
  std::map<std::uint64_t, Key> features;
  std::size_t seen_again = 0;
  for (int frame = 0; frame < 4; ++frame) {
    cloths.step();
    std::set<std::uint64_t> ids;
    for (const abut_element_contact& its : cloths.contacts()) {
      EXPECT_TRUE(ids.insert(its.id).second) << "twice in a step";
      const Key key{its.stencil.kind, its.stencil.of_a, its.stencil.element_a, its.stencil.element_b};
      const auto [place, is_new] = features.emplace(its.id, key);
      EXPECT_EQ(place->second, key);
      seen_again += is_new ? 0 : 1;
    }
    mesh.xyz = moved(mesh, 0.005, random);
    cloths.move(0, mesh.xyz);
  }
  EXPECT_GT(seen_again, 100U);
}

TEST(ElementContacts, BeginAndEndWithTheirPair) {
  std::mt19937 random(6);
  const Surface mesh = folded_surface(6, 0.01, random);
  Cloths cloths(elements_policy(reach));
  cloths.add(mesh);
  cloths.add(mesh, 0, at(5, 0, 0));
  cloths.step();
  EXPECT_TRUE(cloths.universe().events().empty());
  cloths.universe().move(cloths.part(1), at(0.3, 0, 0));
  cloths.step();
  const auto begun = cloths.universe().events();
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_EQ(begun[0].kind, abut_event_kind{ABUT_EVENT_BEGIN});
  EXPECT_EQ(begun[0].contact_count, 0U);
  EXPECT_FALSE(cloths.contacts().empty());
  EXPECT_EQ(cloths.universe().stats().touching_pairs, 1U);
  cloths.step();
  EXPECT_EQ(letters_of(cloths.universe().events()), "p");
  // Near, but too far to touch; then out of reach of boxes.
  cloths.universe().move(cloths.part(1), at(0.45, 0, 0));
  cloths.step();
  EXPECT_EQ(letters_of(cloths.universe().events()), "e");
  EXPECT_TRUE(cloths.contacts().empty());
  cloths.universe().move(cloths.part(1), at(0.3, 0, 0));
  cloths.step();
  EXPECT_EQ(letters_of(cloths.universe().events()), "b");
  require(abut_geometry_destroy(cloths.universe(), cloths.geometry(1)));
  cloths.step();
  EXPECT_EQ(letters_of(cloths.universe().events()), "e");
  EXPECT_TRUE(cloths.contacts().empty());
}

TEST(ElementContacts, FollowThePolicy) {
  std::mt19937 random(8);
  const Surface mesh = folded_surface(8, 0.02, random);
  Cloths cloths(elements_policy(reach));
  for (int i = 0; i < 2; ++i) cloths.add(mesh, 0, at(0.05 * i, 0, 0));
  cloths.step();
  const auto first = cloths.contacts();
  EXPECT_FALSE(first.empty());
  EXPECT_TRUE(cloths.universe().contacts().empty());
  abut_policy manifold = default_policy();
  manifold.tolerance = reach;
  cloths.set_policy(manifold);
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty());
  EXPECT_FALSE(cloths.universe().contacts().empty());
  EXPECT_EQ(letters_of(cloths.universe().events()), "p");
  cloths.set_policy(elements_policy(reach));
  cloths.step();
  EXPECT_TRUE(have_same_bits(cloths.contacts(), first));
  EXPECT_TRUE(cloths.universe().contacts().empty());
  // Half as far: those that are that near.
  cloths.set_policy(elements_policy(reach / 2));
  cloths.step();
  const auto near = cloths.contacts();
  EXPECT_LT(near.size(), first.size());
  for (const abut_element_contact& its : near) EXPECT_LE(its.stencil.distance, reach / 2);
}

// A ball has no triangles: it has contacts with the sheet, as without the policy. A box has some.
TEST(ElementContacts, AreOfShapesWithTriangles) {
  std::mt19937 random(9);
  Surface ground{{-1, -1, 0, 2, -1, 0, -1, 2, 0}, {0, 1, 2}};
  Cloths cloths(elements_policy(0.25));
  cloths.add(ground);
  const Shape ball = make_sphere(0.5), box = make_box(0.25, 0.25, 0.5);
  const abut_geometry_id of_ball = cloths.universe().add(ball, at(0.5, -0.5, 0.625)),
                         of_box = cloths.universe().add(box, at(-0.5, -0.25, 0.625));
  cloths.step();
  const auto contacts = cloths.universe().contacts();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_TRUE(contacts[0].geometry_b == of_ball);
  EXPECT_EQ(contacts[0].distance, 0.125);
  const auto found = cloths.contacts();
  EXPECT_GE(found.size(), 4U);
  for (const abut_element_contact& its : found) {
    EXPECT_TRUE(its.geometry_a == cloths.geometry(0) && its.geometry_b == of_box);
    EXPECT_EQ(its.stencil.distance, 0.125);
    EXPECT_EQ(its.stencil.normal.z, 1);
  }
}

// Triangles that go take their features along. Another shape is another mesh, with another rest shape.
TEST(ElementContacts, FollowEditsOfTheMesh) {
  std::mt19937 random(10);
  Surface mesh = folded_surface(10, 0.02, random);
  Cloths cloths(elements_policy(reach, ABUT_CLOSEST_ALL));
  cloths.add(mesh, ABUT_GEOMETRY_SELF_PAIRS);
  cloths.step();
  const std::array<std::uint32_t, 3> gone{5, 40, 41};
  require(abut_geometry_remove_triangles(cloths.universe(), cloths.geometry(0), gone.data(), gone.size()));
  for (const std::uint32_t triangle : gone) {
    for (std::size_t corner = 0; corner < 3; ++corner)
      mesh.triangles.at(3 * triangle + corner) = mesh.triangles.at(3 * triangle);
  }
  cloths.step();
  expect_all_pairs(cloths.stencils(0, 0), mesh, mesh);
  const Surface other = folded_surface(11, 0.02, random);
  require(abut_geometry_set_shape(cloths.universe(), cloths.geometry(0), shape_of(other)));
  cloths.step();
  expect_all_pairs(cloths.stencils(0, 0), other, other);
  abut_policy policy = elements_policy(reach, ABUT_CLOSEST_ALL);
  policy.rest_distance = 2 * reach;
  cloths.set_policy(policy);
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty()) << "all that is near is so at rest";
}

TEST(ElementContacts, ThreadsChangeNoBit) {
  std::array<std::uint64_t, 2> hashes{};
  for (const std::uint32_t threads : {1U, 4U}) {
    std::mt19937 random(11);
    Surface mesh = folded_surface(40, 0.005, random);
    Cloths cloths(elements_policy(0.03), threads);
    cloths.add(mesh, ABUT_GEOMETRY_SELF_PAIRS | ABUT_GEOMETRY_FAST);
    cloths.add(mesh, ABUT_GEOMETRY_SELF_PAIRS, at(0.02, 0, 0));
    for (std::uint32_t frame = 0; frame < 3; ++frame) {
      cloths.step();
      mesh.xyz = moved(mesh, 0.004, random);
      cloths.move(0, mesh.xyz);
      EXPECT_FALSE(cloths.stencils(1, 1).empty());
      hashes.at(threads == 1 ? 0 : 1) ^= cloths.universe().hash() + frame;
    }
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

// The hash tells a contact that is elsewhere, and one that differs by its number or its gap alone.
TEST(ElementContacts, AreInTheHash) {
  std::mt19937 random(12);
  const Surface mesh = folded_surface(6, 0.01, random);
  const auto hash_at = [&](double x) {
    Cloths cloths(elements_policy(reach));
    cloths.add(mesh);
    cloths.add(mesh, 0, at(x, 0, 0));
    cloths.step();
    EXPECT_FALSE(cloths.contacts().empty());
    return cloths.universe().hash();
  };
  EXPECT_EQ(hash_at(0.25), hash_at(0.25));
  EXPECT_NE(hash_at(0.25), hash_at(0.2500001));
  const auto hash_of = [&](const Surface& below, double contact_distance) {
    abut_policy policy = elements_policy(0.25);
    policy.contact_distance = contact_distance;
    Cloths cloths(policy);
    cloths.add(below);
    cloths.add(tip_at(0, 0, 0.125));
    cloths.step();
    EXPECT_EQ(cloths.contacts().size(), 1U);
    return cloths.universe().hash();
  };
  Surface two = ground, swapped = ground;
  two.triangles = {0, 1, 2, 0, 0, 0};
  swapped.triangles = {0, 0, 0, 0, 1, 2};
  EXPECT_EQ(hash_of(two, 0), hash_of(two, 0));
  EXPECT_NE(hash_of(two, 0), hash_of(swapped, 0));
  EXPECT_NE(hash_of(two, 0), hash_of(two, 0.0625));
}

}  // namespace

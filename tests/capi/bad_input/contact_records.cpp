// SPDX-License-Identifier: Apache-2.0
// What abut_contact_validate and abut_universe_local_points refuse.
#include <limits>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

abut_contact good_contact() {
  const Shape ball = make_sphere(1);
  const abut_pose here = at(0, 0, 0), there = at(1, 0.5, 0.25);
  abut_contact contact{};
  std::size_t count = 0;
  require(abut_pair_contacts(ball, &here, ball, &there, nullptr, &contact, 1, &count));
  return contact;
}

template <class Change>
testing::AssertionResult refuses(Change&& change, abut_status status, std::initializer_list<std::string_view> words) {
  abut_contact contact = good_contact();
  change(contact);
  return refused(abut_contact_validate(&contact), status, words);
}

TEST(ContactValidate, AcceptsAContactOfAPair) {
  const abut_contact contact = good_contact();
  EXPECT_TRUE(succeeded(abut_contact_validate(&contact)));
}

TEST(ContactValidate, RefusesNonFiniteNumbers) {
  EXPECT_TRUE(refuses([](abut_contact& c) { c.point_a.y = nan; }, ABUT_NOT_FINITE, {"contact.point_a.y", "nan"}));
  EXPECT_TRUE(refuses([](abut_contact& c) { c.point_b.x = infinity; }, ABUT_NOT_FINITE, {"contact.point_b.x", "inf"}));
  EXPECT_TRUE(refuses([](abut_contact& c) { c.normal.z = nan; }, ABUT_NOT_FINITE, {"contact.normal.z", "nan"}));
  EXPECT_TRUE(refuses([](abut_contact& c) { c.tangent.x = nan; }, ABUT_NOT_FINITE, {"contact.tangent.x", "nan"}));
  EXPECT_TRUE(refuses([](abut_contact& c) { c.distance = nan; }, ABUT_NOT_FINITE, {"contact.distance", "nan"}));
  EXPECT_TRUE(refuses([](abut_contact& c) { c.toi = nan; }, ABUT_NOT_FINITE, {"contact.toi", "nan"}));
  EXPECT_TRUE(
      refuses([](abut_contact& c) { c.point_a.x = 1e71; }, ABUT_OUT_OF_RANGE, {"contact.point_a.x", "1e+71", "1e70"}));
}

TEST(ContactValidate, RefusesDirectionsThatAreNoFrame) {
  EXPECT_TRUE(
      refuses([](abut_contact& c) { c.normal = {0, 0, 2}; }, ABUT_INVALID_ARGUMENT, {"contact.normal", "length 2"}));
  EXPECT_TRUE(
      refuses([](abut_contact& c) { c.normal = {0, 0, 0}; }, ABUT_INVALID_ARGUMENT, {"contact.normal", "length 0"}));
  EXPECT_TRUE(refuses([](abut_contact& c) { c.tangent = {0, 0.5, 0}; }, ABUT_INVALID_ARGUMENT,
                      {"contact.tangent", "length 0.5"}));
  EXPECT_TRUE(refuses([](abut_contact& c) { c.tangent = c.normal; }, ABUT_INVALID_ARGUMENT,
                      {"contact.tangent", "contact.normal", "it must be 0"}));
}

TEST(ContactValidate, RefusesADistanceOfOtherPoints) {
  EXPECT_TRUE(refuses([](abut_contact& c) { c.distance = 0.125; }, ABUT_INVALID_ARGUMENT,
                      {"contact.distance", "0.125", "dot(point_b - point_a, normal)"}));
  EXPECT_TRUE(refuses([](abut_contact& c) { c.normal = {-c.normal.x, -c.normal.y, -c.normal.z}; },
                      ABUT_INVALID_ARGUMENT, {"contact.distance"}));
}

TEST(ContactValidate, RefusesTimesOutsideTheStep) {
  EXPECT_TRUE(refuses([](abut_contact& c) { c.toi = -0.5; }, ABUT_OUT_OF_RANGE, {"contact.toi", "-0.5"}));
  EXPECT_TRUE(refuses([](abut_contact& c) { c.toi = 1.5; }, ABUT_OUT_OF_RANGE, {"contact.toi", "1.5"}));
}

TEST(ContactValidate, RefusesUnknownWords) {
  EXPECT_TRUE(
      refuses([](abut_contact& c) { c.feature_a.kind = 6; }, ABUT_UNKNOWN_VALUE, {"contact.feature_a.kind", "6"}));
  EXPECT_TRUE(
      refuses([](abut_contact& c) { c.feature_b.kind = 77; }, ABUT_UNKNOWN_VALUE, {"contact.feature_b.kind", "77"}));
  EXPECT_TRUE(refuses([](abut_contact& c) { c.flags = 8; }, ABUT_UNKNOWN_VALUE, {"contact.flags", "8"}));
  EXPECT_TRUE(refuses([](abut_contact& c) { c.reserved = 1; }, ABUT_INVALID_ARGUMENT, {"contact.reserved", "1"}));
}

TEST(UniverseLocalPoints, RefusesAUniverseThatKeepsNone) {
  Universe universe;
  Out<const abut_local_points*> points;
  Out<std::size_t> count;
  EXPECT_TRUE(refused(abut_universe_local_points(universe, points.address(), count.address()), ABUT_UNSUPPORTED,
                      {"universe", "ABUT_UNIVERSE_LOCAL_POINTS"}));
  EXPECT_TRUE(points.is_untouched());
  EXPECT_TRUE(count.is_untouched());
}

}  // namespace

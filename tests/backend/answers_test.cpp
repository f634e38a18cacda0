// SPDX-License-Identifier: Apache-2.0
// What becomes of the answers of a back end: which pairs it is asked about, what is checked, what abut answers itself.
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>

#include "detector.hpp"
#include "support.hpp"

namespace {

using namespace abut_test;
using Asked = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// A back end whose `find` a test writes.
struct Script {
  explicit Script(const Universe& universe) {
    require(abut_backend_set(
        universe, nullptr,
        [](void* context, abut_universe* its, const abut_backend_pair* pairs, std::size_t count) {
          auto& script = *static_cast<Script*>(context);
          for (std::size_t i = 0; i < count; ++i)
            script.asked.emplace_back(pairs[i].geometry_a.slot, pairs[i].geometry_b.slot);
          if (script.find) script.find(its, pairs, count);
        },
        this));
  }

  std::function<void(abut_universe*, const abut_backend_pair*, std::size_t)> find;
  Asked asked;
};

// Two balls of radius 1 that overlap by a half.
struct TwoBalls {
  explicit TwoBalls(const abut_universe_options& options = default_universe_options()) : universe(&options) {
    for (const double x : {0.0, 1.5}) {
      parts.push_back(universe.add_part(at(x, 0, 0)));
      geometries.push_back(universe.add_geometry(parts.back(), ball));
    }
  }

  Universe universe;
  Shape ball = make_sphere(1);
  std::vector<abut_part_id> parts;
  std::vector<abut_geometry_id> geometries;
};

abut_backend_contact contact_at(double x, double distance) {
  return backend::contact_of({x, 0, 0}, {x + distance, 0, 0}, {1, 0, 0});
}

// A row of forms of which each touches the next one.
void fill(Universe& universe) {
  const std::vector<Shape> shapes = make_one_of_each_kind();
  for (std::size_t i = 0; i < 40; ++i) {
    const abut_shape* shape = shapes.at(i % 3);
    universe.add(shape, {{0.9 * static_cast<double>(i), 0.1 * static_cast<double>(i % 2), 0}, {0.8, 0.6, 0, 0}});
  }
}

TEST(BackendAnswers, AreTheContactsOfThePair) {
  TwoBalls scene;
  Script script(scene.universe);
  script.find = [](abut_universe* universe, const abut_backend_pair* pairs, std::size_t) {
    EXPECT_EQ(pairs[0].pose_b.position.x, 1.5);
    EXPECT_EQ(abut_shape_kind_of(pairs[0].shape_a), abut_shape_kind_by_name("sphere"));
    EXPECT_EQ(pairs[0].margin, 0);
    abut_backend_contact contact = backend::contact_of({0.5, 0, 0.25}, {0.25, 0, 0}, {1.0005, 0, 0});
    contact.feature_a = {ABUT_FEATURE_EDGE, 3};
    contact.feature_b = {ABUT_FEATURE_FACE, 4};
    contact.child_a = 5;
    contact.child_b = 6;
    contact.id = 77;
    backend::answer(universe, 0, {contact});
  };
  const std::vector<abut_contact> found = scene.universe.step();
  EXPECT_EQ(script.asked, (Asked{{1, 2}}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].point_a.z, 0.25);
  EXPECT_EQ(found[0].distance, -0.25) << "the normal is made 1 long, and the distance is that of the points";
  EXPECT_EQ(found[0].normal.x, 1);
  EXPECT_EQ(found[0].id, 77U);
  EXPECT_EQ(found[0].feature_a.index, 3U);
  EXPECT_EQ(found[0].feature_b.kind, abut_feature_kind{ABUT_FEATURE_FACE});
  EXPECT_EQ(found[0].child_a, 5U);
  EXPECT_EQ(found[0].child_b, 6U);
  EXPECT_TRUE(succeeded(abut_contact_validate(found.data())));
}

// Whichever kind has the lower slot.
TEST(BackendAnswers, HaveLocalPoints) {
  abut_universe_options options = default_universe_options();
  options.flags = ABUT_UNIVERSE_LOCAL_POINTS;
  const Shape ball = make_sphere(1), block = make_box(1, 1, 1);
  for (const bool is_ball_first : {true, false}) {
    Universe universe(&options);
    universe.add(is_ball_first ? ball : block, at(0, 0, 0));
    universe.add(is_ball_first ? block : ball, at(1.5, 0, 0));
    Script script(universe);
    script.find = [](abut_universe* its, const abut_backend_pair*, std::size_t) {
      backend::answer(its, 0, {contact_at(1, -0.5)});
    };
    universe.step();
    const auto points = copy_of(abut_universe_local_points, universe);
    ASSERT_EQ(points.size(), 1U);
    EXPECT_EQ(points[0].a.x, 1);
    EXPECT_EQ(points[0].b.x, -1);
  }
}

TEST(BackendAnswers, AreLeftOutByTheMarginAndReduced) {
  abut_universe_options options = default_universe_options();
  options.max_contacts = 2;
  TwoBalls scene(options);
  Script script(scene.universe);
  script.find = [](abut_universe* universe, const abut_backend_pair*, std::size_t) {
    std::vector<abut_backend_contact> many;
    for (const double distance : {0.1, -0.1, -0.2, -0.3}) {
      many.push_back(contact_at(1, distance));
      many.back().point_a.y = many.back().point_b.y = distance;
    }
    backend::answer(universe, 0, many);
  };
  const std::vector<abut_contact> found = scene.universe.step();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].distance, -0.3, 1e-12);
}

TEST(BackendAnswers, WithoutIdsOrWithEqualOnesAreNumberedApart) {
  TwoBalls scene;
  Script script(scene.universe);
  for (const std::uint64_t id : {0U, 9U}) {
    script.find = [id](abut_universe* universe, const abut_backend_pair*, std::size_t) {
      std::vector<abut_backend_contact> same(3, contact_at(1, -0.1));
      for (abut_backend_contact& each : same) each.id = id;
      backend::answer(universe, 0, same);
    };
    scene.universe.move(scene.parts[0], at(0.001 * static_cast<double>(id), 0, 0));
    const std::vector<abut_contact> found = scene.universe.step();
    ASSERT_EQ(found.size(), 3U);
    EXPECT_TRUE(found[0].id != found[1].id && found[0].id != found[2].id && found[1].id != found[2].id);
    EXPECT_TRUE(id == 0 || found[0].id == 9 || found[1].id == 9 || found[2].id == 9);
  }
}

TEST(BackendAnswers, OfNothingEndThePair) {
  TwoBalls scene;
  EXPECT_EQ(scene.universe.step().size(), 1U);
  Script script(scene.universe);
  script.find = [](abut_universe* universe, const abut_backend_pair*, std::size_t) {
    backend::answer(universe, 0, {});
  };
  EXPECT_TRUE(scene.universe.step().empty()) << "a new back end is asked about all pairs";
  EXPECT_EQ(letters_of(scene.universe.events()), "e");
  require(abut_backend_set(scene.universe, nullptr, nullptr, nullptr));
  EXPECT_EQ(scene.universe.step().size(), 1U) << "and abut is, when it is taken away";
}

TEST(BackendAnswers, CountAsTouchesWhereContactsAreNotWanted) {
  TwoBalls scene;
  abut_policy policy = default_policy();
  policy.detail = ABUT_DETAIL_TOUCH;
  require(abut_policy_set(scene.universe, 0, 0, &policy));
  Script script(scene.universe);
  for (const double distance : {0.1, -0.1}) {
    script.find = [distance](abut_universe* universe, const abut_backend_pair*, std::size_t) {
      backend::answer(universe, 0, {contact_at(1, distance)});
    };
    scene.universe.move(scene.parts[0], at(0.01 * distance, 0, 0));
    EXPECT_TRUE(scene.universe.step().empty());
    EXPECT_EQ(scene.universe.stats().touching_pairs, distance < 0 ? 1U : 0U);
  }
}

TEST(BackendAnswers, ThatAreWrongAreRefusedAndThePairGoesToAbut) {
  TwoBalls scene;
  Script script(scene.universe);
  script.find = [](abut_universe* universe, const abut_backend_pair*, std::size_t) {
    const auto refuse = [&](auto change, abut_status status, std::string_view word) {
      std::array<abut_backend_contact, 2> two{contact_at(1, -0.1), contact_at(1, -0.1)};
      change(two[1]);
      EXPECT_TRUE(refused(abut_backend_answer(universe, 0, two.data(), 2), status, {"contacts[1]", word}));
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    refuse([](abut_backend_contact& its) { its.point_a.y = nan; }, ABUT_NOT_FINITE, "point_a");
    refuse([](abut_backend_contact& its) { its.point_b.z = 1e71; }, ABUT_OUT_OF_RANGE, "point_b");
    refuse([](abut_backend_contact& its) { its.normal.x = nan; }, ABUT_NOT_FINITE, "normal");
    refuse([](abut_backend_contact& its) { its.normal.x = 1.0015; }, ABUT_NOT_UNIT, "1.0015");
    refuse([](abut_backend_contact& its) { its.normal.x = 0; }, ABUT_NOT_UNIT, "normal");
    refuse([](abut_backend_contact& its) { its.feature_b.kind = 99; }, ABUT_UNKNOWN_VALUE, "feature_b");
    EXPECT_TRUE(refused(abut_backend_answer(universe, 1, nullptr, 0), ABUT_INDEX_OUT_OF_RANGE, {"pair", "1"}));
    EXPECT_TRUE(refused(abut_backend_answer(universe, 0, nullptr, 1), ABUT_NULL_ARGUMENT, {"contacts"}));
    EXPECT_TRUE(refused(abut_backend_set(universe, nullptr, nullptr, nullptr), ABUT_BUSY, {}));
  };
  const std::vector<abut_contact> found = scene.universe.step();
  EXPECT_EQ(script.asked.size(), 1U);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].distance, -0.5);
}

TEST(BackendAnswers, AreGivenOncePerPairAndOnlyWhileItAsks) {
  TwoBalls scene;
  Script script(scene.universe);
  const abut_backend_contact good = contact_at(1, -0.25);
  script.find = [&](abut_universe* universe, const abut_backend_pair*, std::size_t) {
    EXPECT_TRUE(succeeded(abut_backend_answer(universe, 0, &good, 1)));
    EXPECT_TRUE(refused(abut_backend_answer(universe, 0, nullptr, 0), ABUT_INVALID_ARGUMENT, {"pair", "0"}));
  };
  EXPECT_TRUE(refused(abut_backend_answer(scene.universe, 0, &good, 1), ABUT_BUSY, {"back end"}));
  EXPECT_EQ(scene.universe.step().at(0).distance, -0.25);
  EXPECT_TRUE(refused(abut_backend_answer(scene.universe, 0, &good, 1), ABUT_BUSY, {"back end"}));
}

// Pairs that the back end leaves have the bits that they have without one, also between pairs that it answers.
TEST(BackendAnswers, OfSomePairsLeaveTheBitsOfTheOthers) {
  const auto contacts_of_row = [](std::size_t answered_of_three) {
    Universe universe;
    fill(universe);
    Script script(universe);
    script.find = [&](abut_universe* its, const abut_backend_pair* pairs, std::size_t count) {
      EXPECT_GT(count, 30U);
      for (std::size_t i = 0; i < count; ++i) {
        if (pairs[i].geometry_a.slot % 3 < answered_of_three) backend::answer(its, i, {contact_at(7, -0.125)});
      }
    };
    return universe.step();
  };
  const std::vector<abut_contact> usual = contacts_of_row(0);
  std::vector<abut_contact> some = contacts_of_row(1), left;
  std::size_t given = 0;
  for (const abut_contact& its : some) given += its.point_a.x == 7 && its.distance == -0.125 ? 1 : 0;
  EXPECT_GT(given, 10U);
  std::erase_if(some, [](const abut_contact& its) { return its.geometry_a.slot % 3 < 1; });
  std::copy_if(usual.begin(), usual.end(), std::back_inserter(left),
               [](const abut_contact& its) { return its.geometry_a.slot % 3 >= 1; });
  for (std::vector<abut_contact>* its : {&some, &left}) {
    for (abut_contact& contact : *its) contact.geometry_a.generation = contact.geometry_b.generation = 0;
  }
  ASSERT_EQ(some.size(), left.size());
  ASSERT_GT(left.size(), 20U);
  EXPECT_EQ(std::memcmp(some.data(), left.data(), some.size() * sizeof(abut_contact)), 0);
}

// Two sheets side by side, and a ball over their common border: abut would take a contact away that leans over it.
TEST(BackendAnswers, AreLeftAsTheyAreAtSeams) {
  Universe universe;
  const Shape sheet = make_square_mesh(1), ball = make_sphere(0.5);
  for (const double x : {-1.0, 1.0}) universe.add(sheet, at(x, 0, 0), ABUT_MOTION_STATIC);
  universe.add(ball, at(0.02, 0, 0.48));
  Script script(universe);
  script.find = [](abut_universe* its, const abut_backend_pair* pairs, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const double lean = pairs[i].geometry_a.slot == 1 ? 0.6 : 0;
      abut_backend_contact contact =
          backend::contact_of({0, 0, 0}, {-0.02 * lean, 0, -0.02}, {lean, 0, lean > 0 ? 0.8 : 1});
      contact.feature_a = {ABUT_FEATURE_EDGE, 0};
      backend::answer(its, i, {contact});
    }
  };
  const std::vector<abut_contact> found = universe.step();
  ASSERT_EQ(script.asked.size(), 2U);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].normal.x, 0.6);
}

TEST(Backend, IsAskedAboutTheKindsThatItAccepts) {
  Universe universe;
  const Shape ball = make_sphere(1), block = make_box(1, 1, 1);
  for (const abut_shape* shape : {ball.operator abut_shape*(), block.operator abut_shape*()}) {
    for (const double x : {0.0, 0.5}) universe.add(shape, at(x, 0, 0));
  }
  Script script(universe);
  universe.step();
  EXPECT_EQ(script.asked.size(), 6U);
  script.asked.clear();
  // Both orders of two kinds are one.
  require(abut_backend_set(
      universe,
      [](void*, abut_shape_kind a, abut_shape_kind b) -> std::uint32_t {
        const abut_shape_kind sphere = abut_shape_kind_by_name("sphere"), box = abut_shape_kind_by_name("box");
        return (a == sphere && b == box) || (a == box && b == sphere) ? 1 : 0;
      },
      [](void* context, abut_universe*, const abut_backend_pair* pairs, std::size_t count) {
        auto& asked = *static_cast<Asked*>(context);
        for (std::size_t i = 0; i < count; ++i) asked.emplace_back(pairs[i].geometry_a.slot, pairs[i].geometry_b.slot);
      },
      &script.asked));
  universe.step();
  EXPECT_EQ(script.asked, (Asked{{1, 3}, {1, 4}, {2, 3}, {2, 4}}));
}

TEST(Backend, IsNotAskedAboutWhatOtherStagesAnswer) {
  abut_universe_options options = default_universe_options();
  options.tolerance_mode = ABUT_TOLERANCE_MARGIN;
  Universe universe(&options);
  const Shape sheet = make_square_mesh(1), ball = make_sphere(0.5);
  abut_geometry_options with_self = default_geometry_options(), with_side = default_geometry_options(),
                        by_elements = default_geometry_options(), as_boxes = default_geometry_options();
  with_self.flags = ABUT_GEOMETRY_SELF_PAIRS;
  with_side.flags = ABUT_GEOMETRY_KEEPS_SIDE;
  by_elements.tag = 1;
  as_boxes.tag = 2;
  abut_policy policy = default_policy();
  policy.detail = ABUT_DETAIL_ELEMENTS;
  policy.tolerance = 0.2;
  require(abut_policy_set(universe, 0, 1, &policy));
  policy = default_policy();
  policy.detail = ABUT_DETAIL_BOX;
  require(abut_policy_set(universe, 0, 2, &policy));
  const auto add = [&](const abut_shape* shape, const abut_geometry_options& its, double z) {
    universe.add_geometry(universe.add_part(at(0, 0, z)), shape, its);
  };
  add(sheet, with_self, 0);
  add(ball, with_side, 0.45);
  add(sheet, by_elements, 0.05);
  add(ball, as_boxes, 0.4);
  add(ball, default_geometry_options(), -0.45);
  abut_policy none = default_policy();
  none.detail = ABUT_DETAIL_BOX;
  for (const std::uint32_t tag : {1U, 2U}) {
    for (const std::uint32_t other : {1U, 2U}) require(abut_policy_set(universe, tag, other, &none));
  }
  Script script(universe);
  universe.step();
  // The second ball that keeps no side, with the sheet that meets itself; the others have a stage or a box.
  const Asked wanted{{1, 5}, {2, 5}};
  Asked without_elements;
  for (const auto& its : script.asked) {
    if (its.first != 3 && its.second != 3) without_elements.push_back(its);
  }
  EXPECT_EQ(without_elements, wanted);
  EXPECT_EQ(std::count(script.asked.begin(), script.asked.end(), std::pair(1U, 3U)), 0) << "told by elements";
  EXPECT_FALSE(copy_of(abut_universe_element_contacts, static_cast<const abut_universe*>(universe)).empty());
}

TEST(Backend, IsNotAskedWhileNothingChanges) {
  TwoBalls scene;
  Script script(scene.universe);
  scene.universe.step();
  scene.universe.step();
  EXPECT_EQ(script.asked.size(), 1U);
  require(abut_universe_detect_all(scene.universe));
  EXPECT_EQ(script.asked.size(), 2U);
}

TEST(Backend, IsExplained) {
  TwoBalls scene;
  const auto text = [&](auto explain) {
    std::size_t count = 0;
    require(explain(scene.universe, nullptr, 0, &count));
    std::string words(count, ' ');
    require(explain(scene.universe, words.data(), words.size(), &count));
    return words;
  };
  scene.universe.step();
  EXPECT_EQ(text(abut_universe_explain).find("back end"), std::string::npos);
  Script script(scene.universe);
  scene.universe.step();
  EXPECT_NE(text(abut_universe_explain).find("back end: 1 pair asked, 0 answered\n"), std::string::npos);
  script.find = [](abut_universe* universe, const abut_backend_pair*, std::size_t) {
    backend::answer(universe, 0, {});
  };
  require(abut_universe_detect_all(scene.universe));
  const std::string json = text(abut_universe_explain_json);
  for (const std::string_view word : {"\"backend\": {", "\"asked\": 1", "\"answered\": 1"}) {
    EXPECT_NE(json.find(word), std::string::npos) << json;
  }
}

TEST(Backend, MayLookAtTheUniverse) {
  TwoBalls scene;
  Script script(scene.universe);
  bool has_looked = false;
  script.find = [&](abut_universe* universe, const abut_backend_pair* pairs, std::size_t) {
    abut_geometry_info info = filled_by(abut_geometry_info_init);
    EXPECT_TRUE(succeeded(abut_geometry_describe(universe, pairs[0].geometry_b, &info)));
    EXPECT_EQ(info.shape, pairs[0].shape_b);
    has_looked = true;
  };
  scene.universe.step();
  EXPECT_TRUE(has_looked);
}

// As out of a filter: a defect of the caller.
TEST(Backend, WhatIsThrownOutOfItEndsTheUniverse) {
  TwoBalls scene;
  Script script(scene.universe);
  script.find = [](abut_universe*, const abut_backend_pair*, std::size_t) { throw std::runtime_error("it failed"); };
  EXPECT_TRUE(refused(abut_universe_step(scene.universe, 0), ABUT_INTERNAL, {"it failed"}));
  EXPECT_TRUE(refused(abut_universe_step(scene.universe, 0), ABUT_INTERNAL, {}));
}

}  // namespace

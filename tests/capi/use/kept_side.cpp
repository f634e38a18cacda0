// SPDX-License-Identifier: Apache-2.0
// Shapes that are pushed through a surface keep the side on which they came in, as long as they touch it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "archive_support.hpp"
#include "moving.hpp"

namespace {

using namespace abut_test;

struct Body {
  std::string name;
  Shape shape;
  abut_quat orientation;
  std::function<double(const abut_vec3&)> reach;  // of the turned shape along a unit direction
};

double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
abut_vec3 turned(const abut_quat& q, const abut_vec3& v) {
  const abut_quat back{q.w, -q.x, -q.y, -q.z};
  const abut_quat r = product(product(q, {0, v.x, v.y, v.z}), back);
  return {r.x, r.y, r.z};
}

std::vector<Body> bodies() {
  std::vector<Body> all;
  const abut_quat leaning = turned_by({0.3, -0.2, 0.1});
  all.push_back({"sphere", make_sphere(0.5), leaning, [](const abut_vec3&) { return 0.5; }});
  all.push_back({"box", make_box(0.3, 0.4, 0.5), leaning, [leaning](const abut_vec3& d) {
                   return 0.3 * std::fabs(dot(d, turned(leaning, {1, 0, 0}))) +
                          0.4 * std::fabs(dot(d, turned(leaning, {0, 1, 0}))) +
                          0.5 * std::fabs(dot(d, turned(leaning, {0, 0, 1})));
                 }});
  all.push_back({"capsule", make_capsule(0.2, 0.3), leaning,
                 [leaning](const abut_vec3& d) { return 0.2 + 0.3 * std::fabs(dot(d, turned(leaning, {0, 0, 1}))); }});
  all.push_back({"octahedron", make_octahedron(0.5), leaning, [leaning](const abut_vec3& d) {
                   return 0.5 * std::max({std::fabs(dot(d, turned(leaning, {1, 0, 0}))),
                                          std::fabs(dot(d, turned(leaning, {0, 1, 0}))),
                                          std::fabs(dot(d, turned(leaning, {0, 0, 1})))});
                 }});
  all.push_back({"cylinder", make_of_kind("cylinder", {0.4, 0.3}), leaning, [leaning](const abut_vec3& d) {
                   const double along = dot(d, turned(leaning, {0, 0, 1}));
                   return 0.3 * std::fabs(along) + 0.4 * std::sqrt(std::max(0.0, 1 - along * along));
                 }});
  return all;
}

// Sheets at z = 0 with the front up, each but the last two-sided.
std::vector<Shape> sheets() {
  std::vector<Shape> all;
  const std::vector<double> corners{-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, 2, 0};
  all.push_back(make_of_kind("mesh", {ABUT_SIDES_BOTH}, corners, {0, 1, 2, 0, 2, 3}));
  // The second triangle is wound the other way.
  all.push_back(make_of_kind("mesh", {ABUT_SIDES_BOTH}, corners, {0, 1, 2, 0, 3, 2}));
  abut_shape* grid = nullptr;
  const std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 2, 3};
  require(abut_uv_grid_create(corners.data(), 4, triangles.data(), 2, nullptr, &grid));
  all.emplace_back(grid);
  const std::vector<double> flat(16, 0.0);
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = 4;
  desc.spacing_x = desc.spacing_y = 2;
  desc.heights = flat.data();
  abut_shape* field = nullptr;
  require(abut_height_field_create(&desc, &field));
  all.emplace_back(field);
  return all;
}
constexpr std::size_t field_of_sheets = 3;
// Where a body is over the middle of a triangle of a sheet.
abut_vec3 middle_of(std::size_t sheet) {
  return sheet == field_of_sheets ? abut_vec3{2.7, 2.9, 0} : abut_vec3{0.3, -0.2, 0};
}

Shape make_box_mesh(double s) {
  std::vector<double> corners;
  for (int i = 0; i < 8; ++i) {
    corners.insert(corners.end(), {(i & 1) != 0 ? s : -s, (i & 2) != 0 ? s : -s, (i & 4) != 0 ? s : -s});
  }
  return make_of_kind("mesh", {ABUT_SIDES_BOTH}, corners, {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                                           2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5});
}

// A surface that stands still and a body that is placed step by step.
class Push {
 public:
  Push(const abut_shape* surface, const Body& body, const abut_pose& pose, abut_geometry_flags of_surface,
       abut_geometry_flags of_body, bool body_first = false)
      : body_(body), is_first_(body_first) {
    if (body_first) add_body(pose, of_body);
    universe.add_geometry(universe.add_part(identity, ABUT_MOTION_STATIC), surface, with_flags(of_surface));
    if (!body_first) add_body(pose, of_body);
  }
  void place(const abut_vec3& position) { universe.move(part, {position, body_.orientation}); }
  // The contacts with normals that lead to the body, deepest first.
  std::vector<abut_contact> step_to(const abut_vec3& position) {
    place(position);
    std::vector<abut_contact> contacts = universe.step();
    for (abut_contact& contact : contacts) {
      if (is_first_) contact.normal = times(-1, contact.normal);
    }
    return contacts;
  }

  Universe universe;
  abut_part_id part{};

 private:
  void add_body(const abut_pose& pose, abut_geometry_flags flags) {
    part = universe.add_part(pose);
    universe.add_geometry(part, body_.shape, with_flags(flags));
  }
  const Body& body_;
  bool is_first_;
};

// That the deepest contact leads along a direction and is as deep as the body reaches beyond the plane z = 0.
void expect_contact(const std::vector<abut_contact>& contacts, const abut_vec3& direction, double distance) {
  ASSERT_FALSE(contacts.empty());
  EXPECT_NEAR(contacts[0].distance, distance, 1e-9);
  for (const abut_contact& contact : contacts) {
    EXPECT_NEAR(dot(contact.normal, direction), 1, 1e-9);
    EXPECT_LE(contact.distance, 0);
  }
}

TEST(KeptSide, LeadsBackThroughASheetAsLongAsTheyTouch) {
  const std::vector<Shape> surfaces = sheets();
  for (std::size_t sheet = 0; sheet < surfaces.size(); ++sheet) {
    const bool has_back = sheet != field_of_sheets;
    for (const Body& body : bodies()) {
      for (const double side : has_back ? std::vector<double>{1, -1} : std::vector<double>{1}) {
        for (const bool body_first : {false, true}) {
          SCOPED_TRACE(body.name + " on sheet " + std::to_string(sheet) + " from side " + std::to_string(side));
          const abut_vec3 up{0, 0, side};
          const double reach = body.reach(up);
          Push push(surfaces[sheet], body, {sum(middle_of(sheet), times(2, up)), body.orientation},
                    body_first ? 0 : ABUT_GEOMETRY_KEEPS_SIDE, body_first ? ABUT_GEOMETRY_KEEPS_SIDE : 0, body_first);
          for (double height = 0.99 * reach; height > -reach; height -= 0.07) {
            SCOPED_TRACE(height);
            expect_contact(push.step_to(sum(middle_of(sheet), times(height, up))), up, height - reach);
          }
          EXPECT_TRUE(push.step_to(sum(middle_of(sheet), times(-1.01 * reach, up))).empty());
          // Once they have parted, it comes from where it is.
          const auto contacts = push.step_to(sum(middle_of(sheet), times(-0.9 * reach, up)));
          if (has_back) expect_contact(contacts, times(-1, up), -0.1 * reach);
        }
      }
    }
  }
}

// A ball and a cylinder beside each other, which reach as far up and down.
Body make_pair_of_bodies() {
  const Shape ball = make_sphere(0.5), cylinder = make_of_kind("cylinder", {0.2, 0.5});
  return {"pair", make_composite({ball, cylinder}, {at(-0.6, 0.1, 0), at(0.4, 0, 0)}), no_rotation,
          [](const abut_vec3&) { return 0.5; }};
}

TEST(KeptSide, IsThatOfEachChildOfAComposite) {
  const std::vector<Shape> surfaces = sheets();
  const Body ball{"ball", make_sphere(0.5), no_rotation, [](const abut_vec3&) { return 0.5; }};
  const Body pair = make_pair_of_bodies();
  for (std::size_t sheet = 0; sheet < surfaces.size(); ++sheet) {
    // Below it lies a sheet that nothing reaches.
    const Shape floors = make_composite({surfaces[sheet], surfaces[0]}, {identity, at(0, 0, -9)});
    const bool has_back = sheet != field_of_sheets;
    for (const double side : has_back ? std::vector<double>{1, -1} : std::vector<double>{1}) {
      for (const bool body_first : {false, true}) {
        for (const auto& [surface, body] :
             {std::pair<const Shape*, const Body*>{&surfaces[sheet], &pair}, {&floors, &ball}, {&floors, &pair}}) {
          SCOPED_TRACE(body->name + (surface == &floors ? " on sheets " : " on sheet ") + std::to_string(sheet) +
                       " from side " + std::to_string(side) + (body_first ? ", first" : ""));
          const abut_vec3 up{0, 0, side};
          Push push(*surface, *body, {sum(middle_of(sheet), times(2, up)), no_rotation},
                    body_first ? 0 : ABUT_GEOMETRY_KEEPS_SIDE, body_first ? ABUT_GEOMETRY_KEEPS_SIDE : 0, body_first);
          for (double height = 0.495; height > -0.5; height -= 0.07) {
            SCOPED_TRACE(height);
            const auto contacts = push.step_to(sum(middle_of(sheet), times(height, up)));
            expect_contact(contacts, up, height - 0.5);
            // Each child is as deep, and its contact names it.
            for (const std::uint32_t child :
                 body == &pair ? std::vector<std::uint32_t>{0, 1} : std::vector<std::uint32_t>{0}) {
              const auto is_of_child = [&](const abut_contact& its) {
                return (body_first ? its.child_a : its.child_b) == child &&
                       std::fabs(its.distance - (height - 0.5)) < 1e-9;
              };
              EXPECT_TRUE(std::ranges::any_of(contacts, is_of_child)) << child;
            }
          }
          EXPECT_TRUE(push.step_to(sum(middle_of(sheet), times(-0.505, up))).empty());
          const auto contacts = push.step_to(sum(middle_of(sheet), times(-0.45, up)));
          if (has_back) expect_contact(contacts, times(-1, up), -0.05);
        }
      }
    }
  }
}

// Balls of one shape, of which some reach a sheet sooner than others. Their places: beside each other, and how high.
constexpr std::array<std::array<double, 2>, 3> balls{{{-0.6, 0}, {0, -0.35}, {0.5, 0.4}}};

std::vector<double> places_of_balls(const abut_vec3& centre, double side) {
  std::vector<double> xyz;
  for (const auto& [beside, height] : balls)
    xyz.insert(xyz.end(), {centre.x + beside, centre.y + 0.1, centre.z + side * height});
  return xyz;
}
// That each ball that reaches the plane z = 0 has a contact that leads back to the side.
void expect_each_ball(const std::vector<abut_contact>& contacts, bool balls_first, double side, double height) {
  for (const abut_contact& contact : contacts) EXPECT_NEAR(side * contact.normal.z, 1, 1e-9);
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const double its_height = height + balls[i][1];
    const auto is_of_ball = [&](const abut_contact& its) { return (balls_first ? its.child_a : its.child_b) == i; };
    const auto is_as_deep = [&](const abut_contact& its) {
      return std::fabs(its.distance - (its_height - 0.5)) < 1e-9;
    };
    const bool touches = std::fabs(its_height) < 0.5;
    EXPECT_EQ(std::ranges::any_of(contacts, is_of_ball), touches) << i;
    EXPECT_EQ(std::ranges::any_of(contacts, [&](const auto& its) { return is_of_ball(its) && is_as_deep(its); }),
              touches)
        << i;
  }
}

TEST(KeptSide, IsThatOfEachParticle) {
  const std::vector<Shape> surfaces = sheets();
  for (std::size_t sheet = 0; sheet < surfaces.size(); ++sheet) {
    const bool has_back = sheet != field_of_sheets;
    for (const double side : has_back ? std::vector<double>{1, -1} : std::vector<double>{1}) {
      Shape particles = make_of_kind("particles", {0.5}, places_of_balls({0, 0, 0}, side));
      const Body body{"particles", std::move(particles), no_rotation, {}};
      const abut_vec3 up{0, 0, side};
      for (const bool body_first : {false, true}) {
        SCOPED_TRACE("sheet " + std::to_string(sheet) + " from side " + std::to_string(side));
        Push push(surfaces[sheet], body, {sum(middle_of(sheet), times(2, up)), no_rotation},
                  body_first ? 0 : ABUT_GEOMETRY_KEEPS_SIDE, body_first ? ABUT_GEOMETRY_KEEPS_SIDE : 0, body_first);
        for (double height = 0.83; height > -0.95; height -= 0.07) {
          SCOPED_TRACE(height);
          expect_each_ball(push.step_to(sum(middle_of(sheet), times(height, up))), body_first, side, height);
        }
        // Once they have parted, they come from where they are.
        if (has_back) expect_contact(push.step_to(sum(middle_of(sheet), times(-0.85, up))), times(-1, up), -0.05);
      }
    }
  }
}

TEST(KeptSide, IsThatOfParticlesThatMoveOneByOne) {
  const std::vector<Shape> surfaces = sheets();
  for (std::size_t sheet = 0; sheet < surfaces.size(); ++sheet) {
    SCOPED_TRACE(sheet);
    Universe universe;
    universe.add_geometry(universe.add_part(identity, ABUT_MOTION_STATIC), surfaces[sheet]);
    const abut_geometry_id particles =
        universe.add_geometry(universe.add_part(identity),
                              make_of_kind("particles", {0.5}, places_of_balls(sum(middle_of(sheet), {0, 0, 2}), 1)),
                              with_flags(ABUT_GEOMETRY_KEEPS_SIDE));
    for (double height = 0.83; height > -0.95; height -= 0.07) {
      SCOPED_TRACE(height);
      const std::vector<double> xyz = places_of_balls(sum(middle_of(sheet), {0, 0, height}), 1);
      require(abut_geometry_set_particles(universe, particles, 0, xyz.data(), nullptr, balls.size()));
      expect_each_ball(universe.step(), false, 1, height);
    }
  }
}

// A clamp with an arm on either side of a sheet: each comes from its own side.
TEST(KeptSide, IsOfEachArmOfAClamp) {
  const std::vector<Shape> surfaces = sheets();
  const Shape ball = make_sphere(0.5);
  const Body clamp{"clamp", make_composite({ball, ball}, {at(0, 0, 0.45), at(0, 0, -0.45)}), no_rotation, {}};
  Push push(surfaces[0], clamp, {{4, 0.1, 0}, no_rotation}, ABUT_GEOMETRY_KEEPS_SIDE, 0);
  for (double x = 2.4; x > 0; x -= 0.1) push.step_to({x, 0.1, 0});
  const auto contacts = push.step_to({0.3, 0.1, -0.5});
  // The upper arm has passed the sheet, the lower one has left it.
  expect_contact(contacts, {0, 0, 1}, -0.55);
}

TEST(KeptSide, IsNotKeptWithoutTheFlag) {
  const std::vector<Shape> surfaces = sheets();
  for (const Body& body : bodies()) {
    Push push(surfaces[0], body, {{0.3, -0.2, 2}, body.orientation}, 0, 0);
    expect_contact(push.step_to({0.3, -0.2, 0.3}), {0, 0, 1}, 0.3 - body.reach({0, 0, 1}));
    expect_contact(push.step_to({0.3, -0.2, -0.3}), {0, 0, -1}, 0.3 - body.reach({0, 0, 1}));
  }
}

TEST(KeptSide, LeadsBackThroughTheSideOfABox) {
  const Shape box = make_box_mesh(2);
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    const double reach = body.reach({1, 0, 0});
    Push push(box, body, {{-4, 0, 0}, body.orientation}, ABUT_GEOMETRY_KEEPS_SIDE, 0);
    for (double height = 0.99 * reach; height > -reach; height -= 0.07) {
      SCOPED_TRACE(height);
      expect_contact(push.step_to({-2 - height, 0.3, -0.1}), {-1, 0, 0}, height - reach);
    }
    EXPECT_TRUE(push.step_to({-2 + 1.01 * reach, 0.3, -0.1}).empty());
    expect_contact(push.step_to({-2 + 0.9 * reach, 0.3, -0.1}), {1, 0, 0}, -0.1 * reach);
    expect_contact(push.step_to({-2 - 0.5 * reach, 0.3, -0.1}), {1, 0, 0}, -1.5 * reach);
  }
}

TEST(KeptSide, IsThatOfANeighbourWhereTheBodyGoesOnUnderTheSurface) {
  // A wavy floor of small triangles; the ball goes on with its centre below it.
  constexpr int cells = 24;
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
  const auto height = [](double x, double y) { return 0.03 * std::sin(3 * x) * std::cos(2 * y); };
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const double x = 0.25 * i - 3, y = 0.25 * j - 3;
      points.insert(points.end(), {x, y, height(x, y)});
    }
  }
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t a = j * (cells + 1) + i, b = a + cells + 1;
      triangles.insert(triangles.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  }
  const Shape floor = make_of_kind("mesh", {ABUT_SIDES_BOTH}, points, triangles);
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    Push push(floor, body, {{-2, -1.5, 1}, body.orientation}, 0, ABUT_GEOMETRY_KEEPS_SIDE);
    push.step_to({-2, -1.5, 0.2});
    push.step_to({-2, -1.5, 0.0});
    for (int i = 0; i <= 100; ++i) {
      const double x = -2 + 0.04 * i, y = -1.5 + 0.03 * i;
      const auto contacts = push.step_to({x, y, -0.12});
      ASSERT_FALSE(contacts.empty());
      EXPECT_GT(-contacts[0].distance, body.reach({0, 0, 1})) << x;
      EXPECT_LT(-contacts[0].distance, body.reach({0, 0, 1}) + 0.2) << x;
      for (const abut_contact& contact : contacts) EXPECT_GT(contact.normal.z, 0.9) << x;
    }
  }
}

TEST(KeptSide, TurnsAroundTheRimOfASheet) {
  const std::vector<Shape> surfaces = sheets();
  const std::vector<Body> all = bodies();
  Push push(surfaces[0], all[0], {{1.9, 0, 2}, no_rotation}, ABUT_GEOMETRY_KEEPS_SIDE, 0);
  // Over the face, around the rim at x = 2, and on below.
  for (int i = 0; i <= 40; ++i) {
    const double angle = 3.14159265358979 * i / 40 - 1.5707963267948966;
    const auto contacts = push.step_to({2 + 0.45 * std::cos(angle), 0.1, -0.45 * std::sin(angle)});
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_NEAR(contacts[0].distance, -0.05, 1e-9);
    EXPECT_NEAR(contacts[0].normal.x, std::cos(angle), 1e-9);
    EXPECT_NEAR(contacts[0].normal.z, -std::sin(angle), 1e-9);
  }
  expect_contact(push.step_to({1.5, 0.1, -0.4}), {0, 0, -1}, -0.1);
  expect_contact(push.step_to({1.2, 0.1, 0.2}), {0, 0, -1}, -0.7);
}

TEST(KeptSide, OfABallOnABoxIsTheOutside) {
  // Sunk by more than 4 cm, the ball reaches the side wall from inside.
  const Shape box = make_box_mesh(1);
  const Body ball{"sphere", make_sphere(0.5), no_rotation, {}};
  Push push(box, ball, {{0, 0.8, 3}, no_rotation}, ABUT_GEOMETRY_KEEPS_SIDE, 0);
  for (int i = 0; i < 48; ++i) {
    const double height = 1.49 - 0.01 * i;
    expect_contact(push.step_to({0, 0.8, height}), {0, 0, 1}, height - 1.5);
  }
}

TEST(KeptSide, IsForgottenWithTheShape) {
  const std::vector<Shape> surfaces = sheets();
  const std::vector<Body> all = bodies();
  Push push(surfaces[0], all[0], {{0.3, -0.2, 2}, no_rotation}, ABUT_GEOMETRY_KEEPS_SIDE, 0);
  expect_contact(push.step_to({0.3, -0.2, 0.1}), {0, 0, 1}, -0.4);
  expect_contact(push.step_to({0.3, -0.2, -0.1}), {0, 0, 1}, -0.6);
  const abut_geometry_id body = push.universe.contacts()[0].geometry_b;
  require(abut_geometry_set_shape(push.universe, body, all[0].shape));
  expect_contact(push.universe.step(), {0, 0, -1}, -0.4);
}

// Many bodies that are pushed through a box and a sheet, with each seed in another way.
class Crowd {
 public:
  Crowd(std::uint32_t threads, std::uint32_t seed) : universe_(options(threads)) {
    std::uint32_t state = seed;
    const auto next = [&] { return static_cast<double>((state = state * 1664525 + 1013904223) >> 8) / (1 << 24); };
    universe_.add_geometry(universe_.add_part(identity, ABUT_MOTION_STATIC), box_,
                           with_flags(ABUT_GEOMETRY_KEEPS_SIDE));
    universe_.add_geometry(universe_.add_part(at(0, 0, 4), ABUT_MOTION_STATIC), sheets_[0],
                           with_flags(ABUT_GEOMETRY_KEEPS_SIDE));
    for (int i = 0; i < 300; ++i) {
      const abut_vec3 start{6 * next() - 3, 6 * next() - 3, 9 * next() - 3};
      starts_.push_back(start);
      ways_.push_back({next() - 0.5, next() - 0.5, next() - 0.5});
      parts_.push_back(universe_.add_part({start, no_rotation}));
      const std::size_t kind = static_cast<std::size_t>(i) % (bodies_.size() + 2);
      universe_.add_geometry(parts_.back(), kind < bodies_.size()    ? bodies_[kind].shape
                                            : kind == bodies_.size() ? pair_.shape
                                                                     : particles_);
    }
  }
  void step(abut_universe* universe, int number) const {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const abut_pose pose{sum(starts_[i], times(0.2 * number, ways_[i])), no_rotation};
      require(abut_part_set_pose(universe, parts_[i], &pose));
    }
    require(abut_universe_step(universe, 0.01));
  }
  abut_universe* universe() const { return universe_; }

 private:
  static const abut_universe_options* options(std::uint32_t threads) {
    static abut_universe_options made;
    made = default_universe_options();
    made.threads = threads_of_build(threads);
    return &made;
  }
  Shape box_ = make_box_mesh(2);
  std::vector<Shape> sheets_ = sheets();
  std::vector<Body> bodies_ = bodies();
  Body pair_ = make_pair_of_bodies();
  Shape particles_ = make_of_kind("particles", {0.5}, places_of_balls({0, 0, 0}, 1));
  Universe universe_;
  std::vector<abut_vec3> starts_, ways_;
  std::vector<abut_part_id> parts_;
};

std::uint64_t hash_of(const abut_universe* universe) {
  std::uint64_t hash = 0;
  require(abut_universe_hash(universe, &hash));
  return hash;
}

TEST(KeptSide, IsTheSameBitsOnAnyNumberOfThreads) {
  const Crowd one(1, 5), three(3, 5);
  for (int i = 0; i < 25; ++i) {
    one.step(one.universe(), i);
    three.step(three.universe(), i);
    ASSERT_EQ(hash_of(one.universe()), hash_of(three.universe())) << "step " << i;
  }
}

TEST(KeptSide, IsSavedAndLoaded) {
  const Crowd crowd(1, 11);
  for (int i = 0; i < 12; ++i) crowd.step(crowd.universe(), i);
  const Owned again = loaded(saved(crowd.universe()));
  for (int i = 12; i < 25; ++i) {
    crowd.step(crowd.universe(), i);
    crowd.step(again.get(), i);
    ASSERT_EQ(hash_of(crowd.universe()), hash_of(again.get())) << "step " << i;
  }
}

TEST(KeptSide, IsShownByTheFlagOfTheGeometry) {
  const std::vector<Body> all = bodies();
  Universe universe;
  const abut_geometry_id geometry =
      universe.add_geometry(universe.add_part(identity), all[0].shape, with_flags(ABUT_GEOMETRY_KEEPS_SIDE));
  EXPECT_EQ(universe.describe(geometry).flags, std::uint32_t{ABUT_GEOMETRY_KEEPS_SIDE});
}

}  // namespace

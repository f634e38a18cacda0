// SPDX-License-Identifier: Apache-2.0
// Contacts and distances of surfaces in seeded random scenes, against an oracle that knows each triangle in 113 bits.
// ABUT_SURFACE_SCENES=20 plays twenty times as many scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "oracle/exact.hpp"
#include "oracle/surface_judge.hpp"
#include "oracle/winding.hpp"
#include "record.hpp"
#include "shortfall.hpp"
#include "surface_scenes.hpp"
#include "tolerance.hpp"

namespace {

// See shortfalls.hpp for what the numbers mean, and docs/testing.md for the reasons.
constexpr auto shortfalls = std::to_array<property::Shortfall>({
    {"height_field and height_field: a depth no deeper than a way out", 1, 0.069},
    {"height_field and mesh: a depth no deeper than a way out", 1, 8.4e-06},
    {"mesh and convex: no contact deeper than a way out", 1, 0.011},
    {"mesh and mesh front: a depth no deeper than a way out", 1, 0.026},
    {"mesh and mesh: a depth no deeper than a way out", 2, 6.2e-05},
    {"mesh and mesh: no contact deeper than a way out", 2, 6.2e-05},
    {"mesh front and convex: no contact deeper than a way out", 1, 1.4e-6},
    {"mesh front and mesh front: a depth no deeper than a way out", 1, 0.098},
    {"mesh front and mesh: a depth no deeper than a way out", 1, 0.0093},
    {"uv_grid and convex: no contact deeper than a way out", 3, 0.0056},
    {"uv_grid and mesh: a depth no deeper than a way out", 2, 0.009},
    {"uv_grid and mesh: no contact deeper than a way out", 1, 3.6e-06},
    {"uv_grid and uv_grid: a depth no deeper than a way out", 2, 0.0097},
    {"uv_grid and uv_grid: no contact deeper than a way out", 2, 0.0094},
});

}  // namespace

std::span<const property::Shortfall> property::known_shortfalls() { return shortfalls; }

namespace {

using oracle::Meeting;
using oracle::quad;
using oracle::Side;
using oracle::Vec;
using property::between;
using property::Random;
using property::SceneShape;
using property::SurfaceScene;

double length(const abut_vec3& v) { return std::hypot(v.x, v.y, v.z); }

struct Played {
  const SceneShape& a;
  const SceneShape& b;
  SurfaceScene scene;
  std::uint64_t seed;
  property::Magnitude magnitude;
  double tolerance;
};

void broken(const Played& played, const std::string& fact, double off, bool is_angle = false) {
  const property::Magnitude& m = played.magnitude;
  const double size = is_angle ? off : off / (m.size_a + m.size_b + m.apart);
  const std::string row = played.a.kind + " and " + (played.b.is_surface ? played.b.kind : "convex") + ": " + fact;
  if (property::record().fails_as_known(row, size, property::known_shortfalls())) return;
  ADD_FAILURE() << row << "\n  of " << played.b.kind << " " << played.scene.name << " is missed by " << off << ", "
                << size << " of the size; seed " << played.seed << "\n  a " << property::text_of(played.scene.a)
                << "\n  b " << property::text_of(played.scene.b);
}

std::vector<abut_contact> contacts_of(const Played& played, double margin) {
  std::vector<abut_contact> contacts(2000);
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.margin = margin;
  options.max_contacts = 0;
  std::size_t found = 0;
  EXPECT_EQ(abut_pair_contacts(played.a.shape.get(), &played.scene.a, played.b.shape.get(), &played.scene.b, &options,
                               contacts.data(), contacts.size(), &found),
            ABUT_OK)
      << "seed " << played.seed;
  EXPECT_LE(found, contacts.size()) << "seed " << played.seed;
  contacts.resize(std::min(found, contacts.size()));
  return contacts;
}

void check_distance(const Played& played, const Side& a, const Side& b, const Meeting& meeting,
                    std::span<const oracle::Touch> touches) {
  abut_distance found{};
  ASSERT_EQ(
      abut_pair_distance(played.a.shape.get(), &played.scene.a, played.b.shape.get(), &played.scene.b, nullptr, &found),
      ABUT_OK)
      << "seed " << played.seed;
  const double truth = static_cast<double>(meeting.distance);
  const auto expect_at_most = [&](const char* fact, double off) {
    if (!(off <= played.tolerance)) broken(played, fact, off);
  };
  if (truth > 0) {
    expect_at_most("the distance of the nearest parts", std::abs(found.distance - truth));
    expect_at_most("a lower bound below the distance", found.lower - truth);
    expect_at_most("an upper bound above the distance", truth - found.upper);
    return;
  }
  // In a valley no contact is as deep as the whole. Parts with one side that are met from behind may be deeper.
  double deepest = a.is_one_sided || b.is_one_sided ? 0 : truth;
  for (const oracle::Touch& touch : touches) deepest = std::min(deepest, touch.distance);
  expect_at_most("a depth of at least each contact and each two parts", found.distance - deepest);
  // To the front of all, no way may be as short as out of two parts.
  if (!a.is_one_sided && !b.is_one_sided)
    expect_at_most("a bound that no two parts are deeper than", -found.upper - std::abs(truth));
  if (found.distance < 0) {
    const Vec move = property::vec_of(found.normal) * quad(-found.distance);
    const double left = static_cast<double>(distance_after(a, b, move, quad(played.magnitude.size_b), false));
    expect_at_most("nothing overlapped after a move by the depth", -left);
    if (b.is_surface) {
      const oracle::WayOut way = shortest_way_out(a, b, meeting, std::vector<Vec>{property::vec_of(found.normal)});
      // What leans by a thousandth is longer by half a millionth.
      if (way.is_known) {
        expect_at_most("a depth no deeper than a way out",
                       -found.distance - (1 + 1e-6) * static_cast<double>(way.depth));
      }
    }
  }
}

// The inside of a solid, by the winding number of the triangles around a point relative to the origin of the sides.
class SolidInside {
 public:
  SolidInside(const SceneShape& solid, const abut_pose& pose) : turn_(property::pose_of(pose)) {
    for (const oracle::Point& p : solid.soup.points) xyz_.insert(xyz_.end(), p.begin(), p.end());
    for (const auto& t : solid.soup.triangles) corners_.insert(corners_.end(), t.begin(), t.end());
  }
  [[nodiscard]] oracle::Inside exactly() const {
    return [this](const Vec& point) { return oracle::winding_number(xyz_, corners_, turn_.rotate_back(point)) > 0.5L; };
  }
  // Whether any of some points, moved, is inside.
  [[nodiscard]] oracle::Holds roughly(const oracle::Features& body) const {
    return [this, points = body.points](const Vec& move) {
      return std::ranges::any_of(points, [&](const Vec& point) {
        return oracle::rough_winding_number(xyz_, corners_, oracle::rounded(turn_.rotate_back(point + move))) > 0.5;
      });
    };
  }

 private:
  oracle::Pose turn_;
  std::vector<double> xyz_;
  std::vector<std::uint32_t> corners_;
};

// Of a solid the library tells an interval: no way out is shorter than one end, and the other end is that of a way out.
void check_solid(const Played& played, const Side& a, const Side& b, const Meeting& meeting, const SolidInside& solid,
                 std::span<const oracle::Touch> touches) {
  abut_distance found{};
  ASSERT_EQ(
      abut_pair_distance(played.a.shape.get(), &played.scene.a, played.b.shape.get(), &played.scene.b, nullptr, &found),
      ABUT_OK)
      << "seed " << played.seed;
  // Ways of solids end where nothing overlaps by more than 2e-12 of the coordinates.
  const double tolerance = 3 * played.tolerance;
  const auto expect_at_most = [&](const char* fact, double off) {
    if (!(off <= tolerance)) broken(played, fact, off);
  };
  const double least =
      static_cast<double>(oracle::larger(least_depth(meeting), depth_of_points(a, b, solid.exactly())));
  if (!(least > tolerance)) {
    const double truth = static_cast<double>(meeting.distance);
    if (truth > 0) expect_at_most("the distance of the nearest parts", std::abs(found.distance - truth));
    return;
  }
  expect_at_most("a depth that no way out falls short of", found.lower + least);
  expect_at_most("a depth of at least what is inside", found.distance + least);
  double deepest = std::numeric_limits<double>::infinity();
  std::vector<Vec> hints{property::vec_of(found.normal)};
  for (const oracle::Touch& touch : touches) {
    deepest = std::min(deepest, touch.distance);
    hints.push_back(touch.normal);
  }
  expect_at_most("a deepest contact as deep as the whole", std::abs(deepest - found.distance));
  const oracle::WayOut way = shortest_way_out(a, b, meeting, hints, solid.roughly(b.parts.front().hull));
  if (way.is_known)
    expect_at_most("a way out no shorter than the bound", -found.upper - static_cast<double>(way.depth));
}

// Two answers of the oracle to one question.
void check_exactly(const Played& played, const Side& a, const Side& b, const Meeting& meeting) {
  if (a.radius + b.radius > 0) return;
  const auto corners = [](const oracle::Features& hull) {
    return oracle::Triple{hull.points[0], hull.points[1], hull.points[2]};
  };
  const auto is_triangle = [&](const oracle::Part& part) {
    return part.hull.points.size() == 3 && oracle::has_area(corners(part.hull));
  };
  bool meets = false;
  for (const oracle::Part& part : a.parts) {
    for (const oracle::Part& other : b.parts) {
      if (meets || !is_triangle(part) || oracle::gap_of_boxes(part, other, {}) > 0) continue;
      meets = is_triangle(other) ? oracle::meets(corners(part.hull), corners(other.hull))
                                 : oracle::meets(corners(part.hull), other.hull);
    }
  }
  const double off = 1e-24 * (played.a.size + played.b.size);
  const double distance = static_cast<double>(meeting.distance);
  if (meets ? distance > off : distance < -off) broken(played, "one answer of both oracles", std::abs(distance));
}

Played played(const SceneShape& a, const SceneShape& b, const SurfaceScene& scene, std::uint64_t seed) {
  const abut_vec3 &p = scene.a.position, &q = scene.b.position;
  const property::Magnitude m{a.size, b.size, length({p.x - q.x, p.y - q.y, p.z - q.z}),
                              std::max(length(p), length(q))};
  return {a, b, scene, seed, m, distance_tolerance(m)};
}

void check(const SceneShape& a, const SceneShape& b, Random& random, std::uint64_t seed) {
  const SurfaceScene scene = place_on(a, b, random);
  const Played play = played(a, b, scene, seed);
  const Vec origin = property::vec_of(scene.a.position);
  const Side side_a = side_of(a, scene.a, origin), side_b = side_of(b, scene.b, origin);
  const double margin = random() % 3 == 0 ? 0.2 * b.size : 0;
  const Meeting meeting = oracle::meeting_of(side_a, side_b, margin);
  std::vector<oracle::Touch> touches;
  for (const abut_contact& contact : contacts_of(play, margin)) {
    touches.push_back({property::vec_of(contact.point_a) - origin, property::vec_of(contact.point_b) - origin,
                       property::vec_of(contact.normal), contact.distance});
  }
  const SolidInside solid(a, scene.a);
  const oracle::Holds holds = a.is_solid ? solid.roughly(side_b.parts.front().hull) : oracle::Holds{};
  const oracle::Doubt doubt{play.tolerance, point_rounding(play.magnitude), 1e-6};
  for (const oracle::Fault& fault : judge_surface_contacts(side_a, side_b, meeting, touches, margin, doubt, holds)) {
    broken(play, fault.fact, fault.off, fault.is_angle);
  }
  if (a.is_solid) {
    check_solid(play, side_a, side_b, meeting, solid, touches);
  } else {
    check_distance(play, side_a, side_b, meeting, touches);
  }
  check_exactly(play, side_a, side_b, meeting);
  property::record().add(a.kind + "/" + b.kind + " " + scene.name, "seed " + std::to_string(seed), 0, 0,
                         static_cast<std::uint32_t>(touches.size()));
}

int times() {
  const char* wanted = std::getenv("ABUT_SURFACE_SCENES");
  return wanted != nullptr ? std::atoi(wanted) : 1;
}

// Plays scenes of one kind. `make` makes both shapes from the numbers of a seed.
template <class Make>
void play(std::uint64_t first_seed, int count, const Make& make) {
  for (int i = 0; i < count * times(); ++i) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
    Random random(seed);
    const double scale = std::pow(10, between(random, -3, 3));
    const auto [a, b] = make(random, scale);
    if (a.soup.triangles.empty()) continue;
    check(a, b, random, seed);
  }
}

constexpr std::array bodies{"sphere", "capsule", "segment", "triangle", "box", "hull"};

template <class Surface>
void play_bodies(std::uint64_t first_seed, const Surface& surface) {
  for (const char* body : bodies) {
    play(first_seed, 40, [&](Random& random, double scale) {
      SceneShape a = surface(random, scale);
      return std::pair(std::move(a), property::random_body(random, body, scale));
    });
    first_seed += 1000000;
  }
}

TEST(SurfaceOracle, AgreesAboutMeshesOfTwoSides) {
  play_bodies(100, [](Random& random, double scale) { return property::random_mesh(random, ABUT_SIDES_BOTH, scale); });
}

TEST(SurfaceOracle, AgreesAboutMeshesOfOneSide) {
  play_bodies(20000,
              [](Random& random, double scale) { return property::random_mesh(random, ABUT_SIDES_FRONT, scale); });
}

TEST(SurfaceOracle, AgreesAboutGridsOfCells) {
  play_bodies(40000,
              [](Random& random, double scale) { return property::random_uv_grid(random, ABUT_SIDES_BOTH, scale); });
}

TEST(SurfaceOracle, AgreesAboutHeightFields) {
  play_bodies(60000, [](Random& random, double scale) { return property::random_height_field(random, scale); });
}

TEST(SurfaceOracle, AgreesAboutSolidMeshes) {
  play_bodies(120000, [](Random& random, double scale) { return property::random_solid(random, scale); });
}

// The second one is the smaller one of two surfaces.
template <class First, class Second>
void play_two(std::uint64_t first_seed, int count, const First& first, const Second& second) {
  play(first_seed, count, [&](Random& random, double scale) {
    SceneShape a = first(random, scale);
    return std::pair(std::move(a), second(random, scale * between(random, 0.3, 1)));
  });
}
SceneShape sheet(Random& random, double scale) { return property::random_mesh(random, ABUT_SIDES_BOTH, scale); }
SceneShape front(Random& random, double scale) { return property::random_mesh(random, ABUT_SIDES_FRONT, scale); }
SceneShape cells(Random& random, double scale) { return property::random_uv_grid(random, ABUT_SIDES_BOTH, scale); }

TEST(SurfaceOracle, AgreesAboutTwoMeshes) { play_two(80000, 60, sheet, sheet); }
TEST(SurfaceOracle, AgreesAboutFrontsAndMeshes) {
  play_two(81000, 40, front, sheet);
  play_two(82000, 40, sheet, front);
  play_two(83000, 40, front, front);
}
TEST(SurfaceOracle, AgreesAboutMeshesAndGridsOfCells) {
  play_two(84000, 40, cells, sheet);
  play_two(85000, 40, cells, cells);
}
TEST(SurfaceOracle, AgreesAboutMeshesAndHeightFields) {
  play_two(86000, 40, property::random_height_field, sheet);
  play_two(87000, 40, property::random_height_field, property::random_height_field);
}

}  // namespace

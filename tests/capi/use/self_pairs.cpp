// SPDX-License-Identifier: Apache-2.0
// Geometries that meet themselves, against all pairs of what they are made of.
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr double infinity = std::numeric_limits<double>::infinity();

using Indices = std::pair<std::uint32_t, std::uint32_t>;

double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
abut_vec3 minus(const abut_vec3& a, const abut_vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
abut_vec3 along(const abut_vec3& a, double t, const abut_vec3& d) {
  return {a.x + t * d.x, a.y + t * d.y, a.z + t * d.z};
}
abut_vec3 cross(const abut_vec3& a, const abut_vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const abut_vec3& a) { return std::sqrt(dot(a, a)); }
bool are_equal(const abut_vec3& a, const abut_vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

using Triangle = std::array<abut_vec3, 3>;

// Where a line through a triangle of some area passes, as the share of the way from p to q; nothing beside it.
bool crosses(const abut_vec3& p, const abut_vec3& q, const Triangle& t) {
  const abut_vec3 normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  const double from = dot(normal, minus(p, t[0])), to = dot(normal, minus(q, t[0]));
  if (!(from * to < 0)) return false;
  const abut_vec3 at_plane = along(p, from / (from - to), minus(q, p));
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(normal, cross(minus(t.at((i + 1) % 3), t.at(i)), minus(at_plane, t.at(i)))) < 0) return false;
  }
  return true;
}
bool cross_each_other(const Triangle& a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (crosses(a.at(i), a.at((i + 1) % 3), b) || crosses(b.at(i), b.at((i + 1) % 3), a)) return true;
  }
  return false;
}

double clamped(double t) { return std::min(std::max(t, 0.0), 1.0); }
double to_segment(const abut_vec3& p, const abut_vec3& a, const abut_vec3& b) {
  const abut_vec3 d = minus(b, a);
  return length(minus(p, along(a, clamped(dot(minus(p, a), d) / dot(d, d)), d)));
}
// Of two segments: at ends, or where both lines are closest.
double between_segments(const abut_vec3& p, const abut_vec3& q, const abut_vec3& a, const abut_vec3& b) {
  double least =
      std::min(std::min(to_segment(p, a, b), to_segment(q, a, b)), std::min(to_segment(a, p, q), to_segment(b, p, q)));
  const abut_vec3 d = minus(q, p), e = minus(b, a), w = minus(p, a);
  const double dd = dot(d, d), de = dot(d, e), ee = dot(e, e), determinant = dd * ee - de * de;
  if (determinant > 0) {
    const double s = (de * dot(e, w) - ee * dot(d, w)) / determinant,
                 t = (dd * dot(e, w) - de * dot(d, w)) / determinant;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) least = std::min(least, length(minus(along(p, s, d), along(a, t, e))));
  }
  return least;
}
// To the inside of a triangle; what is beside it is nearer to an edge.
double to_inside(const abut_vec3& p, const Triangle& t) {
  const abut_vec3 normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(normal, cross(minus(t.at((i + 1) % 3), t.at(i)), minus(p, t.at(i)))) < 0) return infinity;
  }
  return std::fabs(dot(normal, minus(p, t[0]))) / length(normal);
}
double between(const Triangle& a, const Triangle& b) {
  double least = infinity;
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min({least, to_inside(a.at(i), b), to_inside(b.at(i), a)});
    for (std::size_t j = 0; j < 3; ++j) {
      least = std::min(least, between_segments(a.at(i), a.at((i + 1) % 3), b.at(j), b.at((j + 1) % 3)));
    }
  }
  return least;
}
bool are_neighbours(const Triangle& a, const Triangle& b) {
  return std::any_of(a.begin(), a.end(), [&](const abut_vec3& corner) {
    return std::any_of(b.begin(), b.end(), [&](const abut_vec3& other) { return are_equal(corner, other); });
  });
}

struct Mesh {
  std::vector<double> xyz;
  std::vector<std::uint32_t> indices;

  std::size_t size() const { return indices.size() / 3; }
  abut_vec3 vertex(std::size_t i) const { return {xyz.at(3 * i), xyz.at(3 * i + 1), xyz.at(3 * i + 2)}; }
  Triangle triangle(std::size_t i) const {
    return {vertex(indices.at(3 * i)), vertex(indices.at(3 * i + 1)), vertex(indices.at(3 * i + 2))};
  }
  Shape shape() const {
    abut_shape* out = nullptr;
    require(abut_mesh_create(xyz.data(), xyz.size() / 3, indices.data(), size(), nullptr, &out));
    return Shape(out);
  }
};

// A sheet of 2 * side * side triangles whose vertices have been thrown about, so that it passes through itself.
Mesh crumpled(unsigned seed, std::uint32_t side) {
  std::mt19937 random(seed);
  const auto noise = [&] { return 2.0 * double(random()) / double(random.max()) - 1; };
  Mesh mesh;
  for (std::uint32_t i = 0; i <= side; ++i) {
    for (std::uint32_t j = 0; j <= side; ++j) mesh.xyz.insert(mesh.xyz.end(), {i + noise(), j + noise(), noise()});
  }
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const std::uint32_t a = i * (side + 1) + j, b = a + side + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  return mesh;
}
Mesh flat(std::uint32_t side) {
  Mesh mesh = crumpled(1, side);
  for (std::size_t i = 0; i < mesh.xyz.size() / 3; ++i) {
    mesh.xyz.at(3 * i) = double(i / (side + 1));
    mesh.xyz.at(3 * i + 1) = double(i % (side + 1));
    mesh.xyz.at(3 * i + 2) = 0;
  }
  return mesh;
}

abut_geometry_options with_self_pairs(double tolerance = 0) {
  abut_geometry_options options = default_geometry_options();
  options.flags = ABUT_GEOMETRY_SELF_PAIRS;
  options.tolerance = tolerance;
  return options;
}
abut_universe_options all_contacts(abut_tolerance_mode mode, std::uint32_t threads = 1) {
  abut_universe_options options = default_universe_options();
  options.max_contacts = 0;
  options.tolerance_mode = mode;
  options.threads = threads_of_build(threads);
  return options;
}

// The least distance of each two faces that are reported.
std::map<Indices, double> faces_of(const std::vector<abut_contact>& contacts) {
  std::map<Indices, double> found;
  for (const abut_contact& contact : contacts) {
    EXPECT_TRUE(contact.geometry_a == contact.geometry_b);
    EXPECT_EQ(contact.feature_a.kind, abut_feature_kind{ABUT_FEATURE_FACE});
    EXPECT_EQ(contact.feature_b.kind, abut_feature_kind{ABUT_FEATURE_FACE});
    EXPECT_LT(contact.feature_a.index, contact.feature_b.index);
    double& least = found.try_emplace({contact.feature_a.index, contact.feature_b.index}, infinity).first->second;
    least = std::min(least, contact.distance);
  }
  return found;
}

TEST(SelfPairs, OfAMeshAreTheTrianglesThatCross) {
  for (const unsigned seed : {3U, 4U, 5U, 6U}) {
    const Mesh mesh = crumpled(seed, 9);
    const abut_universe_options options = all_contacts(ABUT_TOLERANCE_DEAD_BAND);
    Universe universe(&options);
    const abut_part_id part = universe.add_part({{3, -2, 5}, {0.5, 0.5, -0.5, 0.5}});
    universe.add_geometry(part, mesh.shape(), with_self_pairs());
    const std::map<Indices, double> found = faces_of(universe.step());
    std::size_t expected = 0;
    for (std::uint32_t i = 0; i < mesh.size(); ++i) {
      for (std::uint32_t j = i + 1; j < mesh.size(); ++j) {
        const Triangle a = mesh.triangle(i), b = mesh.triangle(j);
        const bool is_expected = !are_neighbours(a, b) && cross_each_other(a, b);
        expected += is_expected ? 1 : 0;
        EXPECT_EQ(found.contains({i, j}), is_expected) << i << " and " << j << " of seed " << seed;
      }
    }
    EXPECT_GT(expected, 20U) << "or the test means little";
    EXPECT_EQ(universe.stats().touching_pairs, 1U);
  }
}

TEST(SelfPairs, OfAMeshComeWithinTheMarginAtTheirDistance) {
  constexpr double tolerance = 0.1;  // of the geometry, so that the margin is twice that
  for (const unsigned seed : {13U, 14U}) {
    const Mesh mesh = crumpled(seed, 7);
    const abut_universe_options options = all_contacts(ABUT_TOLERANCE_MARGIN);
    Universe universe(&options);
    universe.add_geometry(universe.add_part(identity), mesh.shape(), with_self_pairs(tolerance));
    const std::map<Indices, double> found = faces_of(universe.step());
    std::size_t apart = 0;
    for (std::uint32_t i = 0; i < mesh.size(); ++i) {
      for (std::uint32_t j = i + 1; j < mesh.size(); ++j) {
        const Triangle a = mesh.triangle(i), b = mesh.triangle(j);
        const bool do_cross = cross_each_other(a, b);
        const double distance = do_cross ? 0 : between(a, b);
        if (are_neighbours(a, b)) {
          EXPECT_FALSE(found.contains({i, j}));
        } else if (std::fabs(distance - 2 * tolerance) > 1e-9) {
          ASSERT_EQ(found.contains({i, j}), distance < 2 * tolerance) << i << " and " << j << " at " << distance;
        }
        if (!do_cross && found.contains({i, j})) {
          ++apart;
          EXPECT_NEAR(found.at({i, j}), distance, 1e-9) << i << " and " << j << " of seed " << seed;
        }
      }
    }
    EXPECT_GT(apart, 20U);
  }
}

// Neighbours touch wherever a surface lies, whether they share their vertices or have equal ones.
TEST(SelfPairs, OfAFlatMeshAreNone) {
  Mesh mesh = flat(6), split;
  for (const std::uint32_t index : mesh.indices) {
    split.indices.push_back(static_cast<std::uint32_t>(split.indices.size()));
    const abut_vec3 place = mesh.vertex(index);
    split.xyz.insert(split.xyz.end(), {place.x, place.y, place.z});
  }
  for (const Mesh* each : {&mesh, &split}) {
    Universe universe;
    universe.add_geometry(universe.add_part(identity), each->shape(), with_self_pairs());
    EXPECT_TRUE(universe.step().empty());
    EXPECT_EQ(universe.stats().examined_pairs, 1U);
  }
}

void expect_particles(bool have_own_radii, abut_tolerance_mode mode, double tolerance) {
  constexpr unsigned seed = 21;
  constexpr std::size_t count = 300;
  std::mt19937 random(seed);
  const auto share = [&] { return double(random()) / double(random.max()); };
  std::vector<double> reals;
  for (std::size_t i = 0; i < count; ++i) {
    reals.insert(reals.end(), {6 * share(), 6 * share(), 6 * share()});
    if (have_own_radii) reals.push_back(0.1 + 0.4 * share());
  }
  const std::size_t stride = have_own_radii ? 4 : 3;
  const auto radius = [&](std::size_t i) { return have_own_radii ? reals.at(stride * i + 3) : 0.3; };
  const auto place = [&](std::size_t i) {
    // As the part below turns it: (x, y, z) to (y, z, x), and moves it.
    return abut_vec3{1 + reals.at(stride * i + 1), reals.at(stride * i + 2), reals.at(stride * i)};
  };
  const abut_universe_options options = all_contacts(mode);
  Universe universe(&options);
  const Shape shape = make_of_kind("particles", {have_own_radii ? 0 : 0.3}, reals);
  universe.add_geometry(universe.add_part({{1, 0, 0}, {0.5, -0.5, -0.5, -0.5}}), shape, with_self_pairs(tolerance));
  std::map<Indices, abut_contact> found;
  for (const abut_contact& contact : universe.step()) {
    EXPECT_TRUE(found.emplace(Indices{contact.child_a, contact.child_b}, contact).second) << "each pair once";
  }
  std::size_t expected = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t j = i + 1; j < count; ++j) {
      const abut_vec3 apart = minus(place(j), place(i));
      const double distance = length(apart) - radius(i) - radius(j);
      const double most = mode == ABUT_TOLERANCE_MARGIN ? 2 * tolerance : -2 * tolerance;
      ASSERT_EQ(found.contains({i, j}), distance < most)
          << i << " and " << j << " at " << distance << ", seed " << seed;
      if (distance < most) {
        ++expected;
        EXPECT_NEAR(found.at({i, j}).distance, distance, 1e-12);
        EXPECT_NEAR(dot(found.at({i, j}).normal, apart), length(apart), 1e-12) << "from the lower to the higher";
      }
    }
  }
  EXPECT_EQ(found.size(), expected);
  EXPECT_GT(expected, 50U);
}

TEST(SelfPairs, OfParticlesAreThoseThatOverlap) {
  for (const bool have_own_radii : {false, true}) {
    expect_particles(have_own_radii, ABUT_TOLERANCE_DEAD_BAND, 0);
    expect_particles(have_own_radii, ABUT_TOLERANCE_DEAD_BAND, 0.02);
    expect_particles(have_own_radii, ABUT_TOLERANCE_MARGIN, 0.05);
  }
}

// More contacts than are looked through one by one, from step to step.
TEST(SelfPairs, OfManyMovingParticlesAgeAndEnd) {
  constexpr unsigned seed = 22;
  constexpr std::size_t count = 1500;
  constexpr double radius = 0.3;
  std::mt19937 random(seed);
  const auto share = [&] { return double(random()) / double(random.max()); };
  std::vector<double> xyz;
  for (std::size_t i = 0; i < 3 * count; ++i) xyz.push_back(9 * share());
  abut_universe_options options = default_universe_options();
  options.events = ABUT_EVENTS_CONTACTS;
  Universe universe(&options);
  const abut_geometry_id geometry =
      universe.add_geometry(universe.add_part(identity), make_of_kind("particles", {radius}, xyz), with_self_pairs());
  std::map<Indices, std::uint32_t> ages;
  for (int step = 0; step < 4; ++step) {
    std::map<Indices, std::uint32_t> expected;
    std::size_t fresh = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t j = i + 1; j < count; ++j) {
        const auto place = [&](std::size_t k) {
          return abut_vec3{xyz.at(3 * k), xyz.at(3 * k + 1), xyz.at(3 * k + 2)};
        };
        if (length(minus(place(j), place(i))) < 2 * radius) {
          const auto before = ages.find({i, j});
          expected[{i, j}] = before == ages.end() ? 0 : before->second + 1;
          fresh += before == ages.end() ? 1 : 0;
        }
      }
    }
    std::map<Indices, std::uint32_t> found;
    double deepest = -infinity;
    for (const abut_contact& contact : universe.step()) {
      found[{contact.child_a, contact.child_b}] = contact.age;
      EXPECT_GE(contact.distance, deepest) << "the deepest first";
      deepest = contact.distance;
    }
    EXPECT_EQ(found, expected) << "seed " << seed << ", step " << step;
    EXPECT_GT(expected.size(), 300U);
    std::size_t begins = 0, ends = 0;
    for (const abut_event& event : universe.events()) {
      begins += event.kind == ABUT_EVENT_BEGIN ? 1 : 0;
      ends += event.kind == ABUT_EVENT_END ? 1 : 0;
    }
    EXPECT_EQ(begins, fresh);
    EXPECT_EQ(ends, ages.size() + fresh - expected.size());
    ages = std::move(expected);
    for (double& coordinate : xyz) coordinate += 0.1 * share() - 0.05;
    ASSERT_TRUE(succeeded(abut_geometry_set_particles(universe, geometry, 0, xyz.data(), nullptr, count)));
  }
}

Shape two_balls() { return make_of_kind("particles", {1}, {0, 0, 0, 1.5, 0, 0}); }

TEST(SelfPairs, BeginPersistAndEnd) {
  abut_universe_options options = default_universe_options();
  options.events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST | ABUT_EVENTS_CONTACTS;
  Universe universe(&options);
  const Shape balls = two_balls(), other = make_of_kind("particles", {1}, {0, 0, 0, 9, 0, 0});
  const abut_part_id part = universe.add_part(identity);
  const abut_geometry_id geometry = universe.add_geometry(part, balls, with_self_pairs());
  EXPECT_EQ(universe.step().size(), 1U);
  EXPECT_EQ(letters_of(universe.events()), "bbc");
  EXPECT_TRUE(universe.events().front().geometry_a == geometry && universe.events().front().geometry_b == geometry);
  universe.step();
  EXPECT_EQ(letters_of(universe.events()), "ppc");
  EXPECT_EQ(universe.stats().kept_pairs, 1U) << "nothing has changed";
  universe.move(part, at(5, 0, 0));
  EXPECT_EQ(universe.step().front().age, 2U);
  EXPECT_EQ(letters_of(universe.events()), "ppc");
  universe.park(geometry, ABUT_PARKING_SHORT_TERM);
  EXPECT_TRUE(universe.step().empty());
  EXPECT_EQ(letters_of(universe.events()), "eec");
  universe.park(geometry, ABUT_PARKING_NONE);
  universe.step();
  EXPECT_EQ(letters_of(universe.events()), "bbc");
  require(abut_geometry_set_shape(universe, geometry, other));
  EXPECT_TRUE(universe.step().empty());
  EXPECT_EQ(letters_of(universe.events()), "eec");
  require(abut_geometry_set_shape(universe, geometry, balls));
  EXPECT_EQ(universe.step().size(), 1U);
  const abut_geometry_options plain = default_geometry_options();
  require(abut_geometry_set_options(universe, geometry, &plain));
  EXPECT_TRUE(universe.step().empty());
  EXPECT_EQ(letters_of(universe.events()), "eec");
  EXPECT_EQ(universe.describe(geometry).flags, 0U);
  const abut_geometry_options again = with_self_pairs();
  require(abut_geometry_set_options(universe, geometry, &again));
  EXPECT_EQ(universe.describe(geometry).flags, std::uint32_t{ABUT_GEOMETRY_SELF_PAIRS});
  EXPECT_EQ(universe.step().size(), 1U);
  require(abut_part_destroy(universe, part));
  EXPECT_TRUE(universe.step().empty());
  EXPECT_EQ(letters_of(universe.events()), "eec");
}

TEST(SelfPairs, ComeBeforeThePairsWithOthers) {
  Universe universe;
  const Shape balls = two_balls();
  std::vector<abut_geometry_id> all;
  for (const bool meets_itself : {true, false, true}) {
    all.push_back(universe.add_geometry(universe.add_part(at(0, 0.1 * double(all.size()), 0)), balls,
                                        meets_itself ? with_self_pairs() : default_geometry_options()));
  }
  universe.step();
  std::vector<Indices> pairs;
  for (const abut_event& event : universe.events()) pairs.emplace_back(event.geometry_a.slot, event.geometry_b.slot);
  const auto [a, b, c] = std::array{all[0].slot, all[1].slot, all[2].slot};
  EXPECT_EQ(pairs, (std::vector<Indices>{{a, a}, {a, b}, {a, c}, {b, c}, {c, c}}));
}

struct Asked {
  std::vector<Indices> pairs;
  bool keeps = true;
};
std::uint32_t ask(void* context, const abut_universe*, abut_geometry_id a, abut_geometry_id b) {
  Asked& asked = *static_cast<Asked*>(context);
  asked.pairs.emplace_back(a.slot, b.slot);
  return asked.keeps ? 1 : 0;
}

TEST(SelfPairs, AreSeenByTheFilterAndByRules) {
  Universe universe;
  const abut_geometry_id geometry = universe.add_geometry(universe.add_part(identity), two_balls(), with_self_pairs());
  Asked asked;
  require(abut_universe_set_filter(universe, ask, &asked));
  EXPECT_EQ(universe.step().size(), 1U);
  EXPECT_EQ(asked.pairs, (std::vector<Indices>{{geometry.slot, geometry.slot}}));
  asked.keeps = false;
  require(abut_universe_refilter(universe));
  EXPECT_TRUE(universe.step().empty());
  EXPECT_EQ(universe.stats().filtered_pairs, 1U);
  require(abut_universe_set_filter(universe, nullptr, nullptr));
  EXPECT_EQ(universe.step().size(), 1U);
  const abut_collidable it{ABUT_COLLIDABLE_GEOMETRY, geometry.slot, geometry.generation};
  require(abut_rule_set(universe, &it, &it, ABUT_RULE_DISABLE));
  EXPECT_TRUE(universe.step().empty());
}

TEST(SelfPairs, DoNotDependOnLayersNorOnHowThePartMoves) {
  for (const abut_motion motion : {ABUT_MOTION_DYNAMIC, ABUT_MOTION_ANIMATED, ABUT_MOTION_STATIC}) {
    Universe universe;
    abut_geometry_options options = with_self_pairs();
    options.mask = 0;
    options.exclusion = 1;
    universe.add_geometry(universe.add_part(identity, motion), two_balls(), options);
    EXPECT_EQ(universe.step().size(), 1U) << motion;
  }
}

TEST(SelfPairs, OfASensorAreFlagged) {
  Universe universe;
  abut_geometry_options options = with_self_pairs();
  options.flags |= ABUT_GEOMETRY_SENSOR;
  universe.add_geometry(universe.add_part(identity), two_balls(), options);
  EXPECT_EQ(universe.step().front().flags, std::uint32_t{ABUT_CONTACT_SENSOR});
}

TEST(SelfPairs, AreTheSameBitsForAnyNumberOfThreads) {
  std::array<std::uint64_t, 2> hashes{};
  for (const std::size_t run : {0U, 1U}) {
    const abut_universe_options options = all_contacts(ABUT_TOLERANCE_MARGIN, run == 0 ? 1 : 4);
    Universe universe(&options);
    const Shape sheet = crumpled(9, 5).shape(), balls = two_balls();
    std::vector<abut_part_id> parts;
    for (int i = 0; i < 40; ++i) {
      parts.push_back(universe.add_part(at(2.0 * i, 0, 0)));
      universe.add_geometry(parts.back(), i % 2 == 0 ? sheet : balls, with_self_pairs(0.01 * i));
    }
    for (int step = 0; step < 5; ++step) {
      for (const abut_part_id part : parts) universe.move(part, at(1.9 * part.slot, 0.1 * step, 0));
      universe.step();
      hashes.at(run) = hashes.at(run) * 31 + universe.hash();
    }
    EXPECT_GT(universe.stats().contacts, 100U);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(SelfPairs, OfAShapeThatCannotMeetItselfAreUnsupportedPairs) {
  Universe universe;
  const Shape ball = make_sphere(1);
  const abut_geometry_id geometry = universe.add_geometry(universe.add_part(identity), two_balls(), with_self_pairs());
  EXPECT_EQ(universe.step().size(), 1U);
  require(abut_geometry_set_shape(universe, geometry, ball));
  EXPECT_TRUE(universe.step().empty());
  EXPECT_EQ(universe.stats().unsupported_pairs, 1U);
}

TEST(SelfPairs, AreToldByThePlan) {
  Universe universe;
  const auto text = [&] {
    std::size_t needed = 0;
    require(abut_universe_explain(universe, nullptr, 0, &needed));
    std::string out(needed, '?');
    require(abut_universe_explain(universe, out.data(), out.size(), &needed));
    return out;
  };
  EXPECT_NE(text().find("  self pairs: switched on for no geometry\n"), std::string::npos);
  universe.add_geometry(universe.add_part(identity), two_balls(), with_self_pairs());
  universe.step();
  EXPECT_EQ(text().find("self pairs"), std::string::npos);
  EXPECT_NE(text().find("  particles - itself: 1 candidate, 1 examined, 1 touching, 1 contact"), std::string::npos)
      << text();
}

}  // namespace

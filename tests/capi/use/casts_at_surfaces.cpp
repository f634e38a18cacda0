// SPDX-License-Identifier: Apache-2.0
// Casts against surfaces: the same from a universe and from a pair call, whichever side moves. For points it is the
// crossing of a straight line with the triangles.
#include <cmath>
#include <optional>
#include <random>

#include "support.hpp"

namespace {

using namespace abut_test;

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed) {}
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(random_() % count); }
  double between(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
  abut_quat turn() {
    const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1), w = between(0.1, 1);
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    return {w / length, x / length, y / length, z / length};
  }

 private:
  std::mt19937_64 random_;
};

abut_vec3 plus(const abut_vec3& a, const abut_vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
abut_vec3 times(double s, const abut_vec3& v) { return {s * v.x, s * v.y, s * v.z}; }
abut_vec3 minus(const abut_vec3& a, const abut_vec3& b) { return plus(a, times(-1, b)); }
double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
abut_vec3 cross(const abut_vec3& a, const abut_vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Triangle = std::array<abut_vec3, 3>;

struct Surface {
  Shape shape;
  std::vector<Triangle> triangles;
  bool is_one_sided;
  double wide, high;  // of the grid
};

std::vector<Triangle> triangles_of(const abut_shape* shape, std::vector<double>& xyz,
                                   std::vector<std::uint32_t>& indices) {
  std::size_t vertices = 0, count = 0;
  require(abut_shape_triangles(shape, nullptr, 0, &vertices, nullptr, 0, &count));
  xyz.resize(3 * vertices);
  indices.resize(3 * count);
  require(abut_shape_triangles(shape, xyz.data(), vertices, &vertices, indices.data(), count, &count));
  std::vector<Triangle> triangles(count);
  for (std::size_t i = 0; i < 3 * count; ++i) {
    const std::size_t at = 3 * std::size_t{indices[i]};
    triangles[i / 3].at(i % 3) = {xyz[at], xyz[at + 1], xyz[at + 2]};
  }
  return triangles;
}

// A height field, or a mesh of its triangles.
Surface make_surface(Numbers& random) {
  const std::uint32_t columns = 2 + random.below(5), rows = 2 + random.below(5);
  const double x = random.between(0.2, 1.5), y = random.between(0.2, 1.5);
  std::vector<double> heights(std::size_t{columns} * rows), xyz;
  std::generate(heights.begin(), heights.end(), [&] { return random.between(-0.6, 0.6); });
  std::vector<std::uint32_t> indices;
  Shape field = make_of_kind("height_field", {double(columns), double(rows), x, y}, heights);
  std::vector<Triangle> triangles = triangles_of(field, xyz, indices);
  const std::uint32_t sides = random.below(3);
  if (sides < 2) field = make_of_kind("mesh", {double(sides)}, xyz, indices);
  return {std::move(field), std::move(triangles), sides > 0, (columns - 1) * x, (rows - 1) * y};
}

struct Cast {
  abut_pose pose;
  abut_vec3 displacement;
};

Cast make_cast(const Surface& surface, Numbers& random) {
  const abut_vec3 start{random.between(-0.2, surface.wide + 0.2), random.between(-0.2, surface.high + 0.2),
                        random.between(-1.5, 1.5)};
  const double length = random.between(0.5, 3);
  switch (random.below(3)) {
    case 0: return {{start, no_rotation}, {0, 0, -length}};
    case 1: return {{start, no_rotation}, times(length, {random.between(-0.3, 0.3), random.between(-0.3, 0.3), -1})};
    default:
      return {{start, no_rotation},
              times(length, {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)})};
  }
}

struct Crossing {
  double fraction = 2;
  bool is_clear = true;  // not near an edge, an end or a plane along the way
};

// The first crossing with a side that stops.
Crossing crossing_of(const Surface& surface, const Cast& cast) {
  constexpr double near = 1e-7;
  Crossing first;
  for (const auto& [a, b, c] : surface.triangles) {
    const abut_vec3 normal = cross(minus(b, a), minus(c, a));
    const double square = dot(normal, normal), against = dot(normal, cast.displacement);
    const double fraction = dot(normal, minus(a, cast.pose.position)) / against;
    const abut_vec3 point = plus(cast.pose.position, times(fraction, cast.displacement));
    const double inside =
        std::min({dot(normal, cross(minus(b, a), minus(point, a))), dot(normal, cross(minus(c, b), minus(point, b))),
                  dot(normal, cross(minus(a, c), minus(point, c)))});
    if (!(fraction > -near && fraction < 1 + near && inside > -near * square)) continue;
    first.is_clear = first.is_clear && inside > near * square && fraction > near && fraction < 1 - near &&
                     std::abs(against) > 1e-6 * std::sqrt(square * dot(cast.displacement, cast.displacement));
    if (!surface.is_one_sided || against < 0) first.fraction = std::min(first.fraction, fraction);
  }
  return first;
}

struct Answer {
  bool is_met = false;
  abut_cast_hit hit{};
};

Answer ask_pair(const abut_shape* a, const Cast& of_a, const abut_shape* b, const Cast& of_b) {
  Answer answer;
  std::uint32_t found = 0;
  require(abut_pair_cast(a, &of_a.pose, &of_a.displacement, b, &of_b.pose, &of_b.displacement, nullptr, &answer.hit,
                         &found));
  answer.is_met = found == 1;
  return answer;
}

TEST(CastOfAPoint, MeetsTheFirstSideThatStops) {
  constexpr std::uint64_t seed = 5;
  SCOPED_TRACE(seed);
  Numbers random(seed);
  const Shape point = make_of_kind("point", {});
  int met = 0;
  for (int i = 0; i < 12000; ++i) {
    const Surface surface = make_surface(random);
    const Cast cast = make_cast(surface, random);
    const Crossing crossing = crossing_of(surface, cast);
    if (!crossing.is_clear) continue;
    const Cast still{identity, {0, 0, 0}}, back{identity, times(-1, cast.displacement)};
    for (const Answer& answer :
         {ask_pair(point, cast, surface.shape, still), ask_pair(point, {cast.pose, {0, 0, 0}}, surface.shape, back)}) {
      ASSERT_EQ(answer.is_met, crossing.fraction < 2) << "cast " << i;
      if (answer.is_met) {
        ASSERT_NEAR(answer.hit.fraction, crossing.fraction, 1e-9) << "cast " << i;
        ASSERT_GT(dot(answer.hit.contact.normal, cast.displacement), 0) << "cast " << i;
        ++met;
      }
    }
  }
  EXPECT_GT(met, 4000);
}

// Near the origin and two thousand kilometres away, turned and not.
TEST(CastOfAUniverse, IsThatOfThePair) {
  constexpr std::uint64_t seed = 6;
  SCOPED_TRACE(seed);
  Numbers random(seed);
  int met = 0;
  for (int i = 0; i < 6000; ++i) {
    const Surface surface = make_surface(random);
    const double far = random.below(2) == 0 ? 0 : 2e6;
    const abut_vec3 place{far * random.between(-1, 1), far * random.between(-1, 1), far * random.between(-1, 1)};
    const Cast still{{place, random.below(2) == 0 ? no_rotation : random.turn()}, {0, 0, 0}};
    Cast cast = make_cast(surface, random);
    cast.pose = {plus(cast.pose.position, place), random.turn()};
    const std::array shapes{make_of_kind("point", {}), make_sphere(random.between(0.01, 0.5)),
                            make_box(0.1, random.between(0.1, 0.4), 0.2)};
    Universe universe;
    universe.add(surface.shape, still.pose, ABUT_MOTION_STATIC);
    require(abut_universe_refresh(universe));
    for (const Shape& shape : shapes) {
      const Answer pair = ask_pair(shape, cast, surface.shape, still);
      abut_cast_hit hit{};
      std::size_t count = 0;
      require(abut_universe_cast_shape(universe, shape, &cast.pose, &cast.displacement, nullptr, ABUT_HIT_NEAREST, &hit,
                                       1, &count));
      ASSERT_EQ(count, pair.is_met ? 1U : 0U) << "cast " << i;
      ASSERT_EQ(hit.fraction, pair.hit.fraction) << "cast " << i;
      const Answer other =
          ask_pair(surface.shape, {still.pose, times(-1, cast.displacement)}, shape, {cast.pose, {0, 0, 0}});
      ASSERT_EQ(other.is_met, pair.is_met) << "cast " << i;
      ASSERT_NEAR(other.hit.fraction, pair.hit.fraction, 1e-9 + 1e-13 * far) << "cast " << i;
      met += pair.is_met ? 1 : 0;
    }
  }
  EXPECT_GT(met, 3000);
}

}  // namespace

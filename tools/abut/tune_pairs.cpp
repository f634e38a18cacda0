// SPDX-License-Identifier: Apache-2.0
#include "tune_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace cli {
namespace {

// The distributions of the standard library differ from one library to the next.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  // A direction times a length of at most 1, away from 0.
  abut_vec3 in_ball() {
    for (;;) {
      const abut_vec3 v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      const double square = v.x * v.x + v.y * v.y + v.z * v.z;
      if (square > 0.01 && square < 1) {
        return v;
      }
    }
  }
  abut_quat orientation() {
    for (;;) {
      const abut_quat q{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
      if (length > 0.1 && length < 1) {
        return {q.w / length, q.x / length, q.y / length, q.z / length};
      }
    }
  }

 private:
  std::mt19937_64 engine_;
};

double length_of(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

using Make = SizedShape (*)(Random& random);

template <class Create>
SizedShape made(double diameter, Create&& create) {
  abut_shape* shape = nullptr;
  check(create(&shape), "cannot make a shape to measure");
  return {ShapeOwner(shape), diameter};
}

SizedShape make_sphere(Random& random) {
  const double radius = random.uniform(0.5, 1.5);
  return made(2 * radius, [&](abut_shape** out) { return abut_sphere_create(radius, out); });
}
SizedShape make_capsule(Random& random) {
  const double radius = random.uniform(0.3, 0.8), half = random.uniform(0.3, 0.8);
  return made(2 * (radius + half), [&](abut_shape** out) { return abut_capsule_create(radius, half, out); });
}
SizedShape make_box(Random& random) {
  const double x = random.uniform(0.3, 1), y = random.uniform(0.3, 1), z = random.uniform(0.3, 1);
  return made(2 * length_of(x, y, z), [&](abut_shape** out) { return abut_box_create(x, y, z, out); });
}
SizedShape make_cylinder(Random& random) {
  const double radius = random.uniform(0.3, 1), half = random.uniform(0.3, 1);
  return made(2 * std::hypot(radius, half), [&](abut_shape** out) { return abut_cylinder_create(radius, half, out); });
}
SizedShape make_cone(Random& random) {
  const double radius = random.uniform(0.3, 1), half = random.uniform(0.3, 1);
  return made(std::max(2 * radius, std::hypot(radius, 2 * half)),
              [&](abut_shape** out) { return abut_cone_create(radius, half, out); });
}
SizedShape make_ellipsoid(Random& random) {
  const double x = random.uniform(0.5, 1.5), y = random.uniform(0.5, 1.5), z = random.uniform(0.5, 1.5);
  return made(2 * std::max({x, y, z}), [&](abut_shape** out) { return abut_ellipsoid_create(x, y, z, out); });
}
SizedShape make_hull(Random& random) {
  constexpr std::size_t point_count = 32;
  const double x = random.uniform(0.5, 1.5), y = random.uniform(0.5, 1.5), z = random.uniform(0.5, 1.5);
  std::vector<double> xyz;
  for (std::size_t i = 0; i < point_count; ++i) {
    const abut_vec3 v = random.in_ball();
    const double length = length_of(v.x, v.y, v.z);
    xyz.insert(xyz.end(), {x * v.x / length, y * v.y / length, z * v.z / length});
  }
  double diameter = 0;
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    for (std::size_t j = 0; j < i; j += 3) {
      diameter = std::max(diameter, length_of(xyz[i] - xyz[j], xyz[i + 1] - xyz[j + 1], xyz[i + 2] - xyz[j + 2]));
    }
  }
  return made(diameter, [&](abut_shape** out) { return abut_hull_create(xyz.data(), point_count, out); });
}

struct Kind {
  std::string_view name;
  Make make;
  bool is_curved;
};
constexpr std::array<Kind, 7> kinds{{{"sphere", make_sphere, false},
                                     {"capsule", make_capsule, false},
                                     {"box", make_box, false},
                                     {"cylinder", make_cylinder, true},
                                     {"cone", make_cone, true},
                                     {"ellipsoid", make_ellipsoid, true},
                                     {"hull", make_hull, false}}};

const Kind& kind_named(std::string_view name) { return *std::ranges::find(kinds, name, &Kind::name); }

abut_distance distance_of(const TunedPair& pair) {
  abut_distance found;
  check(abut_pair_distance(pair.a, &pair.pose_a, pair.b, &pair.pose_b, nullptr, &found), "cannot place a pair");
  return found;
}

// Moves b along the normal of a pair that is apart: a gap becomes the wanted one, and a depth is at most that deep.
TunedPair placed_at(const SizedShape& a, const SizedShape& b, double part_of_size, Random& random) {
  constexpr double far_away = 4;  // sizes
  const double size = a.diameter + b.diameter;
  const abut_vec3 way = random.in_ball(), start = random.in_ball();
  const double scale = far_away * size / length_of(way.x, way.y, way.z);
  TunedPair pair{a.shape.get(),
                 b.shape.get(),
                 {start, random.orientation()},
                 {{start.x + scale * way.x, start.y + scale * way.y, start.z + scale * way.z}, random.orientation()},
                 size};
  const abut_distance found = distance_of(pair);
  const double step = part_of_size * size - found.distance;
  abut_vec3& position = pair.pose_b.position;
  position = {position.x + step * found.normal.x, position.y + step * found.normal.y,
              position.z + step * found.normal.z};
  return pair;
}

}  // namespace

std::vector<std::string_view> tuned_kinds() {
  std::vector<std::string_view> names;
  for (const Kind& kind : kinds) {
    if (abut_shape_kind_by_name(std::string(kind.name).c_str()) != 0) {
      names.push_back(kind.name);
    }
  }
  return names;
}

bool is_curved(std::string_view kind) { return kind_named(kind).is_curved; }

TunedPairs make_pairs(std::string_view kind_a, std::string_view kind_b, std::size_t count, std::uint64_t seed) {
  constexpr std::size_t shape_count = 16;
  Random random(seed);
  TunedPairs pairs;
  for (std::size_t i = 0; i < shape_count; ++i) {
    pairs.shapes_a.push_back(kind_named(kind_a).make(random));
    pairs.shapes_b.push_back(kind_named(kind_b).make(random));
  }
  const auto place = [&](std::size_t i, double part_of_size) {
    return placed_at(pairs.shapes_a[i % shape_count], pairs.shapes_b[(i / shape_count + i) % shape_count], part_of_size,
                     random);
  };
  while (pairs.apart.size() < count) {
    pairs.apart.push_back(place(pairs.apart.size(), std::pow(10, random.uniform(-3, -0.3))));
  }
  while (pairs.overlapping.size() < count) {
    const TunedPair pair = place(pairs.overlapping.size(), -random.uniform(0.01, 0.1));
    // Tips of two cones may pass each other.
    if (distance_of(pair).distance < 0) {
      pairs.overlapping.push_back(pair);
    }
  }
  return pairs;
}

}  // namespace cli

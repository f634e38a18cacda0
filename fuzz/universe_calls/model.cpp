// SPDX-License-Identifier: Apache-2.0
#include "model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace universe_calls {
namespace {

using Doubled = std::array<int, 4>;  // a quaternion times two

// The units and the halves: all rotations whose matrix is exact.
std::vector<Doubled> exact_turns() {
  std::vector<Doubled> turns{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 0, 2}};
  for (unsigned signs = 0; signs < 8; ++signs) {
    const auto sign = [&](unsigned bit) { return ((signs >> bit) & 1u) != 0 ? -1 : 1; };
    turns.push_back({1, sign(0), sign(1), sign(2)});
  }
  return turns;
}

Turn matrix_of(const Doubled& q) {
  const auto [w, x, y, z] = q;
  return {{{(4 - 2 * (y * y + z * z)) / 4, 2 * (x * y - w * z) / 4, 2 * (x * z + w * y) / 4},
           {2 * (x * y + w * z) / 4, (4 - 2 * (x * x + z * z)) / 4, 2 * (y * z - w * x) / 4},
           {2 * (x * z - w * y) / 4, 2 * (y * z + w * x) / 4, (4 - 2 * (x * x + y * y)) / 4}}};
}

Triple turned(const Turn& turn, const Triple& v) {
  Triple out{};
  for (std::size_t i = 0; i < 3; ++i) {
    out.at(i) = turn.at(i)[0] * v[0] + turn.at(i)[1] * v[1] + turn.at(i)[2] * v[2];
  }
  return out;
}

Triple absolute(const Triple& v) { return {std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}; }

// Places of the parts or geometries that live, by slot.
template <class Thing>
std::vector<std::size_t> living(const std::vector<Thing>& things) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (things[i].is_alive) {
      places.push_back(i);
    }
  }
  std::ranges::sort(places, {}, [&](std::size_t i) { return things[i].ids[0].slot; });
  return places;
}

// A rule ends with what it names.
template <class Id>
void forget_rules(std::vector<Rule>& rules, abut_collidable_kind kind, const Id& id) {
  const auto names = [&](const abut_collidable& c) {
    return c.kind == kind && c.slot == id.slot && c.generation == id.generation;
  };
  std::erase_if(rules, [&](const Rule& rule) { return names(rule.a) || names(rule.b); });
}

}  // namespace

void fail(const std::string& what) { throw Finding(what); }

Placed placed_at(const Triple& position, std::size_t turn) {
  static const std::vector<Doubled> turns = exact_turns();
  const Doubled& q = turns.at(turn % turns.size());
  return {{{static_cast<double>(position[0]), static_cast<double>(position[1]), static_cast<double>(position[2])},
           {0.5 * q[0], 0.5 * q[1], 0.5 * q[2], 0.5 * q[3]}},
          true,
          position,
          matrix_of(q)};
}

Placed loosely_placed(const Triple& position, double fraction, double angle) {
  const double c = std::cos(0.5 * angle), s = std::sin(0.5 * angle);
  Placed placed;
  placed.is_exact = false;
  placed.pose = {{position[0] + fraction, position[1] - fraction, position[2] + 0.5 * fraction},
                 {c, 0.6 * s, 0, 0.8 * s}};
  return placed;
}

std::optional<Box> box_of(const World& world, const Geometry& geometry) {
  const Placed &part = world.parts.at(geometry.part).placed, &local = geometry.local;
  if (!part.is_exact || !local.is_exact || !geometry.shape.is_box) {
    return std::nullopt;
  }
  Box box{turned(part.turn, local.position), absolute(turned(part.turn, turned(local.turn, geometry.shape.half)))};
  for (std::size_t i = 0; i < 3; ++i) {
    box.centre.at(i) += part.position.at(i);
  }
  return box;
}

abut_policy default_policy() {
  abut_policy policy{};
  policy.struct_size = sizeof policy;
  policy.period = 1;
  policy.tolerance = -1;
  policy.cone_factor = 0.5;
  return policy;
}

std::vector<std::size_t> World::living_parts() const { return living(parts); }
std::vector<std::size_t> World::living_geometries() const { return living(geometries); }

std::size_t World::parked_count() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      geometries, [](const Geometry& g) { return g.is_alive && g.options.parking != ABUT_PARKING_NONE; }));
}

void World::forget_geometry(std::size_t geometry) {
  Geometry& its = geometries.at(geometry);
  its.is_alive = false;
  std::erase(parts.at(its.part).geometries, geometry);
  forget_rules(rules, ABUT_COLLIDABLE_GEOMETRY, its.ids[0]);
}

void World::forget_part(std::size_t part) {
  for (const std::size_t geometry : std::vector(parts.at(part).geometries)) {
    forget_geometry(geometry);
  }
  Part& its = parts.at(part);
  its.is_alive = false;
  forget_rules(rules, ABUT_COLLIDABLE_PART, its.ids[0]);
}

}  // namespace universe_calls

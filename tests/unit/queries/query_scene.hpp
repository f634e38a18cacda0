// SPDX-License-Identifier: Apache-2.0
// A universe full of shapes of all kinds, and a loop over all of them to hold queries against.
#pragma once
#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <string_view>
#include <vector>

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.queries;
import abut.universe;

namespace test::queries {

using namespace abut;

inline ShapeHandle make_handle(std::string_view kind, const std::vector<Real>& parameters,
                               const std::vector<Real>& reals = {}, const std::vector<std::uint32_t>& indices = {}) {
  return ShapeHandle(make_shape(*find_kind(kind), parameters, reals, indices).value());
}
inline ShapeHandle make_square(Real half) {
  return make_handle("mesh", {0}, {-half, -half, 0, half, -half, 0, half, half, 0, -half, half, 0}, {0, 1, 2, 0, 2, 3});
}
inline ShapeHandle make_dumbbell() {
  const std::vector<PlacedShape> children{{make_handle("sphere", {0.4}), {Rotation::identity(), {-0.8, 0, 0}}},
                                          {make_handle("box", {0.6, 0.1, 0.1}), Pose::identity()},
                                          {make_handle("sphere", {0.4}), {Rotation::identity(), {0.8, 0, 0}}}};
  return ShapeHandle(make_composite(children).value());
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  Real in(Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(engine_); }
  std::uint64_t bits() { return engine_(); }
  Vec3 vector(Real size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  Quat turn() { return normalized(Quat{in(0.1, 1), in(-1, 1), in(-1, 1), in(-1, 1)}).value(); }
  Pose pose(Real size) { return {Rotation::from(turn()), vector(size)}; }

 private:
  std::mt19937_64 engine_;
};

inline GeometryId add(Universe& universe, const ShapeHandle& shape, const Placement& placement,
                      const GeometryOptions& options = {}) {
  const PartOptions part{MotionKind::dynamic, placement, 0};
  const auto parts = universe.create_parts(std::span(&part, 1)).value();
  return universe.create_geometries(parts, std::span(&shape, 1), std::span(&options, 1)).value().front();
}
inline Placement at(Real x, Real y, Real z) { return {{x, y, z}, {1, 0, 0, 0}}; }

inline std::vector<ShapeHandle> make_all_kinds() {
  return {make_handle("sphere", {0.6}),
          make_handle("box", {0.5, 0.3, 0.7}),
          make_handle("capsule", {0.3, 0.5}),
          make_handle("hull", {}, {1, 0, 0, -1, 0, 0, 0, 0.8, 0, 0, -0.8, 0, 0, 0, 0.6, 0, 0, -0.6}),
          make_handle("cylinder", {0.4, 0.6}),
          make_handle("cone", {0.5, 0.6}),
          make_handle("ellipsoid", {0.4, 0.5, 0.8}),
          make_handle("triangle", {1, 0, 0, -0.5, 0.8, 0, -0.5, -0.8, 0}),
          make_handle("particles", {0.2}, {0, 0, 0, 0.5, 0.1, 0, -0.4, 0.3, 0.2}),
          make_square(0.8),
          make_handle("height_field", {3, 3, 0.6, 0.6}, {0, 0.2, 0, 0.1, 0.3, 0.1, 0, 0.2, 0}),
          make_dumbbell()};
}

// Geometries of all kinds, of which some are sensors or parked and all have layers, masks and parts at random.
inline void fill(Universe& universe, std::size_t count, Real size, std::uint64_t seed) {
  Random random(seed);
  const std::vector<ShapeHandle> kinds = make_all_kinds();
  for (std::size_t i = 0; i < count; ++i) {
    GeometryOptions options;
    options.layers = random.bits() & 15;
    options.mask = random.in(0, 1) < 0.3 ? random.bits() & 3 : ~std::uint64_t{0};
    options.is_sensor = random.in(0, 1) < 0.2;
    const Real parking = random.in(0, 1);
    options.parking = parking < 0.1 ? Parking::short_term : parking < 0.2 ? Parking::long_term : Parking::none;
    add(universe, kinds[i % kinds.size()], {random.vector(size), random.turn()}, options);
  }
  universe.refresh();
}

inline bool is_looked_at(const Universe& universe, GeometryId id, const QueryFilter& filter) {
  const GeometryInfo info = universe.describe(id).value();
  return info.options.parking == Parking::none && (info.options.layers & filter.mask) != 0 &&
         (info.options.mask & filter.layers) != 0 && !(filter.skips_sensors && info.options.is_sensor) &&
         info.part != filter.ignored_part && id != filter.ignored_geometry;
}

// Everything that a query looks at, in order of slots.
inline std::vector<GeometryId> all_of(const Universe& universe, const QueryFilter& filter) {
  std::vector<GeometryId> ids = universe.geometries();
  std::erase_if(ids, [&](GeometryId id) { return !is_looked_at(universe, id, filter); });
  return ids;
}

// Calls visit(id, shape, pose) for each of them.
template <class Visitor>
void for_each(const Universe& universe, const std::vector<GeometryId>& ids, Visitor&& visit) {
  for (const GeometryId id : ids) {
    visit(id, universe.shape_at(id.slot - 1), universe.world_at(id.slot - 1));
  }
}

inline QueryFilter random_filter(const Universe& universe, Random& random) {
  QueryFilter filter;
  filter.mask = random.bits() | random.bits();
  filter.layers = 1 | (random.bits() & 2);
  filter.skips_sensors = random.in(0, 1) < 0.5;
  const std::vector<GeometryId> all = universe.geometries();
  filter.ignored_geometry = all[random.bits() % all.size()];
  filter.ignored_part = universe.describe(all[random.bits() % all.size()]).value().part;
  return filter;
}

}  // namespace test::queries

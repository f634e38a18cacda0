// SPDX-License-Identifier: Apache-2.0
// Geometries are made, changed, parked and destroyed.
#include <array>

#include "play.hpp"

namespace universe_calls {
namespace {

constexpr std::size_t most_geometries = 26;

struct Options {
  abut_geometry_options options;
  Placed local;
};

// Bits and numbers of a small range, so that filters say no about as often as
// yes.
Options options_by(const Call& call) {
  Options out;
  abut_geometry_options_init(&out.options, sizeof out.options);
  out.local = call.has(4, 7) ? placed_by(call, 5, 2) : Placed{};
  out.options.pose = out.local.pose;
  out.options.user_data = call.bytes[9];
  if (call.has(4, 0) && call.has(4, 1)) {
    out.options.tolerance = 0.25 * call.number(10, 0, 8);
  }
  out.options.layers = call.has(4, 2) ? 1 + static_cast<std::uint64_t>(call.pick(11, 4)) : 1;
  out.options.mask = call.has(4, 3) ? 1 + static_cast<std::uint64_t>(call.pick(12, 6)) : ~std::uint64_t{0};
  out.options.exclusion = call.has(4, 4) ? static_cast<std::uint64_t>(call.pick(13, 4)) : 0;
  out.options.label = static_cast<std::uint32_t>(call.pick(14, 3));
  out.options.tag = static_cast<std::uint32_t>(call.pick(15, 3));
  out.options.material = static_cast<std::uint32_t>(call.bytes[14]);
  out.options.flags = call.has(4, 5) && call.has(4, 6) ? std::uint32_t{ABUT_GEOMETRY_SENSOR} : 0;
  out.options.parking =
      call.pick(15, 16) == 15 ? 1 + static_cast<abut_parking>(call.pick(14, 2)) : std::uint32_t{ABUT_PARKING_NONE};
  return out;
}

// Boxes mostly.
const Shape& shape_by(const Call& call, std::size_t byte) {
  const std::size_t boxes = 27, others = shapes().size() - boxes;
  const std::size_t pick = call.bytes.at(byte);
  return shapes().at(pick % 8 == 7 && others > 0 ? boxes + pick / 8 % others : pick % boxes);
}

}  // namespace

void Play::create_geometries(const Call& call, std::size_t count) {
  const std::vector<std::size_t> parts = picked(world_.living_parts(), call, count);
  if (parts.empty() || world_.living_geometries().size() + count > most_geometries) {
    return;
  }
  const Options options = options_by(call);
  std::vector<Geometry> made(parts.size());
  std::vector<const abut_shape*> made_of;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    made[i].part = parts[i];
    made[i].shape = shape_by(call, 2 + i);
    made[i].options = options.options;
    made[i].local = options.local;
    made_of.push_back(made[i].shape.shape);
  }
  const std::vector<abut_geometry_options> all(parts.size(), options.options);
  on_each("abut_geometries_create", [&](std::size_t u, abut_universe* its) {
    std::vector<abut_part_id> ids;
    for (const std::size_t part : parts) {
      ids.push_back(world_.parts[part].ids.at(u));
    }
    std::vector<abut_geometry_id> out(parts.size());
    const abut_status status =
        count == 1 ? abut_geometry_create(its, ids[0], made_of[0], all.data(), out.data())
                   : abut_geometries_create(its, ids.data(), made_of.data(), all.data(), ids.size(), out.data());
    for (std::size_t i = 0; i < out.size(); ++i) {
      made[i].ids.at(u) = out[i];
    }
    return status;
  });
  for (const Geometry& geometry : made) {
    require(geometry.ids[0].slot == geometry.ids[1].slot && geometry.ids[0].slot == geometry.ids[2].slot,
            "the same calls gave geometries other slots");
    world_.parts[geometry.part].geometries.push_back(world_.geometries.size());
    world_.geometries.push_back(geometry);
    compare_geometry(world_.geometries.size() - 1);
  }
}

void Play::destroy_geometries(const Call& call, std::size_t count) {
  const std::vector<std::size_t> gone = picked(world_.living_geometries(), call, count);
  on_each("abut_geometries_destroy", [&](std::size_t u, abut_universe* its) {
    std::vector<abut_geometry_id> ids;
    for (const std::size_t geometry : gone) {
      ids.push_back(world_.geometries[geometry].ids.at(u));
    }
    return ids.size() == 1 ? abut_geometry_destroy(its, ids[0]) : abut_geometries_destroy(its, ids.data(), ids.size());
  });
  for (const std::size_t geometry : gone) {
    world_.forget_geometry(geometry);
  }
}

// All of them, or some after a look at what they are.
void Play::set_options(const Call& call) {
  for (const std::size_t place : picked(world_.living_geometries(), call, 1)) {
    Geometry& geometry = world_.geometries[place];
    Options wanted = options_by(call);
    if (call.has(2, 0)) {
      const abut_geometry_options fresh = wanted.options;
      wanted = {geometry.options, geometry.local};
      wanted.options.tag = fresh.tag;
      wanted.options.flags = fresh.flags;
      wanted.options.user_data = call.has(2, 1) ? fresh.user_data : wanted.options.user_data;
      wanted.options.exclusion = call.has(2, 2) ? fresh.exclusion : wanted.options.exclusion;
    }
    on_each("abut_geometry_set_options", [&](std::size_t u, abut_universe* its) {
      return call.has(3, 0) ? abut_geometry_set_options(its, geometry.ids.at(u), &wanted.options)
                            : abut_geometries_set_options(its, &geometry.ids.at(u), &wanted.options, 1);
    });
    for (auto& [slots, pair] : world_.pairs) {
      // Another tag may mean another period.
      pair.waiting = pair.low == place || pair.high == place ? 0 : pair.waiting;
    }
    geometry.options = wanted.options;
    geometry.local = wanted.local;
    geometry.is_moved = true;
    compare_geometry(place);
  }
}

void Play::set_shape(const Call& call) {
  for (const std::size_t place : picked(world_.living_geometries(), call, 1)) {
    Geometry& geometry = world_.geometries[place];
    geometry.shape = shape_by(call, 2);
    geometry.is_moved = geometry.is_reshaped = true;
    geometry.is_resized = false;
    const abut_shape* shape = geometry.shape.shape;
    on_each("abut_geometry_set_shape", [&](std::size_t u, abut_universe* its) {
      return call.has(3, 0) ? abut_geometry_set_shape(its, geometry.ids.at(u), shape)
                            : abut_geometries_set_shapes(its, &geometry.ids.at(u), &shape, 1);
    });
    compare_geometry(place);
  }
}

void Play::park(const Call& call, std::size_t count) {
  const std::vector<std::size_t> parked = picked(world_.living_geometries(), call, count);
  const abut_parking parking =
      std::array<abut_parking, 6>{ABUT_PARKING_NONE, ABUT_PARKING_NONE,       ABUT_PARKING_NONE,
                                  ABUT_PARKING_NONE, ABUT_PARKING_SHORT_TERM, ABUT_PARKING_LONG_TERM}
          .at(call.pick(2, 6));
  on_each("abut_geometries_park", [&](std::size_t u, abut_universe* its) {
    std::vector<abut_geometry_id> ids;
    for (const std::size_t geometry : parked) {
      ids.push_back(world_.geometries[geometry].ids.at(u));
    }
    return ids.size() == 1 ? abut_geometry_park(its, ids[0], parking)
                           : abut_geometries_park(its, ids.data(), ids.size(), parking);
  });
  for (const std::size_t geometry : parked) {
    world_.geometries[geometry].is_moved = true;
    world_.geometries[geometry].options.parking = parking;
    compare_geometry(geometry);
  }
}

}  // namespace universe_calls

// SPDX-License-Identifier: Apache-2.0
// Universes as bytes and back.
#include "universe/universe_handle.hpp"

import abut.core;
import abut.pairs.any_shape;
import abut.universe;

using namespace abut::capi;

namespace {

abut_status save(const abut_universe& its, std::span<std::uint8_t> out, std::size_t* size) {
  if (its.universe.is_stepping()) {
    return refuse(ABUT_BUSY, "the universe is in a step; it cannot be saved from its callbacks");
  }
  const std::vector<std::uint8_t> bytes = its.universe.save();
  if (bytes.size() <= out.size()) {
    std::ranges::copy(bytes, out.begin());
  }
  *size = bytes.size();
  return ABUT_OK;
}

// What abut_geometry_describe lends out: one handle for each shape, however many geometries have it.
void lend_shapes(abut_universe& its) {
  std::map<const abut::AnyShape*, ShapeOwner> owners;
  for (const abut::GeometryId id : its.universe.geometries()) {
    const abut::ShapeHandle& shape = its.universe.handle_at(id.slot - 1);
    ShapeOwner& owner = owners[&*shape];
    if (!owner) {
      owner = ShapeOwner(std::make_unique<abut_shape>(shape).release());
    }
    if (id.slot > its.shapes.size()) {
      its.shapes.resize(id.slot);
    }
    its.shapes[id.slot - 1] = share(owner.get());
  }
}

abut_status load(std::span<const std::uint8_t> bytes, abut_universe** out) {
  const auto options = abut::Universe::saved_options(bytes);
  if (!options) {
    return refuse(options.error());
  }
  auto made = std::make_unique<abut_universe>(options.value(), next_universe_number());
  if (const auto done = made->universe.load(bytes); !done) {
    return refuse(done.error());
  }
  lend_shapes(*made);
  *out = made.release();
  return ABUT_OK;
}

}  // namespace

abut_status abut_universe_save(const abut_universe* universe, void* bytes, size_t capacity, size_t* size) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<std::uint8_t> out;
    abut_status status = check_not_null("size", size);
    status =
        status != ABUT_OK ? status : read_span("bytes", static_cast<std::uint8_t*>(bytes), "capacity", capacity, out);
    return status != ABUT_OK ? status : save(its, out, size);
  });
}

abut_status abut_universe_load(const void* bytes, size_t size, abut_universe** out) {
  return guard([&] {
    std::span<const std::uint8_t> given;
    abut_status status = check_none_null<2>({{{"bytes", bytes}, {"out", out}}});
    status =
        status != ABUT_OK ? status : read_span("bytes", static_cast<const std::uint8_t*>(bytes), "size", size, given);
    return status != ABUT_OK ? status : load(given, out);
  });
}

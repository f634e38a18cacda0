// SPDX-License-Identifier: Apache-2.0
// What becomes of geometries: other options, another shape, parked.
#include "universe/geometries/geometry_arguments.hpp"
#include "options.hpp"
#include "universe/universe_handle.hpp"

import abut.core;
import abut.universe;

using namespace abut::capi;

namespace {

abut_status set_options(abut_universe& its, std::span<const abut_geometry_id> ids,
                        std::span<const abut::GeometryOptions> options) {
  const auto done = its.universe.set_options(to_geometries(ids), options);
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, "geometries", ids, done.error());
}

abut_status set_one(abut_universe& its, const abut_geometry_id& geometry, const abut_geometry_options& options) {
  abut_status status = check_struct_size({"options"}, options);
  if (status == ABUT_OK && !exists(its.universe, geometry)) {
    return refuse_stale({"geometry"}, geometry);
  }
  status = status != ABUT_OK ? status : check_options({"options"}, options);
  if (status != ABUT_OK) {
    return status;
  }
  const abut::GeometryOptions wanted = to_options(options);
  status = check_self_pairs(wanted, its.universe.describe(to_geometry(geometry)).value().shape);
  return status != ABUT_OK ? status : set_options(its, std::array{geometry}, std::array{wanted});
}

// The shapes that were lent out are let go only after the universe has taken the others. From then on nothing can
// fail.
abut_status set_shapes(abut_universe& its, std::span<const abut_geometry_id> ids,
                       std::span<const abut_shape* const> shapes) {
  SharedShapes shared(shapes);
  if (const auto done = its.universe.set_shapes(to_geometries(ids), shared.handles); !done) {
    return refuse_batch(its.universe, "geometries", ids, done.error());
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    its.shapes[ids[i].slot - 1] = std::move(shared.owners[i]);
  }
  return ABUT_OK;
}

abut_status park(abut_universe& its, std::span<const abut_geometry_id> ids, abut_parking parking) {
  if (const abut_status status = check_value({"parking"}, "", parking, ABUT_PARKING_LONG_TERM); status != ABUT_OK) {
    return status;
  }
  const auto done = its.universe.park(to_geometries(ids), static_cast<abut::Parking>(parking));
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, "geometries", ids, done.error());
}

}  // namespace

abut_status abut_geometry_set_options(abut_universe* universe, abut_geometry_id geometry,
                                      const abut_geometry_options* options) {
  return guard(universe, [&](abut_universe& its) {
    const abut_status status = check_not_null("options", options);
    return status != ABUT_OK ? status : set_one(its, geometry, *options);
  });
}

abut_status abut_geometries_set_options(abut_universe* universe, const abut_geometry_id* geometries,
                                        const abut_geometry_options* options, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_geometry_id> ids;
    StructArray<abut_geometry_options> given;
    std::vector<abut::GeometryOptions> wanted;
    abut_status status = StructArray<abut_geometry_options>::read("options", options, count, given);
    status = status != ABUT_OK || count == 0 ? status : check_not_null("options", options);
    status = status != ABUT_OK ? status : read_span("geometries", geometries, "count", count, ids);
    status = status != ABUT_OK ? status : read_options(given.span(), wanted);
    return status != ABUT_OK ? status : set_options(its, ids, wanted);
  });
}

abut_status abut_geometry_set_shape(abut_universe* universe, abut_geometry_id geometry, const abut_shape* shape) {
  return guard(universe, [&](abut_universe& its) {
    const abut_status status = check_not_null("shape", shape);
    if (status == ABUT_OK && !exists(its.universe, geometry)) {
      return refuse_stale({"geometry"}, geometry);
    }
    return status != ABUT_OK ? status : set_shapes(its, std::array{geometry}, std::array{shape});
  });
}

abut_status abut_geometries_set_shapes(abut_universe* universe, const abut_geometry_id* geometries,
                                       const abut_shape* const* shapes, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_geometry_id> ids;
    std::span<const abut_shape* const> given;
    abut_status status = read_span("geometries", geometries, "count", count, ids);
    status = status != ABUT_OK ? status : read_span("shapes", shapes, "count", count, given);
    status = status != ABUT_OK ? status : check_shapes(given);
    return status != ABUT_OK ? status : set_shapes(its, ids, given);
  });
}

abut_status abut_geometry_park(abut_universe* universe, abut_geometry_id geometry, abut_parking parking) {
  return guard_callable_in_step(universe, [&](abut_universe& its) {
    return exists(its.universe, geometry) ? park(its, std::array{geometry}, parking)
                                          : refuse_stale({"geometry"}, geometry);
  });
}

abut_status abut_geometries_park(abut_universe* universe, const abut_geometry_id* geometries, size_t count,
                                 abut_parking parking) {
  return guard_callable_in_step(universe, [&](abut_universe& its) {
    std::span<const abut_geometry_id> ids;
    const abut_status status = read_span("geometries", geometries, "count", count, ids);
    return status != ABUT_OK ? status : park(its, ids, parking);
  });
}

// SPDX-License-Identifier: Apache-2.0
// Geometries: shapes on parts.
#include "universe/geometries/geometry_arguments.hpp"
#include "options.hpp"
#include "universe/universe_handle.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.universe;

using namespace abut::capi;

namespace {

constexpr abut_geometry_options default_options{sizeof(abut_geometry_options),
                                                0,
                                                {{0, 0, 0}, {1, 0, 0, 0}},
                                                0,
                                                0,
                                                1,
                                                ~std::uint64_t{0},
                                                0,
                                                0,
                                                0,
                                                0,
                                                ABUT_PARKING_NONE};

struct [[gsl::Pointer]] Batch {
  std::span<const abut_part_id> parts;
  std::span<const abut_shape* const> shapes;
  std::span<const abut::GeometryOptions> options;  // of checked values
};

// Creates geometries and keeps their shapes for lending. After the universe has created them nothing
// can fail any more.
abut_status create(abut_universe& its, const Batch& batch, std::span<abut_geometry_id> out) {
  SharedShapes shared(batch.shapes);
  const std::size_t most = its.shapes.size() + batch.parts.size();
  if (most > its.shapes.capacity()) {
    its.shapes.reserve(std::max(most, 2 * its.shapes.capacity()));
  }
  const auto created = its.universe.create_geometries(to_parts(batch.parts), shared.handles, batch.options);
  if (!created) {
    return refuse_batch(its.universe, "parts", batch.parts, created.error());
  }
  for (std::size_t i = 0; i < created.value().size(); ++i) {
    const abut::GeometryId id = created.value()[i];
    if (id.slot > its.shapes.size()) {
      its.shapes.resize(id.slot);
    }
    its.shapes[id.slot - 1] = std::move(shared.owners[i]);
    out[i] = from_geometry(id);
  }
  return ABUT_OK;
}

abut_status create_one(abut_universe& its, const abut_part_id& part, const abut_shape* shape,
                       const abut_geometry_options& options, abut_geometry_id* out) {
  abut_status status = check_struct_size({"options"}, options);
  status = status != ABUT_OK ? status : check_options({"options"}, options);
  if (status != ABUT_OK) {
    return status;
  }
  if (!exists(its.universe, part)) {
    return refuse_stale({"part"}, part);
  }
  const abut::GeometryOptions wanted = to_options(options);
  std::array<abut_geometry_id, 1> created{};
  status = check_self_pairs(wanted, shape->handle);
  status = status != ABUT_OK ? status : create(its, {std::array{part}, std::array{shape}, std::array{wanted}}, created);
  if (status == ABUT_OK) {
    *out = created[0];
  }
  return status;
}

abut_status create_all(abut_universe& its, std::span<const abut_part_id> parts,
                       std::span<const abut_shape* const> shapes, std::span<const abut_geometry_options> given,
                       std::span<abut_geometry_id> out) {
  std::vector<abut::GeometryOptions> options;
  abut_status status = check_shapes(shapes);
  status = status != ABUT_OK ? status : read_options(given, options);
  return status != ABUT_OK ? status : create(its, {parts, shapes, options}, out);
}

abut_status destroy(abut_universe& its, std::span<const abut_geometry_id> ids) {
  if (const auto done = its.universe.destroy_geometries(to_geometries(ids)); !done) {
    return refuse_batch(its.universe, "geometries", ids, done.error());
  }
  for (const abut_geometry_id& id : ids) {
    its.shapes[id.slot - 1].reset();
  }
  return ABUT_OK;
}

abut_status describe(const abut_universe& its, const abut_geometry_id& geometry, abut_geometry_info* out) {
  if (const abut_status status = check_struct_size({"out"}, *out); status != ABUT_OK) {
    return status;
  }
  const auto found = its.universe.describe(to_geometry(geometry));
  if (!found) {
    return refuse_stale({"geometry"}, geometry);
  }
  const abut::GeometryInfo& info = found.value();
  const abut::GeometryOptions& options = info.options;
  write_struct({sizeof(abut_geometry_info), abut::kind_number(abut::kind_of(*info.shape)), from_part(info.part),
                its.shapes[geometry.slot - 1].get(), from_placement(info.world), from_placement(options.local),
                options.tolerance, options.user_data, options.layers, options.mask, options.exclusion, options.label,
                options.tag, options.material, static_cast<abut_parking>(options.parking), flags_of(options), 0},
               out);
  return ABUT_OK;
}

abut_status poses_of(const abut_universe& its, std::span<const abut_geometry_id> ids, std::span<abut_pose> out) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!exists(its.universe, ids[i])) {
      return refuse_stale({"geometries", i}, ids[i]);
    }
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    out[i] = from_placement(its.universe.world_pose(to_geometry(ids[i])).value());
  }
  return ABUT_OK;
}

}  // namespace

void abut_geometry_options_init(abut_geometry_options* options, uint32_t struct_size) {
  fill_defaults(default_options, struct_size, options);
}

abut_status abut_geometry_create(abut_universe* universe, abut_part_id part, const abut_shape* shape,
                                 const abut_geometry_options* options, abut_geometry_id* out) {
  return guard(universe, [&](abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"shape", shape}, {"out", out}}});
    return status != ABUT_OK ? status
                             : create_one(its, part, shape, options == nullptr ? default_options : *options, out);
  });
}

abut_status abut_geometries_create(abut_universe* universe, const abut_part_id* parts, const abut_shape* const* shapes,
                                   const abut_geometry_options* options, size_t count, abut_geometry_id* out) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_part_id> ids;
    std::span<const abut_shape* const> shared;
    std::span<abut_geometry_id> created;
    StructArray<abut_geometry_options> given;
    abut_status status = StructArray<abut_geometry_options>::read("options", options, count, given);
    status = status != ABUT_OK ? status : read_span("parts", parts, "count", count, ids);
    status = status != ABUT_OK ? status : read_span("shapes", shapes, "count", count, shared);
    status = status != ABUT_OK ? status : read_span("out", out, "count", count, created);
    return status != ABUT_OK ? status : create_all(its, ids, shared, given.span(), created);
  });
}

abut_status abut_geometry_destroy(abut_universe* universe, abut_geometry_id geometry) {
  return guard(universe, [&](abut_universe& its) {
    return exists(its.universe, geometry) ? destroy(its, std::array{geometry}) : refuse_stale({"geometry"}, geometry);
  });
}

abut_status abut_geometries_destroy(abut_universe* universe, const abut_geometry_id* geometries, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_geometry_id> ids;
    const abut_status status = read_span("geometries", geometries, "count", count, ids);
    return status != ABUT_OK ? status : destroy(its, ids);
  });
}

void abut_geometry_info_init(abut_geometry_info* info, uint32_t struct_size) {
  constexpr abut_pose unmoved{{0, 0, 0}, {1, 0, 0, 0}};
  abut_geometry_info blank{};
  blank.struct_size = sizeof(abut_geometry_info);
  blank.pose = unmoved;
  blank.local = unmoved;
  fill_defaults(blank, struct_size, info);
}

abut_status abut_geometry_describe(const abut_universe* universe, abut_geometry_id geometry, abut_geometry_info* out) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status : describe(its, geometry, out);
  });
}

abut_status abut_geometries_poses(const abut_universe* universe, const abut_geometry_id* geometries, size_t count,
                                  abut_pose* out) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<const abut_geometry_id> ids;
    std::span<abut_pose> poses;
    abut_status status = read_span("geometries", geometries, "count", count, ids);
    status = status != ABUT_OK ? status : read_span("out", out, "count", count, poses);
    return status != ABUT_OK ? status : poses_of(its, ids, poses);
  });
}

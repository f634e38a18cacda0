// SPDX-License-Identifier: Apache-2.0
// Parts of a universe.
#include "universe/universe_handle.hpp"
#include "options.hpp"

import abut.core;
import abut.math;
import abut.universe;

using namespace abut::capi;

static_assert(static_cast<abut_motion>(abut::MotionKind::dynamic) == ABUT_MOTION_DYNAMIC);
static_assert(static_cast<abut_motion>(abut::MotionKind::animated) == ABUT_MOTION_ANIMATED);
static_assert(static_cast<abut_motion>(abut::MotionKind::fixed) == ABUT_MOTION_STATIC);

namespace {

constexpr abut_part_options default_options{
    sizeof(abut_part_options), ABUT_MOTION_DYNAMIC, {{0, 0, 0}, {1, 0, 0, 0}}, 0};

abut_status check_options(const Where& where, const abut_part_options& options) {
  const abut_status status = check_value(where, ".motion", options.motion, ABUT_MOTION_STATIC);
  return status != ABUT_OK ? status : check_pose({where.name, where.index, ".pose"}, options.pose);
}

abut::PartOptions to_options(const abut_part_options& options) {
  return {static_cast<abut::MotionKind>(options.motion), to_placement(options.pose), options.user_data};
}

abut_status create_one(abut_universe& its, const abut_part_options& options, abut_part_id* out) {
  abut_status status = check_struct_size({"options"}, options);
  status = status != ABUT_OK ? status : check_options({"options"}, options);
  if (status != ABUT_OK) {
    return status;
  }
  const auto created = its.universe.create_parts(std::array{to_options(options)});
  if (!created) {
    return refuse(created.error());
  }
  *out = from_part(created.value().front());
  return ABUT_OK;
}

abut_status create_all(abut_universe& its, std::span<const abut_part_options> given, std::span<abut_part_id> out) {
  std::vector<abut::PartOptions> options;
  options.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (const abut_status status = check_options({"options", i}, given[i]); status != ABUT_OK) {
      return status;
    }
    options.push_back(to_options(given[i]));
  }
  const auto created = its.universe.create_parts(options);
  if (!created) {
    return refuse(created.error());
  }
  fill(std::span<const abut::PartId>(created.value()), out, from_part);
  return ABUT_OK;
}

// Destroys parts, and lets go of the shapes that were lent out for their geometries.
abut_status destroy(abut_universe& its, std::span<const abut_part_id> ids) {
  const std::vector<abut::PartId> parts = to_parts(ids);
  std::vector<abut::GeometryId> geometries;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto of_part = its.universe.geometries_of(parts[i]);
    if (!of_part) {
      return refuse_stale({"parts", i}, ids[i]);
    }
    geometries.insert(geometries.end(), of_part.value().begin(), of_part.value().end());
  }
  if (const auto done = its.universe.destroy_parts(parts); !done) {
    return refuse(done.error());
  }
  for (const abut::GeometryId geometry : geometries) {
    its.shapes[geometry.slot - 1].reset();
  }
  return ABUT_OK;
}

abut_status set_poses(abut_universe& its, std::span<const abut_part_id> ids, std::span<const abut_pose> poses) {
  std::vector<abut::Placement> placements(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (const abut_status status = check_pose({"poses", i}, poses[i]); status != ABUT_OK) {
      return status;
    }
    placements[i] = to_placement(poses[i]);
  }
  const auto done = its.universe.set_poses(to_parts(ids), placements);
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, "parts", ids, done.error());
}

abut_status set_motions(abut_universe& its, std::span<const abut_part_id> ids, std::span<const abut_motion> given) {
  std::vector<abut::MotionKind> motions;
  motions.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (const abut_status status = check_value({"motions", i}, "", given[i], ABUT_MOTION_STATIC); status != ABUT_OK) {
      return status;
    }
    motions.push_back(static_cast<abut::MotionKind>(given[i]));
  }
  const auto done = its.universe.set_motions(to_parts(ids), motions);
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, "parts", ids, done.error());
}

abut_status poses_of(const abut_universe& its, std::span<const abut_part_id> ids, std::span<abut_pose> out) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!exists(its.universe, ids[i])) {
      return refuse_stale({"parts", i}, ids[i]);
    }
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    out[i] = from_placement(its.universe.pose(to_part(ids[i])).value());
  }
  return ABUT_OK;
}

abut_status geometries_of(const abut_universe& its, const abut_part_id& part, std::span<abut_geometry_id> out,
                          std::size_t* count) {
  const auto found = its.universe.geometries_of(to_part(part));
  if (!found) {
    return refuse_stale({"part"}, part);
  }
  fill(std::span<const abut::GeometryId>(found.value()), out, from_geometry);
  *count = found.value().size();
  return ABUT_OK;
}

}  // namespace

void abut_part_options_init(abut_part_options* options, uint32_t struct_size) {
  fill_defaults(default_options, struct_size, options);
}

abut_status abut_part_create(abut_universe* universe, const abut_part_options* options, abut_part_id* out) {
  return guard(universe, [&](abut_universe& its) {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status : create_one(its, options == nullptr ? default_options : *options, out);
  });
}

abut_status abut_parts_create(abut_universe* universe, const abut_part_options* options, size_t count,
                              abut_part_id* out) {
  return guard(universe, [&](abut_universe& its) {
    std::span<abut_part_id> ids;
    StructArray<abut_part_options> given;
    abut_status status = StructArray<abut_part_options>::read("options", options, count, given);
    status = status != ABUT_OK || count == 0 ? status : check_not_null("options", options);
    status = status != ABUT_OK ? status : read_span("out", out, "count", count, ids);
    return status != ABUT_OK ? status : create_all(its, given.span(), ids);
  });
}

abut_status abut_part_destroy(abut_universe* universe, abut_part_id part) {
  return guard(universe, [&](abut_universe& its) {
    return exists(its.universe, part) ? destroy(its, std::array{part}) : refuse_stale({"part"}, part);
  });
}

abut_status abut_parts_destroy(abut_universe* universe, const abut_part_id* parts, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_part_id> ids;
    const abut_status status = read_span("parts", parts, "count", count, ids);
    return status != ABUT_OK ? status : destroy(its, ids);
  });
}

abut_status abut_part_set_pose(abut_universe* universe, abut_part_id part, const abut_pose* pose) {
  return guard(universe, [&](abut_universe& its) {
    abut_status status = check_not_null("pose", pose);
    status = status != ABUT_OK ? status : check_pose({"pose"}, *pose);
    if (status != ABUT_OK) {
      return status;
    }
    const auto done = its.universe.set_poses(std::array{to_part(part)}, std::array{to_placement(*pose)});
    if (!done) {
      return done.error().code == abut::Errc::stale_id ? refuse_stale({"part"}, part) : refuse(done.error());
    }
    return abut_status{ABUT_OK};
  });
}

abut_status abut_parts_set_poses(abut_universe* universe, const abut_part_id* parts, const abut_pose* poses,
                                 size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_part_id> ids;
    std::span<const abut_pose> placed;
    abut_status status = read_span("parts", parts, "count", count, ids);
    status = status != ABUT_OK ? status : read_span("poses", poses, "count", count, placed);
    return status != ABUT_OK ? status : set_poses(its, ids, placed);
  });
}

abut_status abut_part_pose(const abut_universe* universe, abut_part_id part, abut_pose* out) {
  return guard(universe, [&](const abut_universe& its) {
    if (const abut_status status = check_not_null("out", out); status != ABUT_OK) {
      return status;
    }
    const auto found = its.universe.pose(to_part(part));
    if (!found) {
      return refuse_stale({"part"}, part);
    }
    *out = from_placement(found.value());
    return abut_status{ABUT_OK};
  });
}

abut_status abut_parts_poses(const abut_universe* universe, const abut_part_id* parts, size_t count, abut_pose* out) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<const abut_part_id> ids;
    std::span<abut_pose> poses;
    abut_status status = read_span("parts", parts, "count", count, ids);
    status = status != ABUT_OK ? status : read_span("out", out, "count", count, poses);
    return status != ABUT_OK ? status : poses_of(its, ids, poses);
  });
}

abut_status abut_part_set_motion(abut_universe* universe, abut_part_id part, abut_motion motion) {
  return guard(universe, [&](abut_universe& its) {
    if (!exists(its.universe, part)) {
      return refuse_stale({"part"}, part);
    }
    const abut_status status = check_value({"motion"}, "", motion, ABUT_MOTION_STATIC);
    return status != ABUT_OK ? status : set_motions(its, std::array{part}, std::array{motion});
  });
}

abut_status abut_parts_set_motions(abut_universe* universe, const abut_part_id* parts, const abut_motion* motions,
                                   size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_part_id> ids;
    std::span<const abut_motion> given;
    abut_status status = read_span("parts", parts, "count", count, ids);
    status = status != ABUT_OK ? status : read_span("motions", motions, "count", count, given);
    return status != ABUT_OK ? status : set_motions(its, ids, given);
  });
}

abut_status abut_part_motion(const abut_universe* universe, abut_part_id part, abut_motion* out) {
  return guard(universe, [&](const abut_universe& its) {
    if (const abut_status status = check_not_null("out", out); status != ABUT_OK) {
      return status;
    }
    const auto found = its.universe.motion(to_part(part));
    if (!found) {
      return refuse_stale({"part"}, part);
    }
    *out = static_cast<abut_motion>(found.value());
    return abut_status{ABUT_OK};
  });
}

abut_status abut_part_user_data(const abut_universe* universe, abut_part_id part, uint64_t* out) {
  return guard(universe, [&](const abut_universe& its) {
    if (const abut_status status = check_not_null("out", out); status != ABUT_OK) {
      return status;
    }
    const auto found = its.universe.user_data(to_part(part));
    if (!found) {
      return refuse_stale({"part"}, part);
    }
    *out = found.value();
    return abut_status{ABUT_OK};
  });
}

abut_status abut_part_geometries(const abut_universe* universe, abut_part_id part, abut_geometry_id* geometries,
                                 size_t capacity, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_geometry_id> out;
    abut_status status = check_not_null("count", count);
    status = status != ABUT_OK ? status : read_span("geometries", geometries, "capacity", capacity, out);
    return status != ABUT_OK ? status : geometries_of(its, part, out, count);
  });
}

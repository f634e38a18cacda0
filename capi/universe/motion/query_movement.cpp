// SPDX-License-Identifier: Apache-2.0
// What shapes that move and turn meet in a universe.
#include "motion/impact_arguments.hpp"
#include "universe/queries/query_arguments.hpp"
#include "options.hpp"

import abut.math;
import abut.motion.paths.path;
import abut.motion.time_of_impact;
import abut.queries;
import abut.universe;

using namespace abut::capi;

namespace {

abut_impact_hit from_contact(const abut::ImpactContact& hit) {
  return {from_geometry(hit.geometry), from_impact(hit.impact)};
}

// What all casts of a batch have in common.
struct MovementQuery {
  Filter filter;
  ImpactQuery impact;
};
abut_status read_query(const abut_universe& its, double duration, const abut_impact_options* options,
                       const abut_query_filter* filter, MovementQuery& out) {
  abut_status status = to_status(abut::check_positive("duration", duration));
  status = status != ABUT_OK ? status : read_impact_options(options, out.impact);
  return status != ABUT_OK ? status : read_filter(its.universe, filter, out.filter);
}

abut_status cast_movement(const abut_universe& its, const abut_shape* shape, const abut_pose& pose,
                          const abut_movement& movement, double duration, const abut_impact_options* options,
                          const abut_query_filter* filter, abut_hit_mode given_mode, std::span<abut_impact_hit> out,
                          std::size_t* count) {
  MovementQuery query;
  std::optional<abut::Path> path;
  abut::HitMode mode{};
  abut_status status = read_query(its, duration, options, filter, query);
  status = status != ABUT_OK ? status : read_mode(given_mode, mode);
  status = status != ABUT_OK ? status : read_path({"pose"}, pose, {"movement"}, movement, duration, path);
  if (status == ABUT_OK) {
    const auto hits =
        abut::cast_movement(its.universe, shape_of(shape), *path, query.impact.options, query.filter.filter, mode);
    fill(std::span<const abut::ImpactContact>(hits), out, from_contact);
    *count = hits.size();
  }
  return status;
}

abut_status cast_movements(const abut_universe& its, const PlacedShapes& placed, std::span<const abut_pose> poses,
                           std::span<const abut_movement> movements, double duration,
                           const abut_impact_options* options, const abut_query_filter* filter,
                           std::span<abut_impact_hit> out) {
  MovementQuery query;
  std::vector<abut::Path> paths;
  abut_status status = read_query(its, duration, options, filter, query);
  for (std::size_t i = 0; status == ABUT_OK && i < movements.size(); ++i) {
    std::optional<abut::Path> path;
    status = read_path({"poses", i}, poses[i], {"movements", i}, movements[i], duration, path);
    if (path) {
      paths.push_back(*path);
    }
  }
  if (status != ABUT_OK) {
    return status;
  }
  // Handed over at once, when nothing can fail any more.
  std::vector<abut_impact_hit> found(paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto hits = abut::cast_movement(its.universe, *placed.shapes[i], paths[i], query.impact.options,
                                          query.filter.filter, abut::HitMode::nearest);
    found[i] = hits.empty() ? abut_impact_hit{} : from_contact(hits.front());
  }
  std::ranges::copy(found, out.begin());
  return ABUT_OK;
}

}  // namespace

abut_status abut_universe_cast_movement(const abut_universe* universe, const abut_shape* shape, const abut_pose* pose,
                                        const abut_movement* movement, double duration,
                                        const abut_impact_options* options, const abut_query_filter* filter,
                                        abut_hit_mode mode, abut_impact_hit* hits, size_t capacity, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_impact_hit> out;
    abut_status status =
        check_none_null<4>({{{"shape", shape}, {"pose", pose}, {"movement", movement}, {"count", count}}});
    status = status != ABUT_OK ? status : read_span("hits", hits, "capacity", capacity, out);
    return status != ABUT_OK ? status
                             : cast_movement(its, shape, *pose, *movement, duration, options, filter, mode, out, count);
  });
}

abut_status abut_universe_cast_movements(const abut_universe* universe, const abut_shape* const* shapes,
                                         const abut_pose* poses, const abut_movement* movements, size_t count,
                                         double duration, const abut_impact_options* options,
                                         const abut_query_filter* filter, abut_impact_hit* hits) {
  return guard(universe, [&](const abut_universe& its) {
    PlacedShapes placed;
    std::span<const abut_pose> starts;
    std::span<const abut_movement> ways;
    std::span<abut_impact_hit> out;
    abut_status status = read_span("movements", movements, "count", count, ways);
    status = status != ABUT_OK ? status : read_span("hits", hits, "count", count, out);
    status = status != ABUT_OK ? status : read_placed(shapes, poses, "count", count, placed);
    status = status != ABUT_OK ? status : read_span("poses", poses, "count", count, starts);
    return status != ABUT_OK ? status : cast_movements(its, placed, starts, ways, duration, options, filter, out);
  });
}

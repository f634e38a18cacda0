// SPDX-License-Identifier: Apache-2.0
// Two shapes that move and turn.
#include "guard.hpp"
#include "motion/impact_arguments.hpp"
#include "pairs/pair_batch.hpp"
#include "pairs/answers.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.motion.paths.path;
import abut.motion.time_of_impact;

using namespace abut::capi;

namespace {

struct Paths {
  std::optional<abut::Path> a, b;
};

abut::Outcome find_impact(const abut_shape* a, const abut_shape* b, const Paths& paths, const ImpactQuery& query,
                          abut_impact& out) {
  abut::Impact found;
  const abut::Outcome outcome =
      abut::time_of_impact({shape_of(a), *paths.a}, {shape_of(b), *paths.b}, query.options, found);
  if (outcome == abut::Outcome::ok) {
    out = from_impact(found);
  }
  return outcome;
}

abut_status impact_of_one(const PlacedPair& pair, const abut_movement& movement_a, const abut_movement& movement_b,
                          double duration, const abut_impact_options* options, abut_impact& out) {
  ImpactQuery query;
  Paths paths;
  abut_status status = to_status(abut::check_positive("duration", duration));
  status = status != ABUT_OK ? status : read_impact_options(options, query);
  status =
      status != ABUT_OK ? status : read_path({"pose_a"}, pair.pose_a, {"movement_a"}, movement_a, duration, paths.a);
  status =
      status != ABUT_OK ? status : read_path({"pose_b"}, pair.pose_b, {"movement_b"}, movement_b, duration, paths.b);
  if (status != ABUT_OK) {
    return status;
  }
  return refuse_outcome(find_impact(pair.a, pair.b, paths, query, out), pair.a, pair.b, abut::Algorithm::automatic);
}

abut_status impact_of_each(const PairBatch& pairs, std::span<const abut_movement> movements_a,
                           std::span<const abut_movement> movements_b, double duration,
                           const abut_impact_options* options, std::span<abut_impact> out) {
  ImpactQuery query;
  abut_status status = to_status(abut::check_positive("duration", duration));
  status = status != ABUT_OK ? status : read_impact_options(options, query);
  std::vector<Paths> paths(pairs.size());
  for (std::size_t i = 0; status == ABUT_OK && i < paths.size(); ++i) {
    status = read_path({"poses_a", i}, pairs.poses_a[i], {"movements_a", i}, movements_a[i], duration, paths[i].a);
    status = status != ABUT_OK ? status
                               : read_path({"poses_b", i}, pairs.poses_b[i], {"movements_b", i}, movements_b[i],
                                           duration, paths[i].b);
  }
  if (status != ABUT_OK) {
    return status;
  }
  return answer_each(pairs, abut::Algorithm::automatic, query.threads, out, [&](std::size_t i, abut_impact& impact) {
    return find_impact(pairs.a, pairs.b, paths[i], query, impact);
  });
}

abut_status movement_between(const abut_pose& start, const abut_pose& end, const abut_vec3& centre, double duration,
                             abut_movement& out) {
  abut_status status = check_pose({"start"}, start);
  status = status != ABUT_OK ? status : check_pose({"end"}, end);
  status = status != ABUT_OK ? status : check_position({"centre"}, "", centre);
  if (status != ABUT_OK) {
    return status;
  }
  const auto path = abut::Path::between(to_pose(start), to_pose(end), to_vec3(centre), duration);
  if (!path) {
    return to_status(path.error());
  }
  const abut::Motion& motion = path.value().motion();
  out = {from_vec3(motion.velocity), from_vec3(motion.angular_velocity), {}, {}, centre};
  return ABUT_OK;
}

}  // namespace

void abut_impact_options_init(abut_impact_options* options, uint32_t struct_size) {
  fill_defaults(default_impact_options, struct_size, options);
}

abut_status abut_movement_between(const abut_pose* start, const abut_pose* end, const abut_vec3* centre,
                                  double duration, abut_movement* out) {
  return guard([&] {
    const abut_status status = check_none_null<4>({{{"start", start}, {"end", end}, {"centre", centre}, {"out", out}}});
    return status != ABUT_OK ? status : movement_between(*start, *end, *centre, duration, *out);
  });
}

abut_status abut_pair_time_of_impact(const abut_shape* a, const abut_pose* pose_a, const abut_movement* movement_a,
                                     const abut_shape* b, const abut_pose* pose_b, const abut_movement* movement_b,
                                     double duration, const abut_impact_options* options, abut_impact* out) {
  return guard([&] {
    const abut_status status = check_none_null<7>({{{"a", a},
                                                    {"pose_a", pose_a},
                                                    {"movement_a", movement_a},
                                                    {"b", b},
                                                    {"pose_b", pose_b},
                                                    {"movement_b", movement_b},
                                                    {"out", out}}});
    return status != ABUT_OK
               ? status
               : impact_of_one({a, b, *pose_a, *pose_b}, *movement_a, *movement_b, duration, options, *out);
  });
}

abut_status abut_pairs_time_of_impact(const abut_shape* a, const abut_pose* poses_a, const abut_movement* movements_a,
                                      const abut_shape* b, const abut_pose* poses_b, const abut_movement* movements_b,
                                      size_t count, double duration, const abut_impact_options* options,
                                      abut_impact* out) {
  return guard([&] {
    PairBatch pairs{};
    std::span<const abut_movement> all_a, all_b;
    std::span<abut_impact> answers;
    abut_status status = read_span("out", out, "count", count, answers);
    status = status != ABUT_OK ? status : read_batch(a, poses_a, b, poses_b, "count", count, pairs);
    status = status != ABUT_OK ? status : read_span("movements_a", movements_a, "count", count, all_a);
    status = status != ABUT_OK ? status : read_span("movements_b", movements_b, "count", count, all_b);
    return status != ABUT_OK ? status : impact_of_each(pairs, all_a, all_b, duration, options, answers);
  });
}

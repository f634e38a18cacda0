// SPDX-License-Identifier: Apache-2.0
#include "accuracy_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "oracle/support.hpp"
#include "random_pairs.hpp"

namespace bench {
namespace {

using oracle::quad;
using oracle::Quad;
using oracle::Vec;

// A surface has so many samples along a side, and their spacing: 2,048 triangles on 8 units.
constexpr int samples = 33;
constexpr double spacing = 0.25;
// Powers of two, so that the corners of a tilted floor lie in its plane bit by bit.
constexpr double tilt_x = 0.25, tilt_y = -0.125;
// Pairs are further from touching than this, and no deeper in flat ground.
constexpr double least_gap = 0.002, most_depth = 0.05;
constexpr std::size_t most_tries = 40;
// Wider than the rounding of what is found in doubles.
constexpr double slack = 1e-9;

Vec vec_of(const Point& p) { return {quad(p[0]), quad(p[1]), quad(p[2])}; }
Point point_of(const Vec& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }

bool is_always_flat(Kind kind) { return kind == Kind::plane || kind == Kind::distance_field; }

double apart(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

// The distance of a point from the segment that begins at `start`.
double distance_to_way(const Point& p, const Point& start, const Point& way) {
  double along = 0, square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along += (p[i] - start[i]) * way[i];
    square += way[i] * way[i];
  }
  const double share = std::clamp(along / square, 0.0, 1.0);
  return apart(p, {start[0] + share * way[0], start[1] + share * way[1], start[2] + share * way[2]});
}

Solid ground(Kind kind, bool is_flat, Random& random) {
  Solid solid{kind, {samples, spacing, 0}, {}, {}};
  for (int j = 0; j < samples; ++j) {
    for (int i = 0; i < samples; ++i) {
      const double x = spacing * i, y = spacing * j;
      const double hills = 0.3 * std::sin(1.1 * x) * std::cos(1.3 * y) + random.uniform(-0.02, 0.02);
      solid.points.push_back({x, y, is_flat ? tilt_x * x + tilt_y * y : hills});
    }
  }
  add_cells(solid, samples);
  return solid;
}

Solid whole_of(Kind kind, bool is_flat, Random& random) {
  if (is_surface(kind)) {
    return ground(kind, is_flat, random);
  }
  if (kind == Kind::solid_mesh) {
    Solid solid = random_solids(Kind::hull32, 1, random).front();
    solid.kind = kind;
    return solid;
  }
  Solid solid{kind, {}, {}, {}};
  if (kind == Kind::distance_field) {
    solid.sizes = {17, 0.5, 0};
  } else if (kind == Kind::particles || kind == Kind::composite) {
    const bool is_composite = kind == Kind::composite;
    solid.sizes = is_composite ? Point{random.uniform(0.1, 0.3), random.uniform(0.1, 0.3), random.uniform(0.1, 0.3)}
                               : Point{0.08, 0, 0};
    for (int i = 0; i < (is_composite ? 5 : 64); ++i) {
      solid.points.push_back({random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)});
    }
  }
  return solid;
}

// A point of the whole to come near to, and a direction out of it.
struct Place {
  Vec point, out;
};

Place place_on(const Solid& whole, Random& random) {
  const Point any = random.direction();
  if (is_endless(whole.kind)) {
    const Vec up = oracle::unit({quad(any[0]) / 2, quad(any[1]) / 2, 1});
    if (is_always_flat(whole.kind)) {
      return {{quad(random.uniform(-1.5, 1.5)), quad(random.uniform(-1.5, 1.5)), 0}, up};
    }
    constexpr std::size_t low = 10, count = samples - 2 * low;
    const std::size_t i = low + random.below(count), j = low + random.below(count);
    return {vec_of(whole.points[j * samples + i]), up};
  }
  const bool is_solid = whole.kind == Kind::solid_mesh;
  return {is_solid ? Vec{} : vec_of(whole.points[random.below(whole.points.size())]), vec_of(any)};
}

Placement placed(const oracle::Pose& at, const Vec& local, const Quaternion& turn) {
  return {point_of(at.place(local)), turn};
}

}  // namespace

oracle::Pose PartsJudge::pose_of(const Part& part, const oracle::Pose& at_whole) {
  oracle::Pose at = at_whole;
  at.position = at_whole.place(part.place);
  return at;
}

PartsJudge::PartsJudge(const Solid& whole, const std::optional<Vec>& normal) : normal_(normal) {
  if (normal_) {
    return;
  }
  const auto add = [this](const Solid& part, const Point& place, const Point& centre, double reach) {
    parts_.push_back({Judge(part), vec_of(place), centre, reach});
  };
  if (whole.kind == Kind::solid_mesh) {
    add({Kind::hull32, {}, whole.points, {}}, {}, {}, bounding_radius(whole));
    return;
  }
  for (const auto& [i, j, k] : whole.triangles) {
    const auto corner = [&whole](int index) { return whole.points[static_cast<std::size_t>(index)]; };
    const Solid triangle{Kind::triangle, {}, {corner(i), corner(j), corner(k)}, {}};
    const Point centre = point_of((vec_of(corner(i)) + vec_of(corner(j)) + vec_of(corner(k))) * (Quad{1} / 3));
    double reach = 0;
    for (const Point& p : triangle.points) {
      reach = std::max(reach, apart(p, centre));
    }
    add(triangle, {}, centre, reach);
  }
  for (std::size_t i = 0; whole.triangles.empty() && i < whole.points.size(); ++i) {
    const Solid part{whole.kind == Kind::particles ? Kind::sphere : Kind::box, whole.sizes, {}, {}};
    add(part, whole.points[i], whole.points[i], bounding_radius(part));
  }
}

std::optional<Quad> PartsJudge::distance(const oracle::Pose& at_whole, Judge& b, const oracle::Pose& at_b,
                                         double reach_b, bool with_overlaps) {
  if (normal_) {
    const Vec n = at_whole.rotate(*normal_);
    return oracle::dot(at_b.position - at_whole.position, n) - oracle::support(b.solid(), at_b.rotate_back(-n));
  }
  // Parts that may be nearest come first, so that most others are passed over.
  std::vector<std::pair<double, Part*>> order;
  const Point middle = point_of(at_whole.rotate_back(at_b.position - at_whole.position));
  for (Part& part : parts_) {
    order.emplace_back(apart(part.centre, middle) - part.reach - reach_b, &part);
  }
  std::ranges::sort(order, {}, &std::pair<double, Part*>::first);
  std::optional<Quad> least;
  for (const auto& [bound, part] : order) {
    if (least && quad(bound - slack) > *least) {
      break;
    }
    const oracle::Pose at = pose_of(*part, at_whole);
    const std::optional<Quad> found =
        with_overlaps ? true_distance(part->judge, at, b, at_b, true) : least_distance(part->judge, at, b, at_b);
    if (!found) {
      return std::nullopt;
    }
    least = least ? oracle::smaller(*least, *found) : *found;
  }
  return least;
}

Quad PartsJudge::cast(const oracle::Pose& at_whole, const Judge& b, const oracle::Pose& at_b, const Point& motion,
                      double reach_b) const {
  const Vec way = vec_of(motion);
  if (normal_) {
    const Vec n = at_whole.rotate(*normal_);
    const Quad gap =
        oracle::dot(at_b.position - at_whole.position, n) - oracle::support(b.solid(), at_b.rotate_back(-n));
    const Quad closing = -oracle::dot(n, way);
    return closing > 0 ? oracle::smaller(gap / closing, 1) : 1;
  }
  const Point start = point_of(at_whole.rotate_back(at_b.position - at_whole.position));
  const Point step = point_of(at_whole.rotate_back(way));
  Quad first = 1;
  for (const Part& part : parts_) {
    if (distance_to_way(part.centre, start, step) <= part.reach + reach_b + slack) {
      first = oracle::smaller(first, true_cast(part.judge, pose_of(part, at_whole), b, at_b, motion));
    }
  }
  return first;
}

PartScenes::Wholes& PartScenes::wholes(Kind kind, bool is_flat) {
  const auto [place, is_new] = wholes_.try_emplace({kind, is_flat});
  Wholes& its = place->second;
  if (is_new) {
    Random random(50 + static_cast<std::uint64_t>(kind));
    std::optional<Vec> normal;
    if (is_always_flat(kind)) {
      normal = Vec{0, 0, 1};
    } else if (is_flat && is_surface(kind)) {
      normal = oracle::unit({quad(-tilt_x), quad(-tilt_y), 1});
    }
    for (int i = 0; i < (is_endless(kind) ? 1 : 2); ++i) {
      its.solids.push_back(whole_of(kind, is_flat, random));
      its.judges.emplace_back(its.solids.back(), normal);
    }
  }
  return its;
}

PartScenes::Bodies& PartScenes::bodies(Kind kind) {
  const auto [place, is_new] = bodies_.try_emplace(kind);
  Bodies& its = place->second;
  if (is_new) {
    Random random(90 + static_cast<std::uint64_t>(kind));
    its.solids = random_solids(kind, kind == Kind::point ? 1 : 4, random);
    for (const Solid& solid : its.solids) {
      its.judges.emplace_back(solid);
    }
  }
  return its;
}

std::optional<JudgedCell> PartScenes::make(Query query, Kind kind_a, Kind kind_b, std::size_t count) {
  // How deep a body is in hills has no closed form; the deepest contact of a ball has.
  const bool is_in = query == Query::depth || (query == Query::contacts && kind_b != Kind::sphere);
  const bool is_flat = is_always_flat(kind_a) || (is_in && is_surface(kind_a));
  Wholes& a = wholes(kind_a, is_flat);
  Bodies& b = bodies(kind_b);
  Random random(1 + static_cast<std::uint64_t>(kind_a) +
                32 * (static_cast<std::uint64_t>(kind_b) + 32 * static_cast<std::uint64_t>(query)));
  JudgedCell cell{a.solids, b.solids, {}, {}, {}, {}};
  const bool is_on_way = query == Query::cast || query == Query::ray || query == Query::impact;
  const bool is_inner = query == Query::depth || query == Query::contacts;
  for (std::size_t i = 0; i < most_tries * count && cell.cases.size() < count; ++i) {
    Case one;
    one.a = random.below(a.solids.size());
    one.b = random.below(b.solids.size());
    // Height fields of some peers do not move.
    if (kind_a != Kind::height_field) {
      one.pose_a = {{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}, random.orientation()};
    }
    const oracle::Pose at_a = oracle_pose(one.pose_a);
    const double reach = bounding_radius(b.solids[one.b]);
    const Place place = place_on(a.solids[one.a], random);
    const double near = reach + (is_endless(kind_a) ? 0 : 0.5);
    const double away = is_on_way ? random.uniform(1.2, 2) * (near + 0.2) : random.uniform(0, 1.3) * near;
    one.pose_b = placed(at_a, place.point + place.out * quad(away), random.orientation());
    PartsJudge& whole = a.judges[one.a];
    Judge& body = b.judges[one.b];
    const auto distance = [&](const oracle::Pose& at) { return whole.distance(at_a, body, at, reach, !is_on_way); };
    std::optional<Quad> truth = distance(oracle_pose(one.pose_b));
    const bool is_shallow = is_inner && is_endless(kind_a);
    if (is_shallow && truth) {
      // Down to a depth that is drawn, or about there on hills.
      const Vec tilted = oracle::unit({quad(-tilt_x), quad(-tilt_y), 1});
      const Vec n = at_a.rotate(!is_flat ? place.out : is_always_flat(kind_a) ? Vec{0, 0, 1} : tilted);
      const Vec down = n * (-*truth - quad(random.uniform(0.1, 1) * most_depth));
      one.pose_b.position = point_of(vec_of(one.pose_b.position) + down);
      truth = distance(oracle_pose(one.pose_b));
    }
    // Deep in hills a body leaves all triangles together, by more than the depth in any of them.
    const bool is_too_deep = truth && is_shallow && *truth < -quad(1.1 * most_depth);
    if (!truth || is_too_deep || oracle::absolute(*truth) < quad(least_gap)) {
      continue;
    }
    if (query != Query::overlap && (*truth < 0) != is_inner) {
      continue;
    }
    if (is_on_way) {
      give_motion(one, point_of(at_a.place(place.point)), 0.5 * near, random);
      const oracle::Pose at_b = oracle_pose(one.pose_b);
      if (query == Query::impact) {
        one.turn = random.direction();
        truth = true_impact(distance, at_b, one.motion, one.turn, reach);
      } else {
        truth = whole.cast(at_a, body, at_b, one.motion, reach);
      }
      if (!truth || *truth >= 1) {
        continue;
      }
    }
    cell.add(one, *truth);
  }
  return cell.cases.empty() ? std::nullopt : std::optional(std::move(cell));
}

}  // namespace bench

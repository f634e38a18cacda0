// SPDX-License-Identifier: Apache-2.0
#include "accuracy_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accuracy_placing.hpp"
#include "accuracy_solids.hpp"
#include "random_pairs.hpp"

namespace bench {
namespace {

using oracle::quad;
using oracle::Quad;
using oracle::Vec;

constexpr double aspect = 1e6;
// Giants and specks are 2^30, about 1e9, times as large as each other.
constexpr double giant = 0x1p15, speck = 0x1p-15;
constexpr double far_away = 1e9;
// Ordinary pairs are further from touching than this.
constexpr double least_gap = 0.01;
// Tries for each case that is wanted; some conditions cannot tell beforehand on which side a pair will lie.
constexpr std::size_t most_tries = 40;

// Finding the depth of two large hulls takes the oracle a second.
std::size_t wanted_cases(Query query, Kind a, Kind b, std::size_t count) {
  const bool is_slow = query == Query::depth && a == Kind::hull200 && b == Kind::hull200;
  return is_slow ? std::max<std::size_t>(1, count / 8) : count;
}

bool is_round(Kind kind) { return kind == Kind::sphere || kind == Kind::capsule; }

// Depths of a curved solid are known only where the core of the other shape, a point or a segment, is outside of it.
bool is_judged(Query query, Kind a, Kind b) {
  const bool has_curved = is_curved(a) || is_curved(b);
  return query != Query::depth || !has_curved || is_round(a) || is_round(b);
}

// A flat or straight side to lie along.
bool has_side(Kind kind) { return kind != Kind::sphere && kind != Kind::cone && kind != Kind::ellipsoid; }

bool is_on_way(Query query) { return query == Query::cast || query == Query::ray || query == Query::impact; }

bool makes_sense(Query query, Condition condition, Kind a, Kind b) {
  if (is_on_way(query) && condition != Condition::ordinary && condition != Condition::far) {
    return false;
  }
  if (condition == Condition::parallel) {
    return has_side(a) && has_side(b);
  }
  return condition != Condition::thin || a != Kind::sphere || b != Kind::sphere;
}

double power_of_ten(double from, double to, Random& random) { return std::pow(10, random.uniform(from, to)); }

struct Side {
  const std::vector<Solid>& solids;
  const std::vector<Judge>& judges;
};

class Draws {
 public:
  Draws(Query query, Condition condition, Side a, Side b, Random& random)
      : query_(query), condition_(condition), a_(a), b_(b), random_(random) {}

  // A case that need not lie on the side that is asked for.
  Case next() {
    switch (condition_) {
      case Condition::ordinary: return ordinary();
      case Condition::thin: return thin();
      case Condition::size_ratio: return size_ratio();
      case Condition::far: return far();
      case Condition::parallel: return parallel();
      case Condition::touching: return touching();
    }
    return {};
  }

  [[nodiscard]] bool is_wanted(Quad distance) const {
    const bool is_plain = condition_ == Condition::ordinary || condition_ == Condition::far;
    const Quad least = is_plain ? quad(least_gap) : 0;
    return query_ == Query::depth ? distance < -least : distance > least;
  }

 private:
  Case ordinary() {
    Case one = random_case(a_.solids, b_.solids, random_);
    if (is_on_way(query_)) {
      give_motion(one, reach(one), random_);
      const Point axis = random_.direction();
      const double angle = query_ == Query::impact ? random_.uniform(0, 1.5) : 0;
      one.turn = {angle * axis[0], angle * axis[1], angle * axis[2]};
    }
    return one;
  }
  Case any_two() {
    const Point position{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
    return {random_.below(a_.solids.size()), random_.below(b_.solids.size()), {position, random_.orientation()}, {}};
  }
  [[nodiscard]] double reach(const Case& one) const {
    return bounding_radius(a_.solids[one.a]) + bounding_radius(b_.solids[one.b]);
  }
  [[nodiscard]] double outward(double gap) const { return query_ == Query::depth ? -gap : gap; }

  Vec any_direction() {
    const Point n = random_.direction();
    return oracle::unit({quad(n[0]), quad(n[1]), quad(n[2])});
  }
  // Out of a side of the first solid, in the world, or any direction.
  Vec side_or_any(const Case& one) {
    if (random_.below(2) == 0) {
      return any_direction();
    }
    return oracle_pose(one.pose_a).rotate(side_normal(a_.solids[one.a], random_));
  }
  void face(Case& one, const Quaternion& turn, const Vec& n, double gap, double slack) const {
    one.pose_b = facing(a_.judges[one.a].solid(), one.pose_a, b_.judges[one.b].solid(), turn, n, gap, slack);
  }

  Case thin() {
    if (query_ == Query::distance && random_.below(2) == 0) {
      return random_case(a_.solids, b_.solids, random_);
    }
    Case one = any_two();
    if (query_ == Query::depth && random_.below(2) == 0) {
      one.pose_b =
          meeting(a_.judges[one.a].solid(), one.pose_a, b_.judges[one.b].solid(), random_.orientation(), random_);
    } else {
      const double gap = query_ == Query::distance ? power_of_ten(-5, -1, random_) : 0.1 / aspect;
      face(one, random_.orientation(), side_or_any(one), outward(gap * reach(one)), 1e-12);
    }
    return one;
  }

  // The first half of the solids are giants, the second half specks.
  Case size_ratio() {
    Case one = any_two();
    const std::size_t half_a = a_.solids.size() / 2, half_b = b_.solids.size() / 2;
    const bool is_first_giant = random_.below(2) == 0;
    one.a = one.a % half_a + (is_first_giant ? 0 : half_a);
    one.b = one.b % half_b + (is_first_giant ? half_b : 0);
    const double small = std::min(bounding_radius(a_.solids[one.a]), bounding_radius(b_.solids[one.b]));
    face(one, random_.orientation(), side_or_any(one), outward(random_.uniform(0.1, 0.5) * small), 1e-12);
    return one;
  }

  Case far() {
    Case one = ordinary();
    const Point direction = random_.direction();
    for (std::size_t i = 0; i < 3; ++i) {
      one.pose_a.position.at(i) += far_away * direction.at(i);
      one.pose_b.position.at(i) += far_away * direction.at(i);
    }
    return one;
  }

  Case parallel() {
    Case one = any_two();
    const double angle = power_of_ten(-12, -3, random_);
    const Vec n = oracle_pose(one.pose_a).rotate(side_normal(a_.solids[one.a], random_));
    const Quaternion turn = turn_from(side_normal(b_.solids[one.b], random_), -n);
    face(one, product(small_turn(angle, random_), turn), n, outward(least_gap * reach(one)), 2 * angle + 1e-12);
    return one;
  }

  Case touching() {
    Case one = any_two();
    const double gap = power_of_ten(-12, -3, random_) * reach(one);
    face(one, random_.orientation(), side_or_any(one), outward(gap), 1e-12);
    return one;
  }

  Query query_;
  Condition condition_;
  Side a_, b_;
  Random& random_;
};

}  // namespace

std::string_view condition_name(Condition condition) {
  constexpr std::array<std::string_view, 6> names{"ordinary", "thin", "size_ratio", "far", "parallel", "touching"};
  return names.at(static_cast<std::size_t>(condition));
}

std::string_view condition_title(Condition condition) {
  constexpr std::array<std::string_view, 6> titles{"ordinary",
                                                   "needles and plates, aspect 1e6",
                                                   "size ratio 1e9",
                                                   "1e9 sizes from the origin",
                                                   "faces parallel to 1e-3 ... 1e-12 rad",
                                                   "gap or depth 1e-3 ... 1e-12 of the size"};
  return titles.at(static_cast<std::size_t>(condition));
}

void JudgedCell::add(const Case& one, Quad truth) {
  const double size_a = is_endless(solids_a[one.a].kind) ? 0 : bounding_radius(solids_a[one.a]);
  const double size = 2 * (size_a + bounding_radius(solids_b[one.b]));
  const Point &p = one.pose_a.position, &q = one.pose_b.position;
  const double apart = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  const double way = std::hypot(one.motion[0], one.motion[1], one.motion[2]);
  cases.push_back(one);
  truths.push_back(truth);
  // Of a ray onto ground there is no other size.
  sizes.push_back(way == 0 ? size : size > 0 ? size / way : 1);
  roundings.push_back(64 * std::numeric_limits<double>::epsilon() * (size / 2 + apart));  // as in the property tests
}

JudgedCell JudgedCell::only(const std::vector<std::size_t>& chosen) const {
  JudgedCell result{solids_a, solids_b, {}, {}, {}, {}};
  for (const std::size_t i : chosen) {
    result.cases.push_back(cases[i]);
    result.truths.push_back(truths[i]);
    result.sizes.push_back(sizes[i]);
    result.roundings.push_back(roundings[i]);
  }
  return result;
}

AccuracyScenes::Form AccuracyScenes::form_of(Condition condition) {
  if (condition == Condition::thin) {
    return Form::thin;
  }
  return condition == Condition::size_ratio ? Form::of_two_sizes : Form::ordinary;
}

AccuracyScenes::Pool& AccuracyScenes::pool(Form form, Kind kind) {
  const auto [place, is_new] = pools_.try_emplace({form, kind});
  Pool& pool = place->second;
  if (is_new) {
    // The judge of a large hull takes seconds.
    const std::size_t count = kind == Kind::hull200 ? 2 : 4;
    Random random(1 + 16 * static_cast<std::uint64_t>(form) + static_cast<std::uint64_t>(kind));
    pool.solids = random_solids(kind, count, random);
    for (std::size_t i = 0; i < count && form != Form::ordinary; ++i) {
      const bool is_first_half = i < count / 2;
      Solid& solid = pool.solids[i];
      solid = form == Form::thin ? made_thin(std::move(solid), is_first_half, aspect)
                                 : scaled(std::move(solid), is_first_half ? giant : speck);
      if (is_hull(kind)) {
        find_surface(solid);
      }
    }
    for (const Solid& solid : pool.solids) {
      pool.judges.emplace_back(solid);
    }
  }
  return pool;
}

std::optional<JudgedCell> AccuracyScenes::judged(Query query, Condition condition, Kind kind_a, Kind kind_b,
                                                 std::size_t count) {
  if (!is_judged(query, kind_a, kind_b) || !makes_sense(query, condition, kind_a, kind_b)) {
    return std::nullopt;
  }
  Pool &a = pool(form_of(condition), kind_a), &b = pool(form_of(condition), kind_b);
  // A seed of its own for each cell, so that it does not depend on which others are made.
  Random random(1 + static_cast<std::uint64_t>(kind_a) +
                16 * (static_cast<std::uint64_t>(kind_b) +
                      16 * (static_cast<std::uint64_t>(condition) + 16 * static_cast<std::uint64_t>(query))));
  Draws draws(query, condition, {a.solids, a.judges}, {b.solids, b.judges}, random);
  JudgedCell cell{a.solids, b.solids, {}, {}, {}, {}};
  const std::size_t wanted = wanted_cases(query, kind_a, kind_b, count);
  for (std::size_t i = 0; i < most_tries * wanted && cell.cases.size() < wanted; ++i) {
    const Case one = draws.next();
    const oracle::Pose at_a = oracle_pose(one.pose_a), at_b = oracle_pose(one.pose_b);
    const std::optional<Quad> truth =
        true_distance(a.judges[one.a], at_a, b.judges[one.b], at_b, query == Query::depth);
    if (!truth || !draws.is_wanted(*truth)) {
      continue;
    }
    if (!is_on_way(query)) {
      cell.add(one, *truth);
      continue;
    }
    const auto distance_at = [&](const oracle::Pose& at) {
      return least_distance(a.judges[one.a], at_a, b.judges[one.b], at);
    };
    const std::optional<Quad> share =
        query == Query::impact ? true_impact(distance_at, at_b, one.motion, one.turn, bounding_radius(b.solids[one.b]))
                               : true_cast(a.judges[one.a], at_a, b.judges[one.b], at_b, one.motion);
    // One that passes has no share to be compared.
    if (share && *share < 1) {
      cell.add(one, *share);
    }
  }
  return cell.cases.empty() ? std::nullopt : std::optional(std::move(cell));
}

std::optional<JudgedCell> AccuracyScenes::make_overlaps(Condition condition, Kind a, Kind b, std::size_t count) {
  std::optional<JudgedCell> cell = make(Query::distance, condition, a, b, count);
  const std::optional<JudgedCell> overlapping = make(Query::depth, condition, a, b, count);
  for (std::size_t i = 0; cell && overlapping && i < overlapping->cases.size(); ++i) {
    cell->add(overlapping->cases[i], overlapping->truths[i]);
  }
  return cell;
}

std::optional<JudgedCell> AccuracyScenes::make(Query query, Condition condition, Kind a, Kind b, std::size_t count) {
  if (query == Query::overlap) {
    return make_overlaps(condition, a, b, count);
  }
  const auto [place, is_new] = made_.try_emplace({query, condition, a, b, count});
  if (is_new) {
    place->second = judged(query, condition, a, b, count);
  }
  return place->second;
}

}  // namespace bench

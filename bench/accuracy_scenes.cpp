// SPDX-License-Identifier: Apache-2.0
#include "accuracy_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accuracy_placing.hpp"
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
// Of so many tries for each case that is wanted; some conditions cannot tell beforehand on which side a pair will lie.
constexpr std::size_t most_tries = 40;

// Finding the depth of two large hulls takes the oracle a second.
std::size_t wanted_cases(Query query, Kind a, Kind b, std::size_t count) {
  const bool is_slow = query == Query::depth && a == Kind::hull200 && b == Kind::hull200;
  return is_slow ? std::max<std::size_t>(1, count / 8) : count;
}

bool is_round(Kind kind) { return kind == Kind::sphere || kind == Kind::capsule; }

// Depths of a cylinder are known only where the core of the other shape, a point or a segment, is outside of it.
bool is_judged(Query query, Kind a, Kind b) {
  const bool has_cylinder = a == Kind::cylinder || b == Kind::cylinder;
  return query == Query::distance || !has_cylinder || is_round(a) || is_round(b);
}

bool makes_sense(Condition condition, Kind a, Kind b) {
  if (condition == Condition::parallel) {
    return a != Kind::sphere && b != Kind::sphere;
  }
  return condition != Condition::thin || a != Kind::sphere || b != Kind::sphere;
}

// Thin along two axes or along one; a sphere stays as it is, and a capsule can only be a needle.
Solid made_thin(Solid solid, bool is_needle) {
  switch (solid.kind) {
    case Kind::capsule: solid.sizes[0] = solid.sizes[1] / aspect; return solid;
    case Kind::cylinder:
      (is_needle ? solid.sizes[0] : solid.sizes[1]) = solid.sizes[is_needle ? 1 : 0] / aspect;
      return solid;
    case Kind::sphere:
    case Kind::box:
    case Kind::plane:
    case Kind::hull32:
    case Kind::hull200:
    case Kind::cone:
    case Kind::ellipsoid:
    case Kind::hull:
    case Kind::triangle:
    case Kind::mesh:
    case Kind::height_field: break;
  }
  const auto flatten = [is_needle](Point& p) {
    p[2] /= is_needle ? 1 : aspect;
    p[0] /= is_needle ? aspect : 1;
    p[1] /= is_needle ? aspect : 1;
  };
  if (solid.kind == Kind::box) {
    flatten(solid.sizes);
  }
  std::ranges::for_each(solid.points, flatten);
  return solid;
}

Solid scaled(Solid solid, double factor) {
  const auto scale = [factor](Point& p) { p = {factor * p[0], factor * p[1], factor * p[2]}; };
  scale(solid.sizes);
  std::ranges::for_each(solid.points, scale);
  return solid;
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
      case Condition::ordinary: return random_case(a_.solids, b_.solids, random_);
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
    return query_ == Query::distance ? distance > least : distance < -least;
  }

 private:
  Case any_two() {
    const Point position{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
    return {random_.below(a_.solids.size()), random_.below(b_.solids.size()), {position, random_.orientation()}, {}};
  }
  [[nodiscard]] double reach(const Case& one) const {
    return bounding_radius(a_.solids[one.a]) + bounding_radius(b_.solids[one.b]);
  }
  [[nodiscard]] double outward(double gap) const { return query_ == Query::distance ? gap : -gap; }

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
    Case one = random_case(a_.solids, b_.solids, random_);
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

void add(JudgedCell& cell, const Case& one, Quad truth) {
  const double size = 2 * (bounding_radius(cell.solids_a[one.a]) + bounding_radius(cell.solids_b[one.b]));
  const Point &p = one.pose_a.position, &q = one.pose_b.position;
  const double apart = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  cell.cases.push_back(one);
  cell.truths.push_back(truth);
  cell.sizes.push_back(size);
  cell.roundings.push_back(64 * std::numeric_limits<double>::epsilon() *
                           (size / 2 + apart));  // as in the property tests
}

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
      solid = form == Form::thin ? made_thin(std::move(solid), is_first_half)
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

std::optional<JudgedCell> AccuracyScenes::make(Query query, Condition condition, Kind kind_a, Kind kind_b,
                                               std::size_t count) {
  if (!is_judged(query, kind_a, kind_b) || !makes_sense(condition, kind_a, kind_b)) {
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
    const std::optional<Quad> truth =
        true_distance(a.judges[one.a], one.pose_a, b.judges[one.b], one.pose_b, query == Query::depth);
    if (truth && draws.is_wanted(*truth)) {
      add(cell, one, *truth);
    }
  }
  return cell.cases.empty() ? std::nullopt : std::optional(std::move(cell));
}

}  // namespace bench

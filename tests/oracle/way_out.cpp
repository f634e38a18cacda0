// SPDX-License-Identifier: Apache-2.0
#include "way_out.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "overlap.hpp"

namespace oracle {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int spread = 96;  // directions all over the sphere
constexpr std::size_t refined = 4;
constexpr int most_rounds = 80;  // of a refinement

// Two parts are apart along an axis, from a to b, where b has moved by so much along it.
struct Axis {
  Point normal;
  double least;
};

struct Stretch {
  double begin, end;
};

struct Pieces {
  const Part *a, *b;
  std::vector<Axis> axes;
};

double highest(const Part& part, const Point& direction) {
  double most = -infinity;
  for (const Vec& p : part.hull.points) most = std::max(most, inner(rounded(p), direction));
  return most;
}

Point negated(const Point& p) { return {-p[0], -p[1], -p[2]}; }

void add_axis(Pieces& pair, const Vec& raw, double radii) {
  if (!(dot(raw, raw) > 0)) return;
  const Point normal = rounded(unit(raw));
  for (const Point& n : {normal, negated(normal)}) {
    pair.axes.push_back({n, highest(*pair.a, n) + highest(*pair.b, negated(n)) + radii});
  }
}

class Search {
 public:
  Search(const Side& a, const Side& b, const Holds& holds)
      : a_(a),
        b_(b),
        holds_(holds),
        radii_(static_cast<double>(a.radius + b.radius)),
        beyond_(1e-9 * static_cast<double>(a.size + b.size)) {
    for (const Part& of_a : a.parts) {
      for (const Part& of_b : b.parts) {
        Pieces pair{&of_a, &of_b, {}};
        for (const Vec& n : of_a.hull.normals) add_axis(pair, n, radii_);
        for (const Vec& n : of_b.hull.normals) add_axis(pair, n, radii_);
        for (const Vec& u : of_a.hull.directions) {
          for (const Vec& v : of_b.hull.directions) add_axis(pair, cross(u, v), radii_);
        }
        if (radii_ > 0) {
          // Planes that touch the ball around the part: where b lies, and beside edges and corners.
          for (const Vec& p : of_a.hull.points) {
            for (const Vec& q : of_b.hull.points) add_axis(pair, q - p, radii_);
          }
          add_axis(pair, of_b.hull.centre - of_a.hull.centre, radii_);
          for (const Vec& u : of_a.hull.directions) add_axis(pair, cross(u, of_a.normal), radii_);
        }
        pairs_.push_back(std::move(pair));
      }
    }
  }

  // How far b has to move along a unit direction; infinite where that leads through a front.
  [[nodiscard]] double along(const Point& direction) const {
    std::vector<Stretch> stretches;
    for (const Pieces& pair : pairs_) {
      const Stretch stretch = stretch_of(pair, direction);
      if (!(stretch.end > std::max(stretch.begin, 0.0))) continue;
      if (leads_through(pair, direction)) {
        stretches.push_back({stretch.begin, infinity});
      } else {
        stretches.push_back(stretch);
      }
    }
    std::ranges::sort(stretches, {}, &Stretch::begin);
    double depth = 0;
    for (const Stretch& stretch : stretches) {
      if (stretch.begin > depth && !is_held(direction, depth)) return depth;
      depth = std::max(depth, stretch.end);
    }
    return is_held(direction, depth) ? infinity : depth;
  }

 private:
  [[nodiscard]] Stretch stretch_of(const Pieces& pair, const Point& direction) const {
    Stretch stretch{-infinity, infinity};
    const auto cut = [&](const Axis& axis) {
      const double speed = inner(axis.normal, direction);
      if (speed > 1e-14) {
        stretch.end = std::min(stretch.end, axis.least / speed);
      } else if (speed < -1e-14) {
        stretch.begin = std::max(stretch.begin, axis.least / speed);
      } else if (axis.least <= 0) {
        stretch.end = -infinity;
      }
    };
    for (const Axis& axis : pair.axes) cut(axis);
    if (radii_ > 0 || pair.axes.size() < 2) {
      cut({direction, highest(*pair.a, direction) + highest(*pair.b, negated(direction)) + radii_});
      cut({negated(direction), highest(*pair.a, negated(direction)) + highest(*pair.b, direction) + radii_});
    }
    return stretch;
  }

  [[nodiscard]] bool is_held(const Point& direction, double depth) const {
    return holds_ && depth < infinity && holds_(exact(direction) * quad(depth + beyond_));
  }

  [[nodiscard]] bool leads_through(const Pieces& pair, const Point& direction) const {
    return (a_.is_one_sided && inner(rounded(pair.a->normal), direction) < -1e-12) ||
           (b_.is_one_sided && inner(rounded(pair.b->normal), direction) > 1e-12);
  }

  const Side& a_;
  const Side& b_;
  const Holds& holds_;
  double radii_;
  double beyond_;  // at the end of a way points lie on the surface; a little further they are in or out
  std::vector<Pieces> pairs_;
};

struct Found {
  double depth;
  Point direction;
};

// Goes from a direction to better ones around it, and looks nearer by where there are none.
Found refine(const Search& search, Found best) {
  double width = 0.3;
  for (int round = 0; round < most_rounds && width > 1e-7; ++round) {
    const Point u = rounded(perpendicular(exact(best.direction))), v = vector_product(best.direction, u);
    const Found middle = best;
    for (int i = 0; i < 6; ++i) {
      const double angle = 1.0471975511965976 * i + 0.3 * round;
      const Point direction =
          unit_of(sum(sum(middle.direction, u, width * std::cos(angle)), v, width * std::sin(angle)));
      const double depth = search.along(direction);
      if (depth < best.depth) best = {depth, direction};
    }
    if (!(best.depth < middle.depth)) width /= 2;
  }
  return best;
}

}  // namespace

WayOut shortest_way_out(const Side& a, const Side& b, const Meeting& meeting, std::span<const Vec> hints,
                        const Holds& holds) {
  const Search search(a, b, holds);
  std::vector<Found> list;
  const auto offer = [&](const Vec& direction) {
    if (!(dot(direction, direction) > 0)) return;
    const Point unit_direction = rounded(unit(direction));
    list.push_back({search.along(unit_direction), unit_direction});
  };
  for (const Vec& hint : hints) offer(hint);
  for (const PartsMet& met : meeting.met) {
    offer(met.normal);
    for (const Vec& normal : {a.parts[met.a].normal, b.parts[met.b].normal}) {
      offer(normal);
      offer(-normal);
    }
  }
  for (int i = 0; i < spread; ++i) {
    const double z = 1 - (2.0 * i + 1) / spread, across = std::sqrt(1 - z * z), turn = 2.399963229728653 * i;
    offer({quad(across * std::cos(turn)), quad(across * std::sin(turn)), quad(z)});
  }
  std::ranges::sort(list, {}, &Found::depth);
  list.resize(std::min(list.size(), refined));
  for (Found& found : list) found = refine(search, found);
  std::ranges::sort(list, {}, &Found::depth);
  const Quad rounding = quad(1e-13) * (a.size + b.size);
  for (const Found& found : list) {
    if (!(found.depth < infinity)) break;
    // The move that was found in double ends the overlap but for rounding; a little more does so for certain.
    const Quad depth = quad(found.depth) + rounding;
    const Vec direction = unit(exact(found.direction));
    if (distance_after(a, b, direction * depth, 1) >= 0 &&
        !(holds && holds(direction * (depth + quad(1e-9) * (a.size + b.size)))))
      return {true, depth, direction};
  }
  return {};
}

}  // namespace oracle

// SPDX-License-Identifier: Apache-2.0
// The four points of a patch in its plane that span the largest area, where the patch has few points.
//
// Only points outside an octagon can span more area. Its corners are the points furthest in eight directions (Akl,
// Toussaint, "A fast convex hull algorithm", 1978).
export module abut.narrow.manifold.four_points;
import abut.core.standard;
import abut.math;
import abut.narrow.manifold.depth_order;

export namespace abut {

// Twice the area of the convex hull of four points: the largest cross product of two lines between them. In convex
// position these are the diagonals. Otherwise one point lies in the triangle of the others.
[[nodiscard]] inline Real twice_hull_of_four(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
  const auto turn = [](const Vec2& p, const Vec2& q) { return std::fabs(cross(p, q)); };
  return std::max({turn(ac, bd), turn(ab, cd), turn(ad, bc), turn(ab, ac), turn(ab, ad), turn(ac, ad), turn(bc, bd)});
}

// Four points of a patch by their places, and twice the area that they span.
struct Four {
  std::array<std::uint32_t, 4> places;
  Real twice_area;
};

[[nodiscard]] inline Four spanned(std::span<const Vec2> points, const std::array<std::uint32_t, 4>& places) {
  const auto& [a, b, c, d] = places;
  return {places, twice_hull_of_four(points[a], points[b], points[c], points[d])};
}

// Some places of a patch, in rising order.
using Places = Numbers;

// Finds the points that may be corners of the hull of all: those that do not lie within the octagon of the points that
// lie furthest in eight directions (Akl and Toussaint, A fast convex hull algorithm, 1978). What lies within spans no
// more than they do.
class Outside {
 public:
  inline explicit Outside(std::span<const Vec2> points) {
    std::array<std::uint32_t, 8> furthest{};
    Lanes most = all_lanes(-infinity), least = all_lanes(infinity);
    LaneNumbers place_of_most{}, place_of_least{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2& p = points[i];
      const Lanes along{p.x, p.x + p.y, p.y, p.y - p.x};
      const LaneNumbers place = LaneNumbers{} + static_cast<std::int64_t>(i);
      place_of_most = along > most ? place : place_of_most;
      place_of_least = along < least ? place : place_of_least;
      most = maximum(most, along);
      least = minimum(least, along);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      furthest[i] = static_cast<std::uint32_t>(place_of_most[i]);
      furthest[i + 4] = static_cast<std::uint32_t>(place_of_least[i]);
    }
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec2 &from = points[furthest[i]], way = points[furthest[(i + 1) % 8]] - from;
      const bool has_length = way.x != 0 || way.y != 0;
      is_point_ = is_point_ && !has_length;
      FourSides& four = sides_[i / 4];
      four.from_x[i % 4] = from.x;
      four.from_y[i % 4] = from.y;
      four.way_x[i % 4] = way.x;
      four.way_y[i % 4] = way.y;
      four.most[i % 4] = has_length ? 0 : -infinity;
    }
  }
  [[nodiscard]] inline bool has(const Vec2& point) const {
    LaneNumbers is_beyond = 0;
    for (const FourSides& four : sides_) {
      const Lanes x = point.x - four.from_x, y = point.y - four.from_y;
      is_beyond |= four.way_x * y - four.way_y * x <= four.most;
    }
    return bits_of(is_beyond) != 0 || is_point_;
  }

 private:
  // Of the octagon. A point is not within it where it lies no further to the left of a side than `most`: nowhere, of a
  // side without length.
  struct FourSides {
    Lanes from_x, from_y, way_x, way_y, most;
  };
  std::array<FourSides, 2> sides_;
  bool is_point_ = true;  // whether no side has a length
};

[[nodiscard]] inline Places places_outside(std::span<const Vec2> points) {
  [[clang::uninitialized]] const Outside outside(points);
  [[clang::uninitialized]] Places places;
  for (std::uint32_t place = 0; place < points.size(); ++place) {
    places.push_back_if(place, outside.has(points[place]));
  }
  return places;
}

// Exchanges one of the last three points for one of some others at a time, while that gains area.
[[nodiscard]] inline Four exchanged(std::span<const Vec2> points, std::span<const std::uint32_t> others, Four best,
                                    Real least_gain) {
  for (bool is_better = true; is_better;) {
    is_better = false;
    for (std::size_t i = 1; i < 4; ++i) {
      for (const std::uint32_t place : others) {
        Four other = best;
        other.places[i] = place;
        other = spanned(points, other.places);
        if (other.twice_area > best.twice_area + least_gain) {
          best = other;
          is_better = true;
        }
      }
    }
  }
  return best;
}

// Up to this many points, each is tried as the corner opposite to the first.
inline constexpr std::size_t few_points = 64;

// Four points about the first of a patch, and whether no four of the patch span more.
struct BestAbout {
  Four four;
  bool is_best;
};

// The sides of a line on which some points lie, several points at a time. The line leads from a first point.
class Sides {
 public:
  inline Sides(std::span<const Vec2> points, std::span<const std::uint32_t> places, std::uint32_t first)
      : count_(places.size()) {
    const std::size_t groups = (places.size() + 3) / 4;
    for (std::size_t i = 0; i < 4 * groups; ++i) {
      const Vec2 way = i < places.size() ? points[places[i]] - points[first] : Vec2{0, 0};
      x_[i / 4][i % 4] = way.x;
      y_[i / 4][i % 4] = way.y;
    }
  }

  // Twice the areas beside the line, the largest on either side; none are zero.
  struct Most {
    Real left, right;
  };
  [[nodiscard]] inline Most most_beside(const Vec2& across) const {
    Lanes left = all_lanes(0), right = left;
    for (std::size_t group = 0; 4 * group < count_; ++group) {
      const Lanes side = beside(across, group);
      left = maximum(left, side);
      right = maximum(right, -side);
    }
    return {largest(left), largest(right)};
  }
  // Which of the points comes first that has twice an area beside the line.
  [[nodiscard]] inline std::size_t first_beside(const Vec2& across, Real twice_area) const {
    std::size_t group = 0;
    std::uint64_t found = 0;
    while ((found = bits_of(beside(across, group) == all_lanes(twice_area))) == 0) {
      ++group;
    }
    return 4 * group + static_cast<std::size_t>(std::countr_zero(found));
  }

 private:
  [[nodiscard]] [[gnu::always_inline]] inline Lanes beside(const Vec2& across, std::size_t group) const {
    return all_lanes(across.x) * y_[group] - all_lanes(across.y) * x_[group];
  }

  std::size_t count_;
  std::array<Lanes, few_points / 4> x_, y_;
};

// The four points of largest area that have the first as a corner: each other point is tried as the opposite corner,
// with the points furthest off their line on either side. Where a side has no points, the first one takes the place.
// The first point is then a corner of the hull of all: four points within which it lies do not exist.
[[nodiscard]] inline BestAbout best_about(std::span<const Vec2> points, std::span<const std::uint32_t> others,
                                          std::uint32_t first) {
  BestAbout best{{{first, first, first, first}, 0}, false};
  [[clang::uninitialized]] const Sides sides(points, others, first);
  for (const std::uint32_t opposite : others) {
    const Vec2 across = points[opposite] - points[first];
    const auto [left, right] = sides.most_beside(across);
    best.is_best = best.is_best || (left == 0) != (right == 0);
    if (left + right > best.four.twice_area) {
      best.four = {{first, opposite, left > 0 ? others[sides.first_beside(across, left)] : first,
                    right > 0 ? others[sides.first_beside(across, -right)] : first},
                   left + right};
    }
  }
  return best;
}

}  // namespace abut

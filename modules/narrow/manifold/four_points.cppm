// SPDX-License-Identifier: Apache-2.0
// The four points of a patch in its plane that span the largest area, where the patch has few points.
export module abut.narrow.manifold.four_points;
import abut.core.standard;
import abut.math;

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

// Exchanges one of the last three points at a time while that gains area.
[[nodiscard]] inline Four exchanged(std::span<const Vec2> points, Four best, Real least_gain) {
  for (bool is_better = true; is_better;) {
    is_better = false;
    for (std::size_t i = 1; i < 4; ++i) {
      for (std::uint32_t place = 0; place < points.size(); ++place) {
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

// The sides of a line on which all points of a patch lie, several points at a time. The line leads from the first
// point.
class Sides {
 public:
  inline Sides(std::span<const Vec2> points, std::uint32_t first) : count_(points.size()) {
    const std::size_t groups = (count_ + 3) / 4;
    for (std::size_t i = 0; i < 4 * groups; ++i) {
      const Vec2 way = i < count_ ? points[i] - points[first] : Vec2{0, 0};
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
  // The first point with twice an area beside the line.
  [[nodiscard]] inline std::uint32_t place_of(const Vec2& across, Real twice_area) const {
    std::size_t group = 0;
    std::uint64_t found = 0;
    while ((found = bits_of(beside(across, group) == all_lanes(twice_area))) == 0) {
      ++group;
    }
    return static_cast<std::uint32_t>(4 * group + static_cast<std::size_t>(std::countr_zero(found)));
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
[[nodiscard]] inline BestAbout best_about(std::span<const Vec2> points, std::uint32_t first) {
  BestAbout best{{{first, first, first, first}, 0}, false};
  [[clang::uninitialized]] const Sides sides(points, first);
  for (std::uint32_t opposite = 0; opposite < points.size(); ++opposite) {
    const Vec2 across = points[opposite] - points[first];
    const auto [left, right] = sides.most_beside(across);
    best.is_best = best.is_best || (left == 0) != (right == 0);
    if (left + right > best.four.twice_area) {
      best.four = {{first, opposite, left > 0 ? sides.place_of(across, left) : first,
                    right > 0 ? sides.place_of(across, -right) : first},
                   left + right};
    }
  }
  return best;
}

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// The points of a patch that span the largest area. Four of a few points are found by trying; more points are added
// one by one, the one that adds most first.
export module abut.narrow.manifold.choice;
import abut.core.standard;
import abut.math;
import abut.narrow.manifold.four_points;

export namespace abut {

// A choice of points of a patch in its plane: their places, and the polygon of those that span it, counter-clockwise.
// More than 64 span no more.
class Choice {
 public:
  static constexpr std::size_t capacity = 64;
  // Points within this share of the extent of a line are on it. Then the length counts, not the area.
  static constexpr Real flatness = 1e-5, least_gain = 1e-12;

  Choice(std::span<const Vec2> points, std::uint32_t first) { add(points, first); }
  // A place that occurs twice counts once.
  explicit Choice(const Four& four) : twice_area_(four.twice_area) {
    for (const std::uint32_t place : four.places) {
      if (!has(place)) {
        places_[size_++] = place;
      }
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> places() const [[clang::lifetimebound]] {
    return std::span(places_).first(size_);
  }
  [[nodiscard]] bool has(std::uint32_t place) const { return std::ranges::find(places(), place) != places().end(); }
  [[nodiscard]] Real twice_area(std::span<const Vec2> points) const {
    return size_ == 4 ? spanned(points, four()).twice_area : twice_area_;
  }
  [[nodiscard]] std::array<std::uint32_t, 4> four() const { return {places_[0], places_[1], places_[2], places_[3]}; }

  // Takes a point whatever it adds, unless there are as many as there may be.
  void keep(std::uint32_t place, std::size_t most) {
    if (!has(place) && size_ < std::min(most, capacity)) {
      places_[size_++] = place;
    }
  }

  // Takes the points of some places that add most, one by one, up to `most`. What counts is the area. Where there is
  // none, it is the length of the way around, so that the ends of a line stay.
  void grow(std::span<const Vec2> points, std::span<const std::uint32_t> among, std::size_t most, Real extent) {
    const auto add_best = [&](Real least, auto&& score) {
      Best best{least, 0, false};
      for (const std::uint32_t place : among) {
        if (!has(place)) {
          best.offer(score(points[place]), place);
        }
      }
      if (best.is_found) {
        add(points, best.place);
      }
      return best.is_found;
    };
    const Real flat = flatness * extent * extent;
    for (bool is_growing = true; is_growing && size_ < std::min(most, capacity);) {
      is_growing = (corners_ > 1 && add_best(flat, [&](const Vec2& p) { return gain(p).area; })) ||
                   (twice_area_ <= flat && add_best(least_gain * extent, [&](const Vec2& p) { return detour(p); }));
    }
  }

 private:
  [[nodiscard]] static Real length(const Vec2& way) { return std::sqrt(dot(way, way)); }
  struct Best {
    Real score;
    std::uint32_t place;
    bool is_found;
    void offer(Real value, std::uint32_t i) {
      if (value > score) {
        *this = {value, i, true};
      }
    }
  };
  // Twice the area that a point adds beside one of the sides, and the corner that this side leaves.
  struct Gain {
    Real area;
    std::size_t after;
  };

  [[nodiscard]] Gain gain(const Vec2& p) const {
    Gain best{-infinity, 0};
    for (std::size_t i = 0; i < corners_; ++i) {
      const Vec2 &from = polygon_[i + 1 < corners_ ? i + 1 : 0], &to = polygon_[i];
      const Real added = cross(to - from, p - from);
      best = added > best.area ? Gain{added, i} : best;
    }
    return best;
  }
  // The length by which a visit makes the way around the corners longer.
  [[nodiscard]] Real detour(const Vec2& p) const {
    Real least = infinity;
    for (std::size_t i = 0; i < corners_; ++i) {
      const Vec2 &from = polygon_[i], &to = polygon_[i + 1 < corners_ ? i + 1 : 0];
      least = std::min(least, length(p - from) + length(p - to) - length(to - from));
    }
    return least;
  }
  void add(std::span<const Vec2> points, std::uint32_t place) {
    const Vec2 point = points[place];
    std::size_t corner = 0;
    if (corners_ > 0) {
      const Gain found = gain(point);
      twice_area_ += std::max(found.area, Real{0});
      corner = found.after + 1;
    }
    const std::span<Vec2> corners = std::span(polygon_).first(++corners_);
    const auto at = corners.begin() + static_cast<std::ptrdiff_t>(corner);
    std::move_backward(at, corners.end() - 1, corners.end());
    *at = point;
    places_[size_++] = place;
  }

  std::array<Vec2, capacity> polygon_;
  std::array<std::uint32_t, capacity> places_;
  std::size_t size_ = 0, corners_ = 0;
  Real twice_area_ = 0;
};

// The points that span most with a first one. `outside` are those that may be corners of the hull of all.
[[nodiscard]] inline Choice choose(std::span<const Vec2> points, std::span<const std::uint32_t> outside,
                                   std::uint32_t first, std::size_t most, Real extent) {
  const Real flat = Choice::flatness * extent * extent, least_gain = Choice::least_gain * extent * extent;
  if (most == 4 && outside.size() <= few_points) {
    const auto [best, is_best] = best_about(points, outside, first);
    if (best.twice_area > flat) {
      return Choice(is_best ? best : exchanged(points, outside, spanned(points, best.places), least_gain));
    }
  }
  Choice choice(points, first);
  choice.grow(points, outside, most, extent);
  if (most == 4 && choice.places().size() == 4 && choice.twice_area(points) > flat) {
    return Choice(exchanged(points, outside, spanned(points, choice.four()), least_gain));
  }
  return choice;
}

}  // namespace abut

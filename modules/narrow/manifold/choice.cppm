// SPDX-License-Identifier: Apache-2.0
// The points of a patch that span the largest area. Four of a few points are found by trying; more points are added
// one by one, the one that adds most first.
export module abut.narrow.manifold.choice;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.manifold.four_points;

export namespace abut {

[[nodiscard]] inline bool comes_before(const ContactPoint& a, const ContactPoint& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
}

[[nodiscard]] inline Vec3 middle(const ContactPoint& contact) { return 0.5 * (contact.point_a + contact.point_b); }

// Twice the signed area of a triangle seen against the normal.
[[nodiscard]] inline Real area(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  return dot(normal, cross(b - a, c - a));
}

// A point of a patch in the plane across its normal.
using Flats = SmallVector<Vec2, 256>;

[[nodiscard]] inline Flats flattened(std::span<const ContactPoint> patch) {
  const Tangents tangents = tangents_of(patch[0].normal);
  const Vec3 base = middle(patch[0]);
  [[clang::uninitialized]] Flats points;
  for (const ContactPoint& contact : patch) {
    const Vec3 d = middle(contact) - base;
    points.push_back({dot(d, tangents.first), dot(d, tangents.second)});
  }
  return points;
}

// What contacts are put in order by.
struct DepthKey {
  Real distance;
  std::uint64_t id;
  std::uint32_t place;
};

// Puts a few keys in the order of their distances: how many are less tells the place of each. False, with nothing done,
// where there are many, or where two tie.
[[nodiscard]] inline bool sort_by_rank(std::span<DepthKey> keys) {
  constexpr std::size_t most = 128;
  if (keys.size() > most) {
    return false;
  }
  [[clang::uninitialized]] std::array<Lanes, most / 4> distances;
  const std::size_t groups = (keys.size() + 3) / 4;
  for (std::size_t i = 0; i < 4 * groups; ++i) {
    distances[i / 4][i % 4] = i < keys.size() ? keys[i].distance : infinity;
  }
  [[clang::uninitialized]] std::array<DepthKey, most> sorted;
  std::array<bool, most> taken{};
  for (const DepthKey& key : keys) {
    LaneNumbers less = 0;
    for (std::size_t group = 0; group < groups; ++group) {
      less -= distances[group] < all_lanes(key.distance);
    }
    const auto rank = static_cast<std::size_t>(less[0] + less[1] + less[2] + less[3]);
    if (taken[rank]) {
      return false;
    }
    taken[rank] = true;
    sorted[rank] = key;
  }
  std::ranges::copy(std::span(sorted).first(keys.size()), keys.begin());
  return true;
}

// Moves contacts, which are large, once each: what comes to a place is at from(place), which is a number that changes.
template <class From>
void arrange(std::span<ContactPoint> contacts, From&& from) {
  for (std::uint32_t start = 0; start < contacts.size(); ++start) {
    if (from(start) == start) {
      continue;
    }
    const ContactPoint first = contacts[start];
    std::uint32_t to = start;
    while (from(to) != start) {
      const std::uint32_t next = from(to);
      contacts[to] = contacts[next];
      from(to) = to;
      to = next;
    }
    contacts[to] = first;
    from(to) = to;
  }
}

// Puts contacts into the order of `comes_before`. They are large: small keys are sorted, and each contact moves once.
// Of very many, which are rare, no list of keys is made: that would take memory from step to step.
inline void sort_by_depth(std::span<ContactPoint> contacts) {
  constexpr std::size_t most_keys = 256;
  if (std::ranges::is_sorted(contacts, comes_before)) {
    return;
  }
  if (contacts.size() > most_keys) {
    std::ranges::sort(contacts, comes_before);
    return;
  }
  [[clang::uninitialized]] SmallVector<DepthKey, most_keys> keys;
  for (std::uint32_t place = 0; place < contacts.size(); ++place) {
    keys.push_back({contacts[place].distance, contacts[place].id, place});
  }
  const std::span<DepthKey> order = keys.span();
  if (!sort_by_rank(order)) {
    std::ranges::sort(order, [](const DepthKey& a, const DepthKey& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.id != b.id ? a.id < b.id : a.place < b.place;
    });
  }
  arrange(contacts, [&](std::uint32_t place) -> std::uint32_t& { return order[place].place; });
}

// How far the contacts lie from the first one.
[[nodiscard]] inline Real extent_of(std::span<const ContactPoint> contacts) {
  Real square = 0;
  for (const ContactPoint& contact : contacts) {
    square = std::max(square, squared_norm(middle(contact) - middle(contacts[0])));
  }
  return std::sqrt(square);
}

// A choice of points of a patch: their places, and the polygon of those that span it, counter-clockwise seen against
// the normal. More than 64 span no more.
class Choice {
 public:
  static constexpr std::size_t capacity = 64;
  // Points within this share of the extent of a line are on it. Then the length counts, not the area.
  static constexpr Real flatness = 1e-5;

  Choice(std::span<const ContactPoint> patch, std::uint32_t first) : normal_(patch[first].normal) { add(patch, first); }
  // A place that occurs twice counts once.
  explicit Choice(const Four& four) : twice_area_(four.twice_area) {
    for (const std::uint32_t place : four.places) {
      if (!has(place)) {
        places_[size_++] = place;
      }
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> places() const { return std::span(places_).first(size_); }
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

  // Takes the points that add most, one by one, up to `most`. What counts is the area. Where there is none, it is the
  // length of the way around, so that the ends of a line stay.
  void grow(std::span<const ContactPoint> patch, std::size_t most, Real extent) {
    grow_among(patch, patch.size(), [](std::size_t i) { return static_cast<std::uint32_t>(i); }, most, extent);
  }
  // The same of some places alone.
  void grow_among(std::span<const ContactPoint> patch, std::span<const std::uint32_t> places, std::size_t most,
                  Real extent) {
    grow_among(patch, places.size(), [&](std::size_t i) { return places[i]; }, most, extent);
  }

 private:
  template <class PlaceOf>
  void grow_among(std::span<const ContactPoint> patch, std::size_t count, const PlaceOf& place_of, std::size_t most,
                  Real extent) {
    const auto add_best = [&](Real least, auto&& score) {
      Best best{least, 0, false};
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t place = place_of(i);
        if (!has(place)) {
          best.offer(score(middle(patch[place])), place);
        }
      }
      if (best.is_found) {
        add(patch, best.place);
      }
      return best.is_found;
    };
    const Real flat = flatness * extent * extent;
    for (bool is_growing = true; is_growing && size_ < std::min(most, capacity);) {
      is_growing = (corners_ > 1 && add_best(flat, [&](const Vec3& p) { return gain(p).area; })) ||
                   (twice_area_ <= flat && add_best(1e-12 * extent, [&](const Vec3& p) { return detour(p); }));
    }
  }

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

  [[nodiscard]] Gain gain(const Vec3& p) const {
    Gain best{-infinity, 0};
    for (std::size_t i = 0; i < corners_; ++i) {
      const Real added = area(polygon_[i + 1 < corners_ ? i + 1 : 0], polygon_[i], p, normal_);
      best = added > best.area ? Gain{added, i} : best;
    }
    return best;
  }
  // The length by which a visit makes the way around the corners longer.
  [[nodiscard]] Real detour(const Vec3& p) const {
    Real least = infinity;
    for (std::size_t i = 0; i < corners_; ++i) {
      const Vec3 &from = polygon_[i], &to = polygon_[i + 1 < corners_ ? i + 1 : 0];
      least = std::min(least, norm(p - from) + norm(p - to) - norm(to - from));
    }
    return least;
  }
  void add(std::span<const ContactPoint> patch, std::uint32_t place) {
    const Vec3 point = middle(patch[place]);
    std::size_t corner = 0;
    if (corners_ > 0) {
      const Gain found = gain(point);
      twice_area_ += std::max(found.area, Real{0});
      corner = found.after + 1;
    }
    const std::span<Vec3> corners = std::span(polygon_).first(++corners_);
    const auto at = corners.begin() + static_cast<std::ptrdiff_t>(corner);
    std::move_backward(at, corners.end() - 1, corners.end());
    *at = point;
    places_[size_++] = place;
  }

  Vec3 normal_{0, 0, 0};
  std::array<Vec3, capacity> polygon_;
  std::array<std::uint32_t, capacity> places_;
  std::size_t size_ = 0, corners_ = 0;
  Real twice_area_ = 0;
};

// The points that span most with a first one.
[[nodiscard]] inline Choice choose(std::span<const ContactPoint> patch, std::span<const Vec2> points,
                                   std::uint32_t first, std::size_t most, Real extent) {
  const Real flat = Choice::flatness * extent * extent, least_gain = 1e-12 * extent * extent;
  if (most == 4 && patch.size() <= few_points) {
    const auto [best, is_best] = best_about(points, first);
    if (best.twice_area > flat) {
      return Choice(is_best ? best : exchanged(points, spanned(points, best.places), least_gain));
    }
  }
  Choice choice(patch, first);
  choice.grow(patch, most, extent);
  if (most == 4 && choice.places().size() == 4 && choice.twice_area(points) > flat) {
    return Choice(exchanged(points, spanned(points, choice.four()), least_gain));
  }
  return choice;
}

}  // namespace abut

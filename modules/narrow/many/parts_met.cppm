// SPDX-License-Identifier: Apache-2.0
// The triangles of a surface that a shape meets. They tell how far the shape has to move to be parted from all.
export module abut.narrow.many.parts_met;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.many.triangle_contacts;

export namespace abut {

// The corners of b in the frame of a, where b is a triangle.
template <Convex B>
struct PlacedCorners {};
template <>
struct PlacedCorners<Triangle> {
  TriangleCorners of;
};

// A triangle of a surface and what it meets, as far as directions are asked that might part them.
template <Convex B>
class PartMet {
 public:
  PartMet() = default;
  // `gap`: how far both are apart; not positive where they overlap. `noise`: how far both may overlap that only touch.
  PartMet(const Triangle& triangle, const B& b, const Pose& ab, const Fronts<B>& fronts, Real gap, Real noise)
      : corners_(triangle.corners()), fronts_(fronts), gap_(gap), noise_(noise), index_(triangle.index()) {
    if constexpr (std::same_as<B, Triangle>) {
      placed_.of = {ab * b.corners()[0], ab * b.corners()[1], ab * b.corners()[2]};
    }
  }
  [[nodiscard]] Real gap() const { return gap_; }
  // Whether b meets the triangle on a way of some length.
  [[nodiscard]] bool is_met_within(Real depth) const { return gap_ <= depth + noise_; }
  [[nodiscard]] std::uint32_t index() const { return index_; }
  // How far b has to move along a direction to be parted from the triangle; without end where it would have to pass
  // through the front of a side. `lowest`: where b begins along the direction, unless it is a triangle.
  [[nodiscard]] Real overlap_along(const Vec3& direction, Real lowest) const {
    if constexpr (std::same_as<B, Triangle>) {
      lowest = least_along(placed_.of, direction);
    }
    const Real overlap = -least_along(corners_, -direction) - lowest;
    return overlap <= noise_ || fronts_.nearly_allows(direction) ? overlap : infinity;
  }
  // The same for four directions at once. `lowest`: where b begins, or a point of b that tells no more than that.
  [[nodiscard]] Lanes overlaps_along(const Columns& directions, Lanes lowest) const {
    const auto along = [&](const TriangleCorners& corners, const auto& better) {
      const auto at = [&](std::size_t i) { return dot(directions, Columns::all(corners[i])); };
      return better(better(at(0), at(1)), at(2));
    };
    if constexpr (std::same_as<B, Triangle>) {
      lowest = along(placed_.of, [](Lanes p, Lanes q) { return minimum(p, q); });
    }
    const Lanes highest = along(corners_, [](Lanes p, Lanes q) { return maximum(p, q); });
    const Lanes overlaps = highest - lowest;
    return (overlaps <= all_lanes(noise_)) | fronts_.nearly_allow(directions) ? overlaps : all_lanes(infinity);
  }

 private:
  TriangleCorners corners_;
  Fronts<B> fronts_;
  Real gap_, noise_;
  std::uint32_t index_;
  [[no_unique_address]] PlacedCorners<B> placed_;
};

// How far b has to move along a direction to be parted.
struct PartingWay {
  Real depth;
  Vec3 direction;
};

template <Convex B>
class PartsMet {
 public:
  // The number of the new part.
  std::size_t add(const Triangle& triangle, const B& b, const Pose& ab, const Fronts<B>& fronts, Real gap, Real noise) {
    parts_.push_back(PartMet<B>(triangle, b, ab, fronts, gap, noise));
    add_face(triangle.normal(), triangle.is_one_sided());
    if constexpr (std::same_as<B, Triangle>) {
      add_face(-(ab.rotation * b.normal()), b.is_one_sided());
    }
    return parts_.size() - 1;
  }
  [[nodiscard]] std::size_t size() const { return parts_.size(); }
  // Whether a triangle of the surface, by its number, is one of them.
  [[nodiscard]] bool has(std::uint32_t index) const {
    return std::ranges::find(parts_.span(), index, &PartMet<B>::index) != parts_.span().end();
  }
  // Directions that might part the whole: the normals of contacts, the least ways out of parts, and the ways out of
  // faces.
  void add_way(const Vec3& way) {
    const std::span<const Vec3> ways = ways_.span();
    const auto is_it = [&](const Vec3& other) { return other == way; };
    if (std::ranges::none_of(ways.last(std::min<std::size_t>(ways.size(), 4)), is_it)) {
      ways_.push_back(way);
    }
  }

  [[nodiscard]] Lanes overlaps_along(std::size_t part, const Columns& directions, Lanes lowest) const {
    return parts_[part].overlaps_along(directions, lowest);
  }

  // How far b has to move, along the best of the ways and of the mean of `normals`; not more than `most`, by which the
  // part `deepest` overlaps. `lowest_along`: where b begins along a direction; `inner`: no later than there.
  template <class LowestAlong>
  [[nodiscard]] PartingWay way_out(const Vec3& normals, std::size_t deepest, Real most, const LowestAlong& lowest_along,
                                   const Vec3& inner) const {
    PartingWay best{most, {0, 0, 0}};
    // Parts that lately were not parted are asked first: one of them mostly stands in the way again.
    std::array<std::size_t, 4> blocking;
    blocking.fill(deepest);
    const auto consider = [&](const Vec3& direction) {
      const Real depth = overlap_of_all(direction, lowest_along(direction), best.depth, blocking);
      best = depth < best.depth ? PartingWay{depth, direction} : best;
    };
    // Over a crest the way between the faces is shorter than out of any one of them.
    if (const auto between = UnitVec3::make(normals)) {
      consider(*between);
    }
    const std::span<const Vec3> ways = ways_.span();
    for (std::size_t first = 0; first < ways.size(); first += 4) {
      const auto way = [&](std::size_t lane) { return lanes_of(ways[std::min(first + lane, ways.size() - 1)]); };
      const PartMet<B>& part = parts_[blocking[0]];
      const std::size_t count = std::min<std::size_t>(ways.size() - first, 4);
      std::uint64_t open = (std::uint64_t{1} << count) - 1;
      if (part.gap() <= 0) {
        const Columns four = Columns::of(way(0), way(1), way(2), way(3));
        open &= bits_of(part.overlaps_along(four, dot(four, Columns::all(inner))) < all_lanes(best.depth));
      }
      for (; open != 0; open &= open - 1) {
        consider(ways[first + static_cast<std::size_t>(std::countr_zero(open))]);
      }
    }
    return best;
  }

  // The number of the triangle that is parted last along a way out.
  [[nodiscard]] std::uint32_t last_along(const PartingWay& way, Real lowest) const {
    const auto is_later = [&](const PartMet<B>& one, const PartMet<B>& other) {
      const auto overlap = [&](const PartMet<B>& part) {
        return part.is_met_within(way.depth) ? part.overlap_along(way.direction, lowest) : -infinity;
      };
      return std::pair(overlap(one), other.index()) > std::pair(overlap(other), one.index());
    };
    return std::ranges::min_element(parts_.span(), is_later)->index();
  }

 private:
  void add_face(const Vec3& normal, bool is_one_sided) {
    if (squared_norm(normal) > 0) {
      add_way(normal);
      if (!is_one_sided) {
        add_way(-normal);
      }
    }
  }

  // How far b has to move along a direction until it overlaps no part, nor enters one on the way. Where that is as
  // far as `enough`, the answer is `enough`, and the part that overlaps so far comes first in a list.
  [[nodiscard]] Real overlap_of_all(const Vec3& direction, Real lowest, Real enough,
                                    std::span<std::size_t> blocking) const {
    const std::span<const PartMet<B>> parts = parts_.span();
    for (const std::size_t part : blocking) {
      if (parts[part].gap() <= 0 && parts[part].overlap_along(direction, lowest) >= enough) {
        return enough;
      }
    }
    Real depth = 0;
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (std::size_t part = 0; part < parts.size(); ++part) {
        if (!parts[part].is_met_within(depth)) {
          continue;
        }
        const Real overlap = parts[part].overlap_along(direction, lowest);
        if (overlap >= enough) {
          if (parts[part].gap() <= 0) {
            std::move_backward(blocking.begin(), blocking.end() - 1, blocking.end());
            blocking.front() = part;
          }
          return enough;
        }
        has_grown = has_grown || overlap > depth;
        depth = std::max(depth, overlap);
      }
    }
    return depth;
  }

  SmallVector<PartMet<B>, 64> parts_;
  SmallVector<Vec3, 192> ways_;
};

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// Which contacts of a surface may stand beside each other. A contact claims that parting the two shapes takes its depth
// along its normal. A triangle may claim too much where a neighbour has the least way out. Where the claim of another
// contact parts this triangle as well, by less than this triangle claims, only the other claim counts.
export module abut.narrow.many.claims;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.math.places_in_order;

export namespace abut {

// Depths that differ by less, relative to them, agree: turning a normal by a thousandth costs half as much.
inline constexpr Real claim_blur = 1e-6;

class Claims {
 public:
  // `is_turned`: the normal is that of a face, not that of the least way out.
  void add(const Vec3& normal, Real depth, bool is_turned) { claims_.push_back({normal, depth, is_turned}); }

  // To be called after the last one. One claim is enough for normals that are alike, and some are enough of many: fewer
  // claims leave more contacts. The order in which they came has no say. `lowest_along`: where b begins along a
  // direction.
  template <class LowestAlong>
  void settle(const LowestAlong& lowest_along) {
    count_ = 0;
    [[clang::uninitialized]] const Places order = in_order();
    for (const std::uint32_t place : order.span()) {
      if (count_ == most_claims) {
        break;
      }
      if (const Claim& claim = claims_[place]; !has_alike(claim)) {
        count(claim, lowest_along(claim.normal));
      }
    }
  }

  // The depth along a normal that a triangle may claim. Its contacts there are as deep as `depth`.
  // `overlaps_along` tells how far b has to move along four directions to be parted from the triangle, from where b
  // begins along each.
  template <class OverlapsAlong>
  [[nodiscard]] Real allowed_depth(const Vec3& normal, Real depth, Real noise,
                                   const OverlapsAlong& overlaps_along) const {
    const Real blur = claim_blur * depth + noise;
    Lanes allowed = all_lanes(infinity);
    for (std::size_t first = 0; first < count_; first += 4) {
      const Four& four = fours_[first / 4];
      const Lanes shares = four.depth * dot(four.normals, Columns::all(normal)) + blur;
      // Where both are turned, the less deep one is right.
      const LaneNumbers may_judge =
          (four.judged_above < all_lanes(depth - blur)) & (shares < minimum(all_lanes(depth), allowed));
      if (bits_of(may_judge) != 0) {
        const LaneNumbers do_part = overlaps_along(four.normals, four.lowest) <= four.depth + noise;
        allowed = may_judge & do_part ? shares : allowed;
      }
    }
    return -largest(-allowed);
  }

 private:
  struct Claim {
    Vec3 normal;
    Real depth;
    bool is_turned;
  };
  static constexpr std::size_t few_claims = 64, most_claims = 16;
  using Places = SmallVector<std::uint32_t, few_claims>;
  // Claims that count, one per lane.
  struct Four {
    Columns normals;
    Lanes depth, lowest;
    Lanes judged_above;  // the depth that contacts exceed which the claim may judge
  };

  // What was not turned comes first, then what is deeper.
  [[nodiscard]] Places in_order() const {
    const std::span<const Claim> claims = claims_.span();
    [[clang::uninitialized]] Places places;
    for (std::uint32_t place = 0; place < claims.size(); ++place) {
      places.push_back(place);
    }
    const auto value_of = [&](std::uint32_t place) {
      return claims[place].is_turned ? -claims[place].depth : -infinity;
    };
    const auto is_before = [&](std::uint32_t place, std::uint32_t other) {
      const Claim &a = claims[place], &b = claims[other];
      return std::tie(a.is_turned, b.depth, a.normal.x, a.normal.y, a.normal.z) <
             std::tie(b.is_turned, a.depth, b.normal.x, b.normal.y, b.normal.z);
    };
    if (claims.size() > few_claims || !rank_few<few_claims>(places.span(), value_of, is_before)) {
      std::ranges::sort(places.span(), is_before);
    }
    return places;
  }
  // Whether one that counts has nearly the same normal and was found in the same way.
  [[nodiscard]] bool has_alike(const Claim& claim) const {
    const Columns normal = Columns::all(claim.normal);
    LaneNumbers alike = 0;
    for (const Four& four : std::span(fours_).first((count_ + 3) / 4)) {
      const LaneNumbers turned = four.judged_above > all_lanes(-infinity);
      alike |= (dot(four.normals, normal) > all_lanes(1 - 1e-4)) & (claim.is_turned ? turned : ~turned);
    }
    return bits_of(alike) != 0;
  }
  void count(const Claim& claim, Real lowest) {
    Four& four = fours_[count_ / 4];
    const std::size_t lane = count_ % 4;
    if (lane == 0) {
      // Those that lack claim more than any other.
      four = {Columns::all({0, 0, 0}), all_lanes(infinity), all_lanes(0), all_lanes(infinity)};
    }
    four.normals.put(lane, claim.normal);
    four.depth[lane] = claim.depth;
    four.lowest[lane] = lowest;
    four.judged_above[lane] = claim.is_turned ? claim.depth : -infinity;
    ++count_;
  }

  SmallVector<Claim, few_claims> claims_;
  std::array<Four, most_claims / 4> fours_;
  std::size_t count_ = 0;
};

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// Which contacts of a surface may stand beside each other. A contact claims that parting the two shapes takes its depth
// along its normal. A triangle may claim too much where a neighbour has the least way out. Where the claim of another
// contact parts this triangle as well, by less than this triangle claims, only the other claim counts.
export module abut.narrow.many.claims;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;

export namespace abut {

// Depths that differ by less, relative to them, agree: turning a normal by a thousandth costs half as much.
inline constexpr Real claim_blur = 1e-6;

class Claims {
 public:
  // `is_turned`: the normal is that of a face, not that of the least way out.
  void add(const Vec3& normal, Real depth, bool is_turned) { claims_.push_back({normal, depth, 0, is_turned}); }

  // To be called after the last one. One claim is enough for normals that are alike, and some are enough of many: fewer
  // claims leave more contacts. The order in which they came has no say. `lowest_along`: where b begins along a
  // direction.
  template <class LowestAlong>
  void settle(const LowestAlong& lowest_along) {
    const std::span<Claim> claims = claims_.span();
    std::ranges::sort(claims, [](const Claim& a, const Claim& b) {
      return std::tie(a.is_turned, b.depth, a.normal.x, a.normal.y, a.normal.z) <
             std::tie(b.is_turned, a.depth, b.normal.x, b.normal.y, b.normal.z);
    });
    count_ = 0;
    for (std::size_t i = 0; i < claims.size() && count_ < most_claims; ++i) {
      const Claim& claim = claims[i];
      const bool is_new = std::ranges::none_of(claims.first(count_), [&](const Claim& other) {
        return other.is_turned == claim.is_turned && dot(other.normal, claim.normal) > 1 - 1e-4;
      });
      if (is_new) {
        claims[count_] = claim;
        claims[count_].lowest = lowest_along(claim.normal);
        ++count_;
      }
    }
    for (std::size_t i = 0; i < (count_ + 3) / 4 * 4; ++i) {
      Four& four = fours_[i / 4];
      const bool counts = i < count_;
      const Claim none{{0, 0, 0}, infinity, 0, true};  // claims more than any other
      const Claim& claim = counts ? claims[i] : none;
      four.x[i % 4] = claim.normal.x;
      four.y[i % 4] = claim.normal.y;
      four.z[i % 4] = claim.normal.z;
      four.depth[i % 4] = claim.depth;
      four.lowest[i % 4] = claim.lowest;
      four.judged_above[i % 4] = claim.is_turned ? claim.depth : -infinity;
    }
  }

  // Of the claims that count.
  [[nodiscard]] Vec3 sum_of_normals() const {
    Vec3 sum{0, 0, 0};
    for (const Claim& claim : claims_.span().first(count_)) {
      sum = sum + claim.normal;
    }
    return sum;
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
      const Columns normals{four.x, four.y, four.z};
      const Lanes shares = four.depth * dot(normals, Columns::all(normal)) + blur;
      // Where both are turned, the less deep one is right.
      const LaneNumbers may_judge =
          (four.judged_above < all_lanes(depth - blur)) & (shares < minimum(all_lanes(depth), allowed));
      if (bits_of(may_judge) != 0) {
        const LaneNumbers do_part = overlaps_along(normals, four.lowest) <= four.depth + noise;
        allowed = may_judge & do_part ? shares : allowed;
      }
    }
    return -largest(-allowed);
  }

 private:
  struct Claim {
    Vec3 normal;
    Real depth;
    Real lowest;
    bool is_turned;
  };
  static constexpr std::size_t most_claims = 16;
  // Claims that count, one per lane.
  struct Four {
    Lanes x, y, z, depth, lowest;
    Lanes judged_above;  // the depth that contacts exceed which the claim may judge
  };

  SmallVector<Claim, 64> claims_;
  std::array<Four, most_claims / 4> fours_;
  std::size_t count_ = 0;  // of those that count, which come first
};

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// Which contacts of a surface may stand beside each other. A contact claims that parting the two shapes takes its depth
// along its normal. A triangle may claim too much where a neighbour has the least way out. Where the claim of another
// contact parts this triangle as well, by less than this triangle claims, only the other claim counts.
export module abut.narrow.many.claims;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// Depths that differ by less, relative to them, agree: turning a normal by a thousandth costs half as much.
inline constexpr Real claim_blur = 1e-6;

class Claims {
 public:
  // `is_turned`: the normal is that of a face, not that of the least way out.
  void add(const Vec3& normal, Real depth, bool is_turned) {
    // One claim is enough for normals that are alike, and some are enough of many: fewer claims leave more contacts.
    for (Claim& claim : claims_.span()) {
      if (claim.is_turned == is_turned && dot(claim.normal, normal) > 1 - 1e-4) {
        if (depth > claim.depth) {
          claim = {normal, depth, is_turned};
        }
        return;
      }
    }
    if (claims_.size() < most_claims) {
      claims_.push_back({normal, depth, is_turned});
    }
  }

  // The depth along a normal that a triangle may claim. Its contacts there are as deep as `depth`.
  // `overlap_along` tells how far b has to move along a direction to be parted from the triangle.
  template <class OverlapAlong>
  [[nodiscard]] Real allowed_depth(const Vec3& normal, Real depth, Real noise,
                                   const OverlapAlong& overlap_along) const {
    const Real blur = claim_blur * depth + noise;
    Real allowed = infinity;
    for (const Claim& claim : claims_.span()) {
      const Real share = claim.depth * dot(claim.normal, normal) + blur;
      // Where both are turned, the less deep one is right.
      const bool may_judge = !claim.is_turned || claim.depth < depth - blur;
      if (may_judge && share < std::min(depth, allowed) && overlap_along(claim.normal) <= claim.depth + noise) {
        allowed = share;
      }
    }
    return allowed;
  }

 private:
  struct Claim {
    Vec3 normal;
    Real depth;
    bool is_turned;
  };
  static constexpr std::size_t most_claims = 16;

  SmallVector<Claim, most_claims> claims_;
};

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// How deep the convex hull of two discs across one axis, a cylinder or a cone, overlaps with a polytope or another one.
//
// The least depth is the least support function h of the difference D of both over all unit directions. Where h is
// least, D is smooth or has a face. Such directions come in a few families (faces of sums of convex bodies: Schneider,
// "Convex bodies: the Brunn-Minkowski theory", section 1.7):
//
// - faces: of a polytope, the ends of discs, a line of one side across a line of the other or across an edge;
// - the side of discs toward a corner, a tip, or a rim of the other body;
// - a rim across an edge of a polytope, or a rim of the other discs.
//
// Where a rim takes part, a family is a curve: rim_walk.cppm finds where on it D is nearest to the origin. No other
// direction needs to be tried, so the least depth found is proven.
export module abut.narrow.fan.discs.disc_depth;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;

export namespace abut {

// Discs in the frame of another body.
struct PlacedDiscs {
  Vec3 centre;
  Vec3 axis, x, y;  // orthonormal
  std::array<Real, 2> height, radius;
  Real side_out, side_up;  // the unit normal of the side, across the axis and along it

  // How far the side is from the centre.
  [[nodiscard]] inline Real side() const { return height[0] * side_up + radius[0] * side_out; }
  // A bound of all coordinates.
  [[nodiscard]] inline Real size() const {
    return largest_magnitude(centre) + std::fabs(height[0]) + radius[0] + radius[1];
  }
  // The part of a vector across the axis, in terms of x and y. To subtract the part along the axis would not do:
  // next to the axis the rest is rounding, and may lead along it.
  [[nodiscard]] inline Sideways across(const Vec3& vector) const {
    return sideways_of({dot(x, vector), dot(y, vector), 0});
  }
  // How far they reach along a unit direction.
  [[nodiscard]] inline Real reach(const Vec3& direction) const {
    const Real up = dot(axis, direction), out = across(direction).length;
    return dot(centre, direction) + std::fmax(height[0] * up + radius[0] * out, height[1] * up + radius[1] * out);
  }
  // The point that is furthest along a direction of any length.
  [[nodiscard]] inline Vec3 support(const Vec3& direction) const {
    const Real up = dot(axis, direction);
    const Sideways out = across(direction);
    const std::size_t disc = height[0] * up + radius[0] * out.length > height[1] * up + radius[1] * out.length ? 0 : 1;
    return centre + height[disc] * axis + (radius[disc] * out.x) * x + (radius[disc] * out.y) * y;
  }
};
[[nodiscard]] PlacedDiscs placed(const Discs& discs, const Vec3& centre, const Vec3& axis);
// Mirrored at the origin: the other body and this, added up, are the difference of both.
[[nodiscard]] PlacedDiscs mirrored(const Discs& discs, const Vec3& centre, const Vec3& axis);

// A direction with less than this across the axis counts as one along it: squares of less vanish.
inline constexpr Real least_aside = 1e-140;

// The normal of the side that leads from a point to the axis; of one on the axis any.
[[nodiscard]] Vec3 normal_of_side(const PlacedDiscs& discs, const Vec3& point);

// The discs as features. They are mirrored: the axis leads out of the body where its lower disc is.
inline constexpr std::size_t face_along_axis = 4, face_against_axis = 5, side_of_discs = 2;

// The least depth of all directions offered.
class DiscDepth {
 public:
  // Depths that differ by less than `slack` need not be told apart, those that differ by less than `noise` cannot be.
  DiscDepth(const PlacedDiscs& discs, Real slack, Real noise) : discs_(discs), slack_(slack), noise_(noise) {}

  // Whether no direction has less than the least depth, up to the slack.
  [[nodiscard]] inline bool is_proven() const { return is_proven_; }
  [[nodiscard]] inline const PlacedDiscs& discs() const [[clang::lifetimebound]] { return discs_; }
  [[nodiscard]] inline Real depth() const { return depth_; }
  [[nodiscard]] inline Real slack() const { return slack_; }
  [[nodiscard]] inline Real noise() const { return noise_; }
  // Nothing below it is left out.
  [[nodiscard]] inline Real goal() const { return depth_ - slack_; }
  // Bodies that are apart by less may be taken to overlap.
  [[nodiscard]] inline Real touch() const { return 4 * slack_ + noise_; }
  // Unit, from the other body to the discs.
  [[nodiscard]] inline const Vec3& direction() const [[clang::lifetimebound]] { return direction_; }
  // Of the other body, and of the discs.
  [[nodiscard]] inline const CoreFeatures& features() const [[clang::lifetimebound]] { return features_; }

  [[gnu::always_inline]] inline void offer(Real depth, const Vec3& direction, const CoreFeatures& features = {}) {
    if (depth < depth_ - noise_) {
      depth_ = depth;
      direction_ = direction;
      features_ = features;
    }
  }
  inline void give_up() { is_proven_ = false; }

 private:
  PlacedDiscs discs_;
  Real slack_, noise_;
  Real depth_ = infinity;
  Vec3 direction_{0, 0, 1};
  CoreFeatures features_{};
  bool is_proven_ = true;
};

// An edge of a polytope, with the unit normals of the faces to its left and right, seen from outside along it. A foot
// is the point of the discs that is furthest along a normal.
struct EdgeOfFaces {
  Vec3 from, along, left, right, left_foot, right_foot;
  CoreFeature feature;
};
// Offers the directions across an edge between the normals of its faces. Those of the faces were offered before.
void search_edge(const EdgeOfFaces& edge, DiscDepth& least);
// Offers the directions of all discs, sides and rims of the other body, around Z, and of the discs.
void search_discs(const Discs& other, DiscDepth& least);

}  // namespace abut

// How deep the convex hull of two discs across one axis, a cylinder or a cone, overlaps with a polyhedron or another
// one.
//
// The least depth is the least support function h of the difference D of both over all unit directions. Where D is
// smooth or has a face there can be a minimum, which leaves few directions. Of a polyhedron: normals of the faces of
// either, normals of the side of the discs toward a corner, and one family for each edge: the directions across it
// between the normals of its two faces. Within a family only the shadows of both along the edge matter, which are
// plane: a corner, and two ellipses with all between them. No other direction needs to be tried, so that the least one
// found is proven (faces of sums of convex bodies: Schneider, "Convex bodies: the Brunn-Minkowski theory",
// section 1.7). Of two hulls of discs: disc_depth_of_discs.cpp.
export module abut.narrow.fan.disc_depth;
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
};
[[nodiscard]] PlacedDiscs placed(const Discs& discs, const Vec3& centre, const Vec3& axis);
// Mirrored at the origin: the other body and this, added up, are the difference of both.
[[nodiscard]] PlacedDiscs mirrored(const Discs& discs, const Vec3& centre, const Vec3& axis);

// A direction with less than this across the axis counts as one along it: squares of less vanish.
inline constexpr Real least_aside = 1e-140;

// The normal of the side that leads from a point to the axis; of one on the axis any.
[[nodiscard]] Vec3 normal_of_side(const PlacedDiscs& discs, const Vec3& point);

// The directions across an edge from the normal of one of its faces to that of the other, and both shadows along it.
struct EdgeArc {
  Vec3 x, y;                        // orthonormal and across the edge; x is where the arc begins
  Real end_x, end_y;                // where it ends; of a polygon half a turn on up to rounding, else less
  Real corner_x, corner_y;          // the edge, and the centre of the discs
  Real axis_x, axis_y, axis_along;  // the axis of the discs; its part along the edge
  CoreFeature edge;
};

class DiscDepth {
 public:
  // Depths that differ by less than `slack` need not be told apart, those that differ by less than `noise` cannot be.
  DiscDepth(const PlacedDiscs& discs, Real slack, Real noise) : discs_(discs), slack_(slack), noise_(noise) {}

  // Whether no direction has less than the least depth, up to the slack.
  [[nodiscard]] inline bool is_proven() const { return is_proven_; }
  [[nodiscard]] inline const PlacedDiscs& discs() const [[clang::lifetimebound]] { return discs_; }
  [[nodiscard]] inline Real depth() const { return depth_; }
  [[nodiscard]] inline Real goal() const { return depth_ - slack_; }  // nothing below it is left out
  [[nodiscard]] inline Real noise() const { return noise_; }
  [[nodiscard]] inline Real touch() const {
    return 4 * slack_ + noise_;
  }  // bodies that are apart by less may be taken to overlap
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
  // Whether nothing is less between two directions, at the ends of which feet lie whose line passes the origin at the
  // distance reach / sqrt(square): between the feet it lies in the shadow.
  [[nodiscard]] [[gnu::always_inline]] inline bool is_excluded(Real reach, Real square) const {
    return reach >= 0 && reach * reach >= goal() * goal() * square;
  }

  // The same of four at once: a bit for each that is not excluded.
  [[nodiscard]] [[gnu::always_inline]] inline std::uint64_t lanes_left(Lanes reach, Lanes square) const {
    return ~bits_of((reach >= all_lanes(0)) & (reach * reach >= (goal() * goal()) * square)) & 15u;
  }

  // What is less in the directions of an arc than both ends have.
  void search(const EdgeArc& arc);
  inline void give_up() { is_proven_ = false; }

 private:
  PlacedDiscs discs_;
  Real slack_, noise_;
  Real depth_ = infinity;
  Vec3 direction_{0, 0, 1};
  CoreFeatures features_{};
  bool is_proven_ = true;
};

// The discs as features. They are mirrored: the axis leads out of the body where its lower disc is.
inline constexpr std::size_t face_along_axis = 4, face_against_axis = 5, side_of_discs = 2;

// Offers the directions across an edge between the normals of its faces, seen from outside along it. `number`: of the
// edge.
void search_edge(std::size_t number, const Vec3& from, const Vec3& along, const Vec3& left, const Vec3& right,
                 DiscDepth& least);
// Offers the directions of all faces, corners and edges of a box around the origin.
void search_box(const Vec3& half, DiscDepth& least);
// The same of a triangle with its unit normal.
void search_triangle(const std::array<Vec3, 3>& corners, const Vec3& normal, DiscDepth& least);
// Offers the directions of all discs, sides and rims of the other body, around Z, and of the discs.
void search_discs(const Discs& other, DiscDepth& least);

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// The shortest translation found after which a shape overlaps no obstacle: of a convex shape in a surface a triangle,
// of two surfaces a pair of triangles.
//
// The length of a translation along a direction depends on the surfaces as sets of points only: it ends where nothing
// is overlapped, whether it was at the start or not. So the answer does not depend on how a surface is cut into
// triangles, and is never too short. Starts are normals of what is overlapped; from each the search goes on along the
// shortest translation that leaves all planes touched so far (after Je et al., "PolyDepth: real-time penetration depth
// computation using iterative contact-space projection", 2012).
export module abut.narrow.ways.translation_search;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// Where an obstacle is kept: they are kept four at a time.
struct NearPlace {
  std::size_t four, lane;
};

// What a shape touches after a translation.
struct SurfaceTouch {
  Vec3 normal;  // unit, from the surface
  Real length;  // of the translation
  NearPlace at;
};

struct SeparatingTranslation {
  Real length = infinity;
  Vec3 direction{0, 0, 1};
  bool ends_behind = false;  // a front that stands in all ways
  Real least = 0;            // no translation that ends the overlap is shorter
  SmallVector<SurfaceTouch, 8> touches;
};

[[nodiscard]] inline const SurfaceTouch& last_touch(const SeparatingTranslation& translation [[clang::lifetimebound]]) {
  return *std::ranges::min_element(translation.touches.span(), {},
                                   [](const SurfaceTouch& touch) { return -touch.length; });
}

// The end of the overlap along a direction.
struct SurfaceExit {
  // A front that is left last, and through its back.
  struct Back {
    Vec3 normal;
    Real length;
  };

  Real length = 0;
  bool is_stopped = false;  // then the overlap ends no earlier
  SmallVector<SurfaceTouch, 8> touches;
  SmallVector<Back, 4> backs;

  void stop(const SurfaceTouch& touch);
  // Takes into account what is left at a length. Planes that are left within `tie` of each other are touched together.
  // False where others are left later.
  bool note(const SurfaceTouch& touch, Real tie);
  // To be called at the end. What touches within a tie of the end counts as touched, and what is last comes first. It
  // is left through its back only if it is last, within `last`.
  void settle(Real tie, Real last);
};

// The plane of a triangle that is overlapped.
struct OverlappedPlane {
  Vec3 normal;          // unit, or zero of a triangle without area
  Real behind, before;  // how long it is until it is left along the normal, and against it
  Real area;            // that counts
  bool is_one_sided;
};

// A direction to begin with. Lower estimates come first.
struct TranslationStart {
  Vec3 direction;
  Real estimate;
};

// Planes that are left within it of each other are touched together: else rounding would tell which of them counts.
[[nodiscard]] inline Real tie_of(Real tolerance, Real size) {
  constexpr Real near_share = 1e-7;
  return std::max(4 * tolerance, near_share * size);
}

class Obstacles {
 public:
  using TakePlane = std::function<void(const OverlappedPlane&)>;
  using TakeStart = std::function<void(const Vec3&, Real)>;

  Obstacles() = default;
  Obstacles(const Obstacles&) = delete;
  Obstacles& operator=(const Obstacles&) = delete;
  virtual ~Obstacles() = default;

  // Looks no further than `enough`.
  [[nodiscard]] virtual SurfaceExit exit_along(const Vec3& direction, Real enough) = 0;
  virtual void visit_planes(const TakePlane& take) const = 0;
  // The ways out of single obstacles, with the gap of each.
  virtual void visit_single_ways(const TakeStart& take) const = 0;
  // No translation that ends the overlap is shorter, as one that does so shows. Costs more than what is known without.
  [[nodiscard]] virtual Real least_by(const SeparatingTranslation&) { return 0; }
  // Directions of the shape itself. `are_few`: whether the starts so far are planes, and not means of many.
  virtual void visit_own_directions(bool are_few, std::span<const TranslationStart> starts,
                                    const TakeStart& take) const = 0;
};

struct TranslationSearch {
  Real size;           // of the shape
  Real tolerance;      // lengths below it are rounding
  Real least;          // no translation that ends the overlap is shorter, as is known without a search
  Vec3 deepest_way;    // out of the obstacle that is the deepest by itself
  Real most;           // some translation that ends the overlap is no longer
  Real first;          // how far the first direction is followed
  Real of_start;       // times the best so far that a start is followed
  Real far;            // from this share of the least on, directions all around are tried
  int most_around;     // of these
  bool trusts_ground;  // whether they are left out in many triangles that all look about the same way
  int most_polishes;
};

// To be called where shapes overlap.
[[nodiscard]] SeparatingTranslation find_translation(Obstacles& obstacles, const TranslationSearch& search);

}  // namespace abut

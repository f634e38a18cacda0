// SPDX-License-Identifier: Apache-2.0
// Two surfaces, pair by pair of their triangles: which overlap or are near each other, and how far the second surface
// travels along a direction until it overlaps nothing of the first one.
export module abut.narrow.two_surfaces.crossing_surfaces;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.two_surfaces.leaving_pairs;
export import abut.narrow.two_surfaces.placed_triangles;
export import abut.narrow.ways.translation_search;
import abut.narrow.triangle.triangle_contacts;
import abut.narrow.surface.triangle_source;

export namespace abut {

// Two triangles that overlap, touch, or are within the margin.
struct NearPair {
  PlacedTriangle a, b;
  TriangleSeparation found;
  Real gap;  // negative where they overlap
  bool is_overlapped;
};

// Two triangles that touch after a translation: across a normal, and not before a length of it.
struct TouchedPair {
  PlacedTriangle a, b;
  Vec3 normal;
  Real length;
};

// Whether a search moves the first one of two surfaces. It is the same one in any order of both, so that the order has
// no say.
[[nodiscard]] bool is_moved_first(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab);

class [[gsl::Pointer]] CrossingSurfaces final : private Obstacles {
 public:
  // Looks for all pairs within `margin`.
  CrossingSurfaces(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab, const QuerySettings& settings,
                   Real margin);

  // By the numbers of the triangles of a, then of b.
  [[nodiscard]] std::span<const NearPair> near() const [[clang::lifetimebound]] { return near_.span(); }
  [[nodiscard]] bool is_overlapped() const { return count_ > 0; }
  // Whether triangles overlap, or a piece of one surface is in the other one, which is a solid.
  [[nodiscard]] bool is_met() const { return is_overlapped() || is_inside_; }
  // Whether either is a solid.
  [[nodiscard]] bool has_solid() const;
  // Triangles that overlap by no more only touch.
  [[nodiscard]] Real touching() const { return touching_; }
  // Lengths below it are rounding.
  [[nodiscard]] Real tolerance() const { return tolerance_; }
  // Of the smaller one of both.
  [[nodiscard]] Real size() const { return size_; }

  // To be called where both meet.
  [[nodiscard]] SeparatingTranslation find();
  using TakeTouched = std::function<void(const TouchedPair&)>;
  // Pairs that part within a tie of the end of a translation.
  void visit_touched(const SeparatingTranslation& translation, const TakeTouched& take);
  // The one that parts last.
  [[nodiscard]] std::optional<TouchedPair> last_pair(const SeparatingTranslation& translation);
  // Those that are near the other surface.
  [[nodiscard]] const PlacedTriangles& triangles_of_a() const [[clang::lifetimebound]] { return a_; }
  [[nodiscard]] const PlacedTriangles& triangles_of_b() const [[clang::lifetimebound]] { return b_; }

 private:
  // Four pairs that overlap at the start, and how far each plane is until it is left, along its normal and against it.
  struct CrossingFour {
    PlacedFour a, b;
    Lanes behind_a, before_a, behind_b, before_b;
    Lanes bounds;  // of the length of a translation, while one is looked for
  };
  // Four pairs that lately stood in a way.
  struct BlockingFour {
    PlacedFour a, b;
  };

  // A point of one surface that lies in the other one, which is a solid, or is beside a place in both.
  struct PointInside {
    Vec3 point, place;
    bool is_of_a;
  };
  // By more than a touch, after a move of b.
  [[nodiscard]] bool do_boxes_overlap(const Vec3& move) const;
  // How deep a place in the frame of a is in either solid; zero outside.
  [[nodiscard]] Real depth_in_a(const Vec3& place) const;
  [[nodiscard]] Real depth_in_b(const Vec3& place) const;
  [[nodiscard]] std::optional<PointInside> point_inside(const Vec3& direction, Real length) const;
  // Of pieces, where no triangles cross.
  [[nodiscard]] std::optional<PointInside> piece_inside(const Vec3& move) const;
  // Of triangles that touch. The reaches are those along the direction.
  [[nodiscard]] std::optional<PointInside> flush_inside(const Vec3& direction, Real length) const;
  [[nodiscard]] std::optional<PointInside> flush_inside(const PlacedTriangle& triangle, bool is_of_a,
                                                        const Vec3& move) const;
  void look_inside();
  // Around a place in both solids there is a ball of each: they are parted after both radii. Goes away from both
  // surfaces, as long as that makes the sum larger.
  [[nodiscard]] Real climb(Vec3 place, Real most) const;
  // On to the surface of a solid, where nothing overlaps but something is inside. False where all is outside.
  [[nodiscard]] bool leave_inside(const Vec3& direction, Real enough, SurfaceExit& exit);

  // Triangles that b reaches on ways no longer than `reach` along each axis.
  void gather(Real reach);
  // How far triangles reach along a way of b, and against it.
  void set_reaches(const Vec3& direction);
  void look_for_pairs(const QuerySettings& settings, Real margin);
  void look_at(const PlacedTriangle& of_a, const PlacedTriangle& of_b, const QuerySettings& settings, Real margin);
  void pack_crossing();
  [[nodiscard]] Real tie() const;
  // Along the best of the axes, either way.
  [[nodiscard]] Real length_until_boxes_part() const;

  [[nodiscard]] SurfaceExit exit_along(const Vec3& direction, Real enough) override;
  // What stood in a way lately mostly does again. False where the end is no nearer than `enough`; so below.
  [[nodiscard]] bool leave_blocking(const Vec3& direction, Real enough, SurfaceExit& exit) const;
  void set_bounds(const Vec3& direction);
  [[nodiscard]] bool leave_crossing(const Vec3& direction, Real enough, SurfaceExit& exit);
  [[nodiscard]] bool leave_those_ahead(const Vec3& direction, Real enough, SurfaceExit& exit);
  void note(const PlacedFour& a, const PlacedFour& b, std::size_t lane, const PairStretches& found, Real most,
            const Vec3& direction, SurfaceExit& exit) const;
  void keep_blocking(const PlacedFour& a, const PlacedFour& b, std::size_t lane);
  // For pairs on a way that is gone up to a length, which may grow: those that overlap before it, and are left no
  // earlier than a tie before it. Calls take(four of a, four of b, stretches, a bit for each pair), which returns
  // whether to go on.
  template <class Take>
  void visit_ahead(const Vec3& direction, const Real& length, const Take& take);

  void visit_faces_met(const SeparatingTranslation& translation, const TakeTouched& take) const;

  void visit_planes(const TakePlane& take) const override;
  void visit_single_ways(const TakeStart& take) const override;
  [[nodiscard]] Real least_by(const SeparatingTranslation& translation) override;
  void visit_own_directions(bool are_few, std::span<const TranslationStart> starts,
                            const TakeStart& take) const override;

  const SurfaceSource& source_a_;
  const SurfaceSource& source_b_;
  const Pose& ab_;
  Aabb box_a_, box_b_;
  PlacedTriangles a_, b_;
  Real reach_ = 0, size_ = 0, touching_ = 0, tolerance_ = 0;
  SmallVector<NearPair, 64> near_;
  SmallVector<CrossingFour, 16> crossing_;
  std::array<BlockingFour, 2> blocking_{};
  std::size_t blocking_count_ = 0;  // so far, also of those that have given way
  std::size_t count_ = 0;           // of pairs that overlap
  bool is_inside_ = false;
  Real least_ = 0;
  Vec3 deepest_way_{0, 0, 1};  // out of the pair that is the deepest by itself
};

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// A surface that is flat around a convex shape is a half-space there: its depth and its contacts are exact in one step.
//
// All triangles within the box of the shape, grown by its depth, lie in one plane and leave no gap (FlatPatch). A
// shorter move leaves a section of the shape with that plane within the grown box, where the shape still overlaps the
// ground. The move along the normal ends where the shape only touches it. So no move is shorter, however the ground is
// cut into triangles. Ground that is flat but for the rounding of its vertices has a thickness. The depth is then that
// to its far side, and the interval of the depth is as wide as the ground is thick.
export module abut.narrow.surface.flat_ground;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.surface.flat_patch;
import abut.narrow.walls.half_space;
import abut.narrow.surface.triangle_source;

export namespace abut {

// Where a placed core begins and ends along a direction.
struct Extremes {
  Vec3 lowest, highest;
};

// A convex shape behind functions.
class GroundBody {
 public:
  [[nodiscard]] virtual Extremes along(const Vec3& direction) const = 0;

  Vec3 centre;  // of the core
  Aabb box;     // around the shape
  Real size;    // how far the shape reaches from its centre, up to a factor
  Real radius;  // by which the core is rounded

 protected:
  GroundBody(const Vec3& its_centre, const Aabb& its_box, Real its_size, Real its_radius)
      : centre(its_centre), box(its_box), size(its_size), radius(its_radius) {}
  ~GroundBody() = default;
};

// A half-space that stands for flat ground. `triangle`: one that holds a point of the ground beneath the shape.
class FlatGround {
 public:
  FlatGround(const Vec3& normal, Real offset, Real thickness, Real noise, std::uint32_t triangle)
      : normal_(normal), offset_(offset), thickness_(thickness), noise_(noise), triangle_(triangle) {}

  [[nodiscard]] Aabb aabb(const Pose&) const { return Aabb::everything(); }
  [[nodiscard]] Vec3 normal() const { return normal_; }
  [[nodiscard]] Real offset() const { return offset_; }
  // The ground begins at the plane at the latest, and this far behind it at the earliest.
  void widen(Distance& distance) const {
    distance.lower = distance.distance - noise_;
    distance.upper = distance.distance + thickness_ + noise_;
  }
  // All contacts have one triangle, so that they count as one region. Their ids have none, so that they stay the same
  // while the shape slides.
  void name(std::span<ContactPoint> contacts) const;

 private:
  Vec3 normal_;
  Real offset_, thickness_, noise_;
  std::uint32_t triangle_;
};
static_assert(HalfSpace<FlatGround>);

// The flat ground around a shape, if a surface is that. It answers for contacts up to `margin`, which is not negative.
// A shape that is apart by more than `most_gap` is left to others.
[[nodiscard]] std::optional<FlatGround> flat_ground(const TriangleSource& surface, const GroundBody& body, Real margin,
                                                    Real most_gap);

template <Convex B>
class [[gsl::Pointer]] GroundBodyOf final : public GroundBody {
 public:
  GroundBodyOf(const B& b, const Pose& ab)
      : GroundBody(placed_centre(b, ab), b.aabb(ab), b.extent() + b.radius(), b.radius()), b_(b), ab_(ab) {}

  [[nodiscard]] Extremes along(const Vec3& direction) const override {
    const auto placed = place(b_, ab_);
    return {placed_support(b_, placed, -direction).point, placed_support(b_, placed, direction).point};
  }

 private:
  const B& b_;
  const Pose& ab_;
};

template <Convex B>
[[nodiscard]] std::optional<FlatGround> flat_ground(const TriangleSource& surface, const B& b, const Pose& ab,
                                                    const QuerySettings& settings, Real margin, Real most_gap) {
  return settings.algorithm == Algorithm::automatic ? flat_ground(surface, GroundBodyOf<B>(b, ab), margin, most_gap)
                                                    : std::nullopt;
}

// Whether a surface is flat around a shape; then `out` is the distance.
template <Convex B>
[[nodiscard]] bool flat_distance(const TriangleSource& surface, const B& b, const Pose& ab,
                                 const QuerySettings& settings, Distance& out) {
  const std::optional<FlatGround> ground = flat_ground(surface, b, ab, settings, 0, infinity);
  if (!ground || half_space_distance(*ground, b, ab, settings, out) != Outcome::ok) {
    return false;
  }
  ground->widen(out);
  out.algorithm = Algorithm::flat_ground;
  return true;
}

// Whether a surface is flat around a shape; then the contacts have been added.
template <Convex B>
[[nodiscard]] bool flat_contacts(const TriangleSource& surface, const B& b, const Pose& ab,
                                 const QuerySettings& settings, Manifold& out) {
  const std::optional<FlatGround> ground =
      flat_ground(surface, b, ab, settings, std::max(settings.margin, Real{0}), settings.margin);
  const std::size_t first = out.size();
  if (!ground || half_space_contacts(*ground, b, ab, settings, out) != Outcome::ok) {
    return false;
  }
  ground->name(std::span(out).subspan(first));
  return true;
}

}  // namespace abut

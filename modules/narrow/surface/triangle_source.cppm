// SPDX-License-Identifier: Apache-2.0
// A surface as searches see it: a source of triangles, four at a time. Searches are compiled once for each kind of
// body, and not again for each kind of surface.
export module abut.narrow.surface.triangle_source;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
export import abut.narrow.parts.solid_point;
export import abut.narrow.triangle.stopping_sides;
export import abut.trees.volumes.eight_boxes;

export namespace abut {

// Where a way through a solid reaches its surface.
struct WayToSurface {
  Real length;
  Vec3 normal;  // unit, along the way
  std::uint32_t part;
};

class TriangleSource {
 public:
  // Four triangles, with a bit for each that counts. False: no more are wanted.
  using TakeFour = std::function<bool(const FourTriangles&, std::uint64_t)>;

  TriangleSource() = default;
  TriangleSource(const TriangleSource&) = delete;
  TriangleSource& operator=(const TriangleSource&) = delete;
  virtual ~TriangleSource() = default;

  [[nodiscard]] virtual Aabb box() const = 0;
  // Hands over every triangle whose box overlaps another one, once.
  virtual void visit(const Aabb& box, const TakeFour& take) const = 0;
  [[nodiscard]] virtual Triangle part(std::uint32_t number) const = 0;
  // Whether triangles are turned, or moved, into the frame of the source. Then those are handed over that hold a point
  // of a box, and of others only some.
  [[nodiscard]] virtual bool is_placed() const { return false; }
  // The number of a triangle in the shape that it is of, where a source has several.
  [[nodiscard]] virtual std::uint32_t number_in_shape(std::uint32_t number) const { return number; }
  // Some triangle near a point.
  [[nodiscard]] virtual Triangle part_near(const Vec3& point) const = 0;
  // Of four triangles a bit for each that has a front only. Those of a solid have, but where they are wound the wrong
  // way.
  [[nodiscard]] virtual std::uint64_t one_sided(const FourTriangles& four) const = 0;
  // Of four triangles a bit for each that holds what is behind it as well: of a solid all do.
  [[nodiscard]] virtual std::uint64_t holding(const FourTriangles& four) const = 0;
  [[nodiscard]] virtual StoppingSides sides() const = 0;
  // Triangles of a terrain share the corners where they meet; others may have cracks and T-junctions.
  [[nodiscard]] virtual bool is_terrain() const = 0;
  // Of a solid; see Enclosing. Nothing else contains anything.
  [[nodiscard]] virtual bool contains(const Vec3& point) const = 0;
  // From a point on; none where the way ends nowhere.
  [[nodiscard]] virtual std::optional<WayToSurface> way_to_surface(const Vec3& from, const Vec3& direction) const = 0;
  [[nodiscard]] virtual PointOnSurface nearest(const Vec3& point) const = 0;
  // See Surface.
  [[nodiscard]] virtual bool is_crest(std::uint32_t number, unsigned corners, const Vec3& direction,
                                      Real height) const = 0;
};

// One shape, as another surface asks about it.
class SurfaceSource : public TriangleSource {
 public:
  using TakeBoxes = std::function<void(const EightBoxes&)>;

  [[nodiscard]] virtual TriangleCorners corners(std::uint32_t number) const = 0;
  // See Enclosing.
  [[nodiscard]] virtual std::span<const Vec3> pieces() const = 0;
  // See Hierarchy.
  [[nodiscard]] virtual Vec3 middle() const = 0;
  virtual void visit_node(std::uint32_t node, const TakeBoxes& take) const = 0;
};

template <Surface S>
class [[gsl::Pointer]] SourceOf final : public SurfaceSource {
 public:
  explicit SourceOf(const S& surface) : surface_(surface), sides_(stopping_sides(surface)) {}

  Aabb box() const override { return surface_.aabb(Pose::identity()); }
  void visit(const Aabb& box, const TakeFour& take) const override {
    Aabb query = box;
    bool goes_on = true;
    const auto ask = [&](const FourTriangles& four, std::uint64_t present) -> std::uint64_t {
      if (goes_on && !take(four, present)) {
        goes_on = false;
        query = Aabb::empty();
      }
      return 0;
    };
    surface_.visit_parts(query, InFours{ask}, AcceptsAnyPart{});
  }
  Triangle part(std::uint32_t number) const override { return surface_.part(number); }
  Triangle part_near(const Vec3& point) const override { return surface_.part_near(point); }
  std::uint64_t one_sided(const FourTriangles& four) const override {
    if (sides_ == StoppingSides::both) {
      return 0;
    }
    std::uint64_t bits = 0;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      bits |= std::uint64_t{is_one_sided(four.numbers[lane]) ? 1u : 0u} << lane;
    }
    return bits;
  }
  std::uint64_t holding(const FourTriangles&) const override { return sides_ == StoppingSides::solid ? 15 : 0; }
  StoppingSides sides() const override { return sides_; }
  bool is_terrain() const override { return Terrain<S>; }
  bool contains([[maybe_unused]] const Vec3& point) const override {
    if constexpr (Enclosing<S>) {
      return sides_ == StoppingSides::solid && box().overlaps({point, point}) && surface_.contains(point);
    } else {
      return false;
    }
  }
  TriangleCorners corners(std::uint32_t number) const override { return surface_.corners(number); }
  std::span<const Vec3> pieces() const override {
    if constexpr (Enclosing<S>) {
      return surface_.pieces();
    } else {
      return {};
    }
  }
  std::optional<WayToSurface> way_to_surface(const Vec3& from, const Vec3& direction) const override {
    const auto hit = surface_.cast_ray(from, UnitVec3::from_unit_unchecked(direction), infinity);
    if (!hit) {
      return std::nullopt;
    }
    return WayToSurface{hit->distance, dot(hit->normal, direction) < 0 ? -hit->normal : hit->normal,
                        hit->feature.index};
  }
  PointOnSurface nearest(const Vec3& point) const override { return nearest_on_surface(surface_, point); }
  bool is_crest(std::uint32_t number, unsigned corners, const Vec3& direction, Real height) const override {
    return surface_.is_crest(number, corners, direction, height);
  }
  Vec3 middle() const override { return surface_.origin(); }
  void visit_node(std::uint32_t node, const TakeBoxes& take) const override {
    surface_.visit_children(node, [&](const EightBoxes& boxes) { take(boxes); });
  }

 private:
  [[nodiscard]] bool is_one_sided(std::uint32_t number) const {
    if constexpr (Terrain<S>) {
      return true;
    } else {
      return surface_.part(number).is_one_sided();
    }
  }

  const S& surface_;
  StoppingSides sides_;
};

}  // namespace abut

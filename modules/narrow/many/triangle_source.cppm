// SPDX-License-Identifier: Apache-2.0
// A surface as searches see it: a source of triangles, four at a time. Searches are compiled once for each kind of
// body, and not again for each kind of surface.
export module abut.narrow.many.triangle_source;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
export import abut.narrow.many.solid_point;
export import abut.narrow.many.stopping_sides;

export namespace abut {

// Where a way through a solid reaches its surface.
struct WayToSurface {
  Real length;
  Vec3 normal;  // unit, along the way
  std::uint32_t part;
};

class TriangleSource {
 public:
  // Four triangles, with a bit for each that counts.
  using TakeFour = std::function<void(const FourTriangles&, std::uint64_t)>;

  TriangleSource() = default;
  TriangleSource(const TriangleSource&) = delete;
  TriangleSource& operator=(const TriangleSource&) = delete;
  virtual ~TriangleSource() = default;

  [[nodiscard]] virtual Aabb aabb(const Pose& pose) const = 0;
  // Hands over every triangle whose box overlaps another one, once.
  virtual void visit(const Aabb& box, const TakeFour& take) const = 0;
  [[nodiscard]] virtual Triangle part(std::uint32_t number) const = 0;
  // Of four triangles a bit for each that has a front only. Those of a solid have, but where they are wound the wrong
  // way.
  [[nodiscard]] virtual std::uint64_t one_sided(const FourTriangles& four) const = 0;
  [[nodiscard]] virtual StoppingSides sides() const = 0;
  // Of a solid; see Enclosing. Nothing else contains anything.
  [[nodiscard]] virtual bool contains(const Vec3& point) const = 0;
  [[nodiscard]] virtual std::span<const Vec3> pieces() const = 0;
  // From a point on; none where the way ends nowhere.
  [[nodiscard]] virtual std::optional<WayToSurface> way_to_surface(const Vec3& from, const Vec3& direction) const = 0;
  [[nodiscard]] virtual PointOnSurface nearest(const Vec3& point) const = 0;
  // See Surface.
  [[nodiscard]] virtual bool is_crest(std::uint32_t number, unsigned corners, const Vec3& direction,
                                      Real height) const = 0;
  // Whether triangles that meet share their corners. Others may have cracks and T-junctions.
  [[nodiscard]] virtual bool shares_corners() const = 0;
};

template <Surface S>
class SourceOf final : public TriangleSource {
 public:
  explicit SourceOf(const S& surface) : surface_(surface), sides_(stopping_sides(surface)) {}

  [[nodiscard]] Aabb aabb(const Pose& pose) const override { return surface_.aabb(pose); }
  void visit(const Aabb& box, const TakeFour& take) const override {
    Aabb query = box;
    const auto ask = [&](const FourTriangles& four) -> std::uint64_t {
      // One of them stands in for those that lack, and a sample that is missing has no height.
      std::uint64_t present = four.overlapping(box);
      for (std::size_t lane = 1; lane < 4; ++lane) {
        present &= four.numbers[lane] == four.numbers[lane - 1] ? ~(std::uint64_t{1} << lane) : ~std::uint64_t{0};
      }
      const Lanes heights = four.a.z + four.b.z + four.c.z;
      present &= bits_of(heights == heights);
      if (present != 0) {
        take(four, present);
      }
      return 0;
    };
    surface_.visit_parts(query, InFours{ask}, [](const Triangle&, std::uint32_t) {});
  }
  Triangle part(std::uint32_t number) const override { return surface_.part(number); }
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
  StoppingSides sides() const override { return sides_; }
  bool contains([[maybe_unused]] const Vec3& point) const override {
    if constexpr (Enclosing<S>) {
      return sides_ == StoppingSides::solid && surface_.aabb(Pose::identity()).overlaps({point, point}) &&
             surface_.contains(point);
    } else {
      return false;
    }
  }
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
  bool shares_corners() const override { return Terrain<S>; }

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

// SPDX-License-Identifier: Apache-2.0
// A convex shape of any kind: a whole one, or a triangle or a ball of one that is made of many. One search then serves
// all of them. A whole shape has to outlive its part.
export module abut.pairs.taken_apart.convex_part;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.pairs.shape_handle;

export namespace abut {

// By place in the registry: whether a shape of the kind is one part.
[[nodiscard]] bool is_convex_kind(std::size_t kind);

class ConvexPart {
 public:
  // Nothing for shapes that are not convex.
  [[nodiscard]] static std::optional<ConvexPart> of(const AnyShape& shape [[clang::lifetimebound]]);
  [[nodiscard]] static ConvexPart of(const Triangle& triangle) { return {triangle, 0}; }
  [[nodiscard]] static ConvexPart of(const Ball& ball) { return {Cuboid{ball.half()}, ball.radius()}; }

  [[nodiscard]] inline Real radius() const { return radius_; }
  [[nodiscard]] [[gnu::always_inline]] inline SupportPoint support(const Vec3& direction) const {
    if (const Cuboid* cuboid = std::get_if<Cuboid>(&core_)) {
      return cuboid->support(direction);
    }
    const Triangle* triangle = std::get_if<Triangle>(&core_);
    return triangle != nullptr ? triangle->support(direction) : support_of_shape(direction);
  }
  // No more of it than the furthest vertex.
  [[nodiscard]] Face supporting_face(const Vec3& direction) const;
  [[nodiscard]] Vec3 centre() const;
  [[nodiscard]] Real extent() const;
  [[nodiscard]] Aabb aabb(const Pose& pose) const;
  // Whether searches for its nearest points come nearer step by step.
  [[nodiscard]] bool is_curved() const;
  // The side that a triangle lets nothing through; nothing for all that has no such side.
  [[nodiscard]] std::optional<Vec3> only_front() const;

 private:
  // A box around the origin, a segment along Z or a point.
  struct Cuboid {
    Vec3 half;
    [[nodiscard]] inline SupportPoint support(const Vec3& d) const {
      const auto bit = [](Real extent, Real along, std::uint32_t value) {
        return extent > 0 && std::signbit(along) ? value : 0u;
      };
      return {{std::copysign(half.x, d.x), std::copysign(half.y, d.y), std::copysign(half.z, d.z)},
              bit(half.x, d.x, 1) | bit(half.y, d.y, 2) | bit(half.z, d.z, 4)};
    }
  };
  using Core = std::variant<Cuboid, Triangle, const AnyShape*>;

  ConvexPart(Core core, Real radius) : core_(std::move(core)), radius_(radius) {}
  [[nodiscard]] SupportPoint support_of_shape(const Vec3& direction) const;

  Core core_;
  Real radius_;
};

}  // namespace abut

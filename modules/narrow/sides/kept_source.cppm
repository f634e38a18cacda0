// SPDX-License-Identifier: Apache-2.0
// A surface whose triangles look to the side from which a body came. They are fronts that hold the body as well where
// it has passed them.
export module abut.narrow.sides.kept_source;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.surface.triangle_source;
import abut.narrow.warm.side_memory;

export namespace abut {

class [[gsl::Pointer]] KeptSource final : public TriangleSource {
 public:
  // `sides`: in order; both arguments have to live as long. Triangles without a side stop from both, or hold where they
  // had a front already. Such a front lets through what has come from behind, as ever.
  KeptSource(const TriangleSource& surface [[clang::lifetimebound]],
             std::span<const SideOfPart> sides [[clang::lifetimebound]])
      : surface_(surface), sides_(sides) {}

  Aabb box() const override { return surface_.box(); }
  void visit(const Aabb& box, const TakeFour& take) const override {
    surface_.visit(box, [&](const FourTriangles& four, std::uint64_t present) {
      FourTriangles turned = four;
      const std::uint64_t from_back = with_side(four, false) & ~surface_.one_sided(four);
      for (std::uint64_t left = from_back; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        turned.b.put(lane, four.c[lane]);
        turned.c.put(lane, four.b[lane]);
      }
      return take(turned, present);
    });
  }
  bool is_placed() const override { return surface_.is_placed(); }
  std::uint32_t number_in_shape(std::uint32_t number) const override { return surface_.number_in_shape(number); }
  Triangle part(std::uint32_t number) const override { return turned(surface_.part(number)); }
  Triangle part_near(const Vec3& point) const override { return turned(surface_.part_near(point)); }
  std::uint64_t one_sided(const FourTriangles& four) const override {
    return surface_.one_sided(four) | with_side(four, true) | with_side(four, false);
  }
  std::uint64_t holding(const FourTriangles& four) const override {
    const std::uint64_t fronts = surface_.one_sided(four), from_back = with_side(four, false);
    return (fronts & ~from_back) | (~fronts & (from_back | with_side(four, true)));
  }
  StoppingSides sides() const override { return StoppingSides::front; }
  bool is_terrain() const override { return surface_.is_terrain(); }
  bool contains(const Vec3&) const override { return false; }
  std::optional<WayToSurface> way_to_surface(const Vec3& from, const Vec3& direction) const override {
    return surface_.way_to_surface(from, direction);
  }
  PointOnSurface nearest(const Vec3& point) const override { return surface_.nearest(point); }
  bool is_crest(std::uint32_t number, unsigned corners, const Vec3& direction, Real height) const override {
    const unsigned swapped = (corners & 1u) | (corners & 2u) << 1 | (corners & 4u) >> 1;
    return surface_.is_crest(number, is_turned(surface_.part(number)) ? swapped : corners, direction, height);
  }

 private:
  [[nodiscard]] std::optional<bool> side_of(std::uint32_t number) const {
    const auto at = std::lower_bound(sides_.begin(), sides_.end(), number,
                                     [](const SideOfPart& its, std::uint32_t part) { return its.part < part; });
    return at != sides_.end() && at->part == number ? std::optional(at->is_front) : std::nullopt;
  }
  [[nodiscard]] std::uint64_t with_side(const FourTriangles& four, bool is_front) const {
    std::uint64_t bits = 0;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      bits |= std::uint64_t{side_of(four.numbers[lane]) == is_front ? 1u : 0u} << lane;
    }
    return bits;
  }
  [[nodiscard]] bool is_turned(const Triangle& part) const {
    return !part.is_one_sided() && side_of(part.index()) == false;
  }
  [[nodiscard]] Triangle turned(const Triangle& part) const {
    const auto& [a, b, c] = part.corners();
    const bool has_side = side_of(part.index()).has_value();
    return {is_turned(part) ? TriangleCorners{a, c, b} : part.corners(), part.index(), part.is_one_sided() || has_side};
  }

  const TriangleSource& surface_;
  std::span<const SideOfPart> sides_;
};

}  // namespace abut

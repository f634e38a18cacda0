// SPDX-License-Identifier: Apache-2.0
// A point beside a triangle is nearest to one of its edges or corners. Where a neighbour there comes nearer, a contact
// with the triangle would be a ghost. Most triangles that a ball reaches are passed over so, before anything else is
// known of them.
export module abut.narrow.many.point_ghosts;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;
import abut.narrow.many.four_nearest;
import abut.narrow.many.way_out;

export namespace abut {

template <Surface A>
class PointGhosts {
 public:
  PointGhosts(const A& a, const Vec3& point) : a_(a), size_(largest_magnitude(point)) {}

  // Those of some triangles that may have a contact of their own. The others are remembered.
  [[nodiscard]] std::uint64_t without(const FourTriangles& triangles, const FourNearest& nearest, std::uint64_t some) {
    // No less than the size of the cores that a contact asks with: what is a ghost here is one there.
    const Lanes size = 8 * maximum(triangles.size(), all_lanes(size_)), noise = noise_of(size);
    std::uint64_t left = some & beside(triangles, nearest, size);
    if (left == 0) {
      return some;
    }
    const Columns directions = (1 / __builtin_elementwise_sqrt(nearest.square)) * nearest.between;
    const std::array<std::uint64_t, 3> outermost = outermost_corners(triangles, directions, noise);
    for (; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const auto has = [&](std::size_t corner) {
        return static_cast<unsigned>(outermost[corner] >> lane & 1u) << corner;
      };
      const unsigned corners = has(0) | has(1) | has(2);
      if (corners != 7 && !a_.is_crest(triangles.numbers[lane], corners, directions[lane], noise[lane])) {
        passed_over_.push_back(triangles.numbers[lane]);
        some &= ~(std::uint64_t{1} << lane);
      }
    }
    return some;
  }
  // Calls visit(part, number) for those that were passed over.
  template <class Visitor>
  void visit(Visitor&& visit) const {
    for (const std::uint32_t number : passed_over_.span()) {
      visit(a_.part(number), number);
    }
  }

 private:
  // A bit for each triangle that has area and that the point lies beside, by more than rounding.
  [[nodiscard]] static inline std::uint64_t beside(const FourTriangles& triangles, const FourNearest& nearest,
                                                   Lanes size) {
    constexpr Real most_square = 1 - 1e-9;  // of the cosine between the normal and the way to the point
    const Columns normal = cross(triangles.b - triangles.a, triangles.c - triangles.a);
    const Lanes along = dot(normal, nearest.between), least = 1e-8 * size;
    return bits_of(nearest.is_aside & (nearest.square > least * least) &
                   (along * along < most_square * dot(normal, normal) * nearest.square));
  }

  const A& a_;
  Real size_;
  SmallVector<std::uint32_t, 64> passed_over_;
};

}  // namespace abut

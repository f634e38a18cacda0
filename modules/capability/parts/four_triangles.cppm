// SPDX-License-Identifier: Apache-2.0
// Triangles side by side in vector registers, so that a condition is asked about four at once.
//
// A height field reads four cells of a row.
export module abut.capability.parts.four_triangles;
import abut.capability.parts.part_triangle;
import abut.capability.records;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;

export namespace abut {

// The corners of four triangles, one triangle per lane, and their numbers.
struct FourTriangles {
  Columns a, b, c;
  std::array<std::uint32_t, 4> numbers;

  [[nodiscard]] [[gnu::always_inline]] inline TriangleCorners operator[](std::size_t lane) const {
    return {a[lane], b[lane], c[lane]};
  }
  [[nodiscard]] [[gnu::always_inline]] static inline FourTriangles of(const TriangleCorners& first,
                                                                      const TriangleCorners& second,
                                                                      const TriangleCorners& third,
                                                                      const TriangleCorners& fourth,
                                                                      const std::array<std::uint32_t, 4>& numbers) {
    const auto corner = [&](std::size_t i) {
      return Columns::of(lanes_of(first[i]), lanes_of(second[i]), lanes_of(third[i]), lanes_of(fourth[i]));
    };
    return {corner(0), corner(1), corner(2), numbers};
  }
  [[nodiscard]] static inline FourTriangles of(const std::array<TriangleCorners, 4>& t,
                                               const std::array<std::uint32_t, 4>& numbers) {
    return of(t[0], t[1], t[2], t[3], numbers);
  }
  [[nodiscard]] static inline FourTriangles all(const TriangleCorners& corners) {
    return {Columns::all(corners[0]), Columns::all(corners[1]), Columns::all(corners[2]), {}};
  }
  // The first one of others takes the place of one.
  void put(std::size_t lane, const FourTriangles& others) {
    a.put(lane, others.a[0]);
    b.put(lane, others.b[0]);
    c.put(lane, others.c[0]);
    numbers[lane] = others.numbers[0];
  }
  // The largest magnitude of a coordinate.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes size() const {
    return maximum(maximum(largest_magnitude(a), largest_magnitude(b)), largest_magnitude(c));
  }
  // A bit for each triangle whose box overlaps another one.
  [[nodiscard]] [[gnu::always_inline]] inline std::uint64_t overlapping(const Aabb& box) const {
    const auto apart = [](Lanes p, Lanes q, Lanes r, Real low, Real high) {
      return (maximum(maximum(p, q), r) < all_lanes(low)) | (minimum(minimum(p, q), r) > all_lanes(high));
    };
    return ~bits_of(apart(a.x, b.x, c.x, box.low.x, box.high.x) | apart(a.y, b.y, c.y, box.low.y, box.high.y) |
                    apart(a.z, b.z, c.z, box.low.z, box.high.z)) &
           15u;
  }
};

// Four triangles in the frame of a pose.
[[nodiscard]] inline FourTriangles placed(const FourTriangles& four, const Pose& pose) {
  const auto at = [&](const Columns& corner) {
    const auto& [x, y, z] = pose.rotation;
    return Columns::all(pose.position) + corner.x * Columns::all(x) + corner.y * Columns::all(y) +
           corner.z * Columns::all(z);
  };
  return {at(four.a), at(four.b), at(four.c), four.numbers};
}

// A condition on triangles that answers for four at once, with a bit for each that meets it. It may also take a bit for
// each of the four that is asked about; the others are no triangles to visit.
template <class Ask>
struct InFours {
  Ask ask;
};
template <class Ask>
InFours(Ask) -> InFours<Ask>;

// A bit for each of some triangles that meets a condition.
template <class Wanted>
[[nodiscard]] [[gnu::always_inline]] inline std::uint64_t wanted_of(const FourTriangles& triangles, std::uint64_t some,
                                                                    const Wanted& is_wanted) {
  if constexpr (requires { is_wanted.ask(triangles, some); }) {
    return some == 0 ? 0 : some & is_wanted.ask(triangles, some);
  } else if constexpr (requires { is_wanted.ask(triangles); }) {
    return some == 0 ? 0 : some & is_wanted.ask(triangles);
  } else {
    std::uint64_t wanted = 0;
    for (std::uint64_t left = some; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      wanted |= std::uint64_t{is_wanted(triangles[lane]) ? 1u : 0u} << lane;
    }
    return wanted;
  }
}

// Triangles on their way to a visitor. Corners of triangles that are near each other lie far apart in memory: those of
// some triangles are read at once, so that the memory is waited for once. read_corners(number, corners) writes them
// where they stay. visit(corners, number) gets those whose boxes overlap `box`, which it may shrink, and which meet the
// condition.
template <class ReadCorners, class Wanted, class Visitor>
class [[gsl::Pointer]] WaitingTriangles {
 public:
  WaitingTriangles(const Aabb& box, const ReadCorners& read_corners, const Wanted& is_wanted, const Visitor& visit)
      : box_(box), read_corners_(read_corners), is_wanted_(is_wanted), visit_(visit) {}

  inline void add(std::uint32_t number) {
    numbers_.push_back(number);
    if (numbers_.size() == most_at_once) {
      visit_all();
    }
  }
  // To be called after the last one.
  void visit_all() {
    [[clang::uninitialized]] std::array<TriangleCorners, most_at_once> corners;
    const std::span<const std::uint32_t> numbers = numbers_.span();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      read_corners_(numbers[i], corners[i]);
    }
    for (std::size_t first = 0; first < numbers.size(); first += 4) {
      // The last one stands in for those that lack.
      const auto at = [&](std::size_t lane) { return std::min(first + lane, numbers.size() - 1); };
      const FourTriangles four = FourTriangles::of(corners[at(0)], corners[at(1)], corners[at(2)], corners[at(3)],
                                                   {numbers[at(0)], numbers[at(1)], numbers[at(2)], numbers[at(3)]});
      const std::size_t count = std::min<std::size_t>(4, numbers.size() - first);
      const std::uint64_t present = (std::uint64_t{1} << count) - 1;
      std::uint64_t wanted = wanted_of(four, present & four.overlapping(box_), is_wanted_);
      for (; wanted != 0; wanted &= wanted - 1) {
        const std::size_t place = first + static_cast<std::size_t>(std::countr_zero(wanted));
        visit_(corners[place], numbers[place]);
      }
    }
    numbers_.clear();
  }

 private:
  static constexpr std::size_t most_at_once = 32;

  const Aabb& box_;
  const ReadCorners& read_corners_;
  const Wanted& is_wanted_;
  const Visitor& visit_;
  SmallVector<std::uint32_t, most_at_once> numbers_;
};

}  // namespace abut

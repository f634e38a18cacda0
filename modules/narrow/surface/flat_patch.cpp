// SPDX-License-Identifier: Apache-2.0
module abut.narrow.surface.flat_patch;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;

namespace abut {

namespace {

using LaneWords = std::uint64_t __attribute__((ext_vector_type(4)));

[[nodiscard]] [[gnu::always_inline]] inline LaneNumbers lanes_in(std::uint64_t bits) {
  const auto all = static_cast<std::int64_t>(bits);
  return (LaneNumbers{1, 2, 4, 8} & LaneNumbers{all, all, all, all}) != 0;
}
[[nodiscard]] [[gnu::always_inline]] inline LaneWords word_in_all(std::uint64_t word) {
  return {word, word, word, word};
}

// Of the lower halves.
[[nodiscard]] [[gnu::always_inline]] inline LaneWords product(LaneWords a, LaneWords b) {
  const LaneWords half = word_in_all(0xffffffff);
  return (a & half) * (b & half);
}

// A number for each place. A sum that no two places of a grid have in common, scrambled.
[[nodiscard]] [[gnu::always_inline]] inline LaneWords number_of_place(const Columns& p) {
  const auto number = std::bit_cast<LaneWords>(
      dot(p, Columns::all({0.7548776662466927, 0.5698402909980532, 0.4301597090019468})) + all_lanes(0));
  const LaneWords scrambled = (number ^ (number >> 32)) * word_in_all(0x9e3779b97f4a7c15);
  return scrambled ^ (scrambled >> 29);
}
// The same in both directions, and zero where both ends are one place.
[[nodiscard]] [[gnu::always_inline]] inline LaneWords number_of_edge(LaneWords a, LaneWords b) {
  const LaneWords sum = a + b, difference = a ^ b;
  return product(sum, difference >> 32) + product(difference, sum >> 32);
}

// Whether the boxes around edges overlap a box.
[[nodiscard]] [[gnu::always_inline]] inline LaneNumbers overlap(const Columns& a, const Columns& b, const Aabb& box) {
  const auto apart = [](Lanes p, Lanes q, Real low, Real high) {
    return (maximum(p, q) < all_lanes(low)) | (minimum(p, q) > all_lanes(high));
  };
  return ~(apart(a.x, b.x, box.low.x, box.high.x) | apart(a.y, b.y, box.low.y, box.high.y) |
           apart(a.z, b.z, box.low.z, box.high.z));
}
// Whether edges themselves meet a box: their cross products with its axes part them. Both directions of an edge are
// answered alike.
[[nodiscard]] [[gnu::always_inline]] inline LaneNumbers meet(const Columns& a, const Columns& b, const Aabb& box) {
  const Columns middle = a + b - Columns::all(box.low + box.high), d = b - a;  // twice as large as they are
  const Vec3 size = box.high - box.low;
  const auto across = [](Lanes y, Lanes z, Lanes dy, Lanes dz, Real size_y, Real size_z) {
    return absolute(y * dz - z * dy) > size_y * absolute(dz) + size_z * absolute(dy);
  };
  return overlap(a, b, box) &
         ~(across(middle.y, middle.z, d.y, d.z, size.y, size.z) | across(middle.z, middle.x, d.z, d.x, size.z, size.x) |
           across(middle.x, middle.y, d.x, d.y, size.x, size.y));
}

// The exclusive or of the numbers of the edges of each triangle. `counts(from, to)`: which edges count.
template <class Counts>
[[nodiscard]] [[gnu::always_inline]] inline LaneNumbers sum_of_edges(const FourTriangles& triangles,
                                                                     std::uint64_t counting, const Counts& counts) {
  const auto& [a, b, c, numbers] = triangles;
  const LaneWords at_a = number_of_place(a), at_b = number_of_place(b), at_c = number_of_place(c);
  const auto of = [&](const Columns& from, const Columns& to, LaneWords at_from, LaneWords at_to) {
    return std::bit_cast<LaneNumbers>(number_of_edge(at_from, at_to)) & counts(from, to);
  };
  return (of(a, b, at_a, at_b) ^ of(b, c, at_b, at_c) ^ of(c, a, at_c, at_a)) & lanes_in(counting);
}

[[nodiscard]] [[gnu::always_inline]] inline Lanes sum_of_magnitudes(const Columns& a) {
  return absolute(a.x) + absolute(a.y) + absolute(a.z);
}

// The sum of two numbers, and what its rounding loses (Knuth, volume 2, section 4.2.2).
template <class Number>
[[gnu::always_inline]] inline void add_exactly(Number value, Number& sum, Number& rest) {
  const Number total = sum + value, added = total - sum;
  rest = rest + ((sum - (total - added)) + (value - added));
  sum = total;
}

[[nodiscard]] std::uint64_t in_one(LaneNumbers lanes) {
  return static_cast<std::uint64_t>(lanes[0] ^ lanes[1] ^ lanes[2] ^ lanes[3]);
}

}  // namespace

// The triangles without area either fill a joint, or lie on others that leave none.
bool FlatPatch::EdgeSums::is_even() const {
  const std::uint64_t with_narrow = in_one(all), without = with_narrow ^ in_one(narrow);
  return with_narrow == 0 || without == 0;
}

template <class Visitor>
void FlatPatch::visit_all(const Visitor& visit) {
  if (count_ <= most_kept) {
    for (const Four& four : std::span(kept_).first(count_)) {
      visit(four.triangles, four.counting);
    }
    return;
  }
  visit_(demand_.box, [&visit](const FourTriangles& triangles, std::uint64_t counting) {
    visit(triangles, counting);
    return true;
  });
}

// Triangles so narrow that their normals say nothing.
LaneNumbers FlatPatch::are_narrow(const Columns& ab, const Columns& ac, Lanes along) const {
  return absolute(along) <= (demand_.thickness + demand_.noise) * (sum_of_magnitudes(ab) + sum_of_magnitudes(ac));
}

void FlatPatch::add_normals(const Columns& normals) {
  add_exactly(normals.x, sum_.x, rest_.x);
  add_exactly(normals.y, sum_.y, rest_.y);
  add_exactly(normals.z, sum_.z, rest_.z);
}

void FlatPatch::add_edges(const FourTriangles& triangles, std::uint64_t counting, Edges which, EdgeSums& sums) const {
  const bool exactly = which == Edges::exactly;
  const LaneNumbers edges = sum_of_edges(triangles, counting, [&](const Columns& from, const Columns& to) {
    return exactly ? meet(from, to, demand_.box) : overlap(from, to, demand_.box);
  });
  const Columns ab = triangles.b - triangles.a, ac = triangles.c - triangles.a;
  sums.all ^= edges;
  sums.narrow ^= edges & are_narrow(ab, ac, dot(cross(ab, ac), Columns::all(demand_.seed.normal())));
}

bool FlatPatch::take(const FourTriangles& triangles, std::uint64_t counting) {
  const Columns base = Columns::all(demand_.seed.corners()[0]), normal = Columns::all(demand_.seed.normal());
  const Columns a = triangles.a - base, b = triangles.b - base, c = triangles.c - base;
  const auto is_beside = [&](const Columns& corner) {
    return absolute(dot(corner, normal)) >
           all_lanes(demand_.thickness + demand_.noise) + lean * sum_of_magnitudes(corner);
  };
  if ((counting & bits_of(is_beside(a) | is_beside(b) | is_beside(c))) != 0) {
    return false;
  }
  const Columns ab = triangles.b - triangles.a, ac = triangles.c - triangles.a, across = cross(ab, ac);
  const Lanes along = dot(across, normal);
  const LaneNumbers is_narrow = are_narrow(ab, ac, along), is_back = along < all_lanes(0);
  if (demand_.are_oriented && (counting & bits_of(is_back & ~is_narrow)) != 0) {
    return false;
  }
  const LaneNumbers counts = lanes_in(counting) & ~is_narrow;
  const Lanes sign = counts ? (is_back ? all_lanes(-1) : all_lanes(1)) : all_lanes(0);
  add_normals(sign * across);
  const LaneNumbers edges = sum_of_edges(
      triangles, counting, [&](const Columns& from, const Columns& to) { return overlap(from, to, demand_.box); });
  edges_.all ^= edges;
  edges_.narrow ^= edges & is_narrow;
  if (count_ < most_kept) {
    Four& four = std::span(kept_)[count_];
    four = {triangles, counting};
  }
  ++count_;
  return true;
}

// Boxes around edges are asked first, as that is quick. A tree of other volumes leaves out triangles that only have
// such a box in common with the box: then the edges themselves tell.
bool FlatPatch::has_even_edges() {
  if (edges_.is_even()) [[likely]] {
    return true;
  }
  EdgeSums exact{LaneNumbers(0), LaneNumbers(0)};
  visit_all([&](const FourTriangles& triangles, std::uint64_t counting) {
    add_edges(triangles, counting, Edges::exactly, exact);
  });
  return exact.is_even();
}

Vec3 FlatPatch::sum_of_normals() const {
  const auto in_one_lane = [](Lanes sum, Lanes rest) {
    Real total = 0, lost = 0;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      add_exactly(Real{sum[lane]}, total, lost);
    }
    return total + (lost + abut::sum(rest));
  };
  return {in_one_lane(sum_.x, rest_.x), in_one_lane(sum_.y, rest_.y), in_one_lane(sum_.z, rest_.z)};
}

std::optional<GroundSlab> FlatPatch::slab() {
  count_ = 0;
  sum_ = rest_ = Columns::all({0, 0, 0});
  edges_ = {LaneNumbers(0), LaneNumbers(0)};
  bool fits = true;
  const auto take_four = [this, &fits](const FourTriangles& triangles, std::uint64_t counting) {
    fits = take(triangles, counting);
    return fits;
  };
  visit_(demand_.box, [&take_four](const FourTriangles& triangles, std::uint64_t counting) {
    return take_four(triangles, counting);
  });
  const auto normal = fits && count_ > 0 ? UnitVec3::make(sum_of_normals()) : std::nullopt;
  if (!normal || !has_even_edges()) {
    return std::nullopt;
  }
  const Vec3 n = *normal;
  const Columns normals = Columns::all(n);
  Lanes low = all_lanes(infinity), high = all_lanes(-infinity);
  visit_all([&](const FourTriangles& triangles, std::uint64_t counting) {
    const Lanes a = dot(triangles.a, normals), b = dot(triangles.b, normals), c = dot(triangles.c, normals);
    const LaneNumbers counts = lanes_in(counting);
    low = minimum(low, counts ? minimum(minimum(a, b), c) : low);
    high = maximum(high, counts ? maximum(maximum(a, b), c) : high);
  });
  const GroundSlab slab{n, -largest(-low), largest(high)};
  const Real thickness = slab.high - slab.low;
  const bool is_flat = thickness <= demand_.noise || (thickness <= demand_.thickness && has_rounded_heights());
  return is_flat ? std::optional(slab) : std::nullopt;
}

// Whether float holds the coordinates along the axis that the normal is nearest to. Ground that has bumps in numbers of
// more digits was not rounded, so it means them.
bool FlatPatch::has_rounded_heights() {
  using Singles = float __attribute__((ext_vector_type(4)));
  const int axis = dropped_axis();
  bool are_rounded = true;
  visit_all([&](const FourTriangles& triangles, std::uint64_t counting) {
    const auto is_not = [&](const Columns& corner) {
      const Lanes height = axis == 0 ? corner.x : axis == 1 ? corner.y : corner.z;
      return __builtin_convertvector(__builtin_convertvector(height, Singles), Lanes) != height;
    };
    are_rounded =
        are_rounded && (counting & bits_of(is_not(triangles.a) | is_not(triangles.b) | is_not(triangles.c))) == 0;
  });
  return are_rounded;
}

int FlatPatch::dropped_axis() const {
  const Vec3 wide = absolute(demand_.seed.normal());
  return wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2;
}

std::optional<std::uint32_t> FlatPatch::triangle_at(const Vec3& point, Real aside) {
  const int dropped = dropped_axis();
  // Two of the coordinates, around a place.
  const auto seen = [&](const Columns& p, Real first, Real second) {
    return std::pair{(dropped == 0 ? p.y : p.x) - first, (dropped == 2 ? p.y : p.z) - second};
  };
  constexpr std::array<std::array<Real, 2>, 4> places{
      {{0.3819, 0.2764}, {-0.6931, 0.5412}, {0.2357, -0.8617}, {-0.4723, -0.3301}}};
  for (const auto& [first, second] : places) {
    const Real x = (dropped == 0 ? point.y : point.x) + aside * first,
               y = (dropped == 2 ? point.y : point.z) + aside * second;
    std::uint32_t least = no_index;
    bool is_odd = false, is_in_doubt = false;
    visit_all([&](const FourTriangles& triangles, std::uint64_t counting) {
      const auto [ax, ay] = seen(triangles.a, x, y);
      const auto [bx, by] = seen(triangles.b, x, y);
      const auto [cx, cy] = seen(triangles.c, x, y);
      // On which side of an edge the place is, and how much rounding may have to do with that.
      const auto side = [](Lanes px, Lanes py, Lanes qx, Lanes qy) { return px * qy - py * qx; };
      const auto slack = [&](Lanes px, Lanes py, Lanes qx, Lanes qy) {
        return (demand_.noise / 16) * (absolute(px) + absolute(py) + absolute(qx) + absolute(qy));
      };
      const Lanes ab = side(ax, ay, bx, by), bc = side(bx, by, cx, cy), ca = side(cx, cy, ax, ay);
      const Lanes sign = ab + bc + ca < all_lanes(0) ? all_lanes(-1) : all_lanes(1);
      const Lanes of_ab = slack(ax, ay, bx, by), of_bc = slack(bx, by, cx, cy), of_ca = slack(cx, cy, ax, ay);
      const std::uint64_t may_hold =
          counting & bits_of((sign * ab >= -of_ab) & (sign * bc >= -of_bc) & (sign * ca >= -of_ca));
      if (may_hold == 0) [[likely]] {
        return;
      }
      const std::uint64_t holds = may_hold & bits_of((sign * ab > of_ab) & (sign * bc > of_bc) & (sign * ca > of_ca));
      is_in_doubt = is_in_doubt || holds != may_hold;
      is_odd = is_odd != (__builtin_popcountll(holds) % 2 != 0);
      for (std::uint64_t left = holds; left != 0; left &= left - 1) {
        least = std::min(least, std::span(triangles.numbers)[static_cast<std::size_t>(std::countr_zero(left))]);
      }
    });
    if (!is_in_doubt) {
      return is_odd ? std::optional(least) : std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace abut

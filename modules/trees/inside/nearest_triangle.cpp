// SPDX-License-Identifier: Apache-2.0
module abut.trees.inside.nearest_triangle;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;

namespace abut {
namespace {

Real squared_to_segment(const Vec3& p, const Vec3& from, const Vec3& edge) {
  const Vec3 at = p - from;
  const Real square = squared_norm(edge), share = square > 0 ? dot(at, edge) / square : 0;
  return squared_norm(at - (share > 0 ? (share < 1 ? share : 1) : 0) * edge);
}

Aabb box_of(const TriangleAt& t) { return {minimum(minimum(t.a, t.b), t.c), maximum(maximum(t.a, t.b), t.c)}; }

}  // namespace

Real squared_distance(const Vec3& p, const TriangleAt& t) {
  const Vec3 ab = t.b - t.a, bc = t.c - t.b, ca = t.a - t.c, normal = cross(ab, -ca);
  const Real over_ab = dot(cross(ab, p - t.a), normal), over_bc = dot(cross(bc, p - t.b), normal),
             over_ca = dot(cross(ca, p - t.c), normal), square = squared_norm(normal);
  if (over_ab >= 0 && over_bc >= 0 && over_ca >= 0 && square > 0) {
    const Real height = dot(normal, p - t.a);
    return height * height / square;
  }
  return std::min({squared_to_segment(p, t.a, ab), squared_to_segment(p, t.b, bc), squared_to_segment(p, t.c, ca)});
}

NearestTriangle::NearestTriangle(std::vector<TriangleAt> triangles) : triangles_(std::move(triangles)) {
  nodes_.reserve(triangles_.size());
  build(0, static_cast<std::uint32_t>(triangles_.size()));
  discs_.resize(triangles_.size());
  std::transform(triangles_.begin(), triangles_.end(), discs_.begin(), disc_of);
}

NearestTriangle::Disc NearestTriangle::disc_of(const TriangleAt& t) {
  const Vec3 centre = (1.0 / 3) * (t.a + t.b + t.c), normal = cross(t.b - t.a, t.c - t.a);
  const Real squared = std::max({squared_norm(t.a - centre), squared_norm(t.b - centre), squared_norm(t.c - centre)});
  constexpr Real narrowest = 1e-6;
  const Real size = norm(normal);
  return {centre, size > narrowest * squared ? (1 / size) * normal : Vec3{0, 0, 0}, std::sqrt(squared)};
}

// Halves by the middles of the boxes along the longest side of the box of all.
void NearestTriangle::build(std::uint32_t begin, std::uint32_t end) {
  const std::size_t here = nodes_.size();
  Aabb box = Aabb::empty();
  for (std::uint32_t i = begin; i < end; ++i) {
    box.include(box_of(triangles_[i]));
  }
  nodes_.push_back({box, begin, end - begin});
  if (end - begin <= most_in_leaf) {
    return;
  }
  const Vec3 size = box.high - box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::uint32_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [axis](const TriangleAt& a, const TriangleAt& b) {
    return a.a[axis] + a.b[axis] + a.c[axis] < b.a[axis] + b.b[axis] + b.c[axis];
  });
  build(begin, middle);
  nodes_[here].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[here].count = 0;
  build(middle, end);
}

// The points as vectors of four. The last one stands in for those that are missing.
class NearestTriangle::Search {
 public:
  explicit Search(std::span<const Vec3> points) : count_((points.size() + 3) / 4) {
    for (std::size_t i = 0; i < count_; ++i) {
      const auto lanes = [&](std::size_t lane) { return lanes_of(points[std::min(4 * i + lane, points.size() - 1)]); };
      points_[i] = Columns::of(lanes(0), lanes(1), lanes(2), lanes(3));
      squared_[i] = all_lanes(infinity);
      nearest_[i] = LaneNumbers{0, 0, 0, 0};
    }
    for (const Vec3& point : points) {
      box_.include(point);
    }
  }

  // No point of a box is nearer to any of the points.
  [[nodiscard]] Real squared_distance_to(const Aabb& box) const {
    return squared_norm(maximum(maximum(box.low - box_.high, box_.low - box.high), Vec3{0, 0, 0}));
  }
  // Which of these vectors, a bit each, hold a point that is nearer to the box than to its triangle so far.
  [[nodiscard]] std::uint32_t gaining(std::uint32_t vectors, const Aabb& box) const {
    const Columns low = Columns::all(box.low), high = Columns::all(box.high);
    std::uint32_t out = 0;
    for (std::uint32_t left = vectors; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const Columns& p = points_[i];
      const auto away = [](Lanes at, Lanes from, Lanes to) {
        return maximum(maximum(from - at, at - to), all_lanes(0));
      };
      const Columns outside{away(p.x, low.x, high.x), away(p.y, low.y, high.y), away(p.z, low.z, high.z)};
      out |= bits_of(dot(outside, outside) < squared_[i]) != 0 ? left & -left : 0;
    }
    return out;
  }
  // The same for a triangle. A point over a disc is as far from it as from its plane.
  [[nodiscard]] std::uint32_t gaining(std::uint32_t vectors, const Disc& disc) const {
    const Columns centre = Columns::all(disc.centre), up = Columns::all(disc.up);
    const Lanes radius = all_lanes(disc.radius);
    std::uint32_t out = 0;
    for (std::uint32_t left = vectors; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const Columns away = points_[i] - centre;
      const Lanes height = dot(away, up), over = height * height;
      const Lanes aside = __builtin_elementwise_sqrt(maximum(dot(away, away) - over, all_lanes(0)));
      const Lanes beyond = maximum(aside - radius, all_lanes(0));
      out |= bits_of(over + beyond * beyond < squared_[i]) != 0 ? left & -left : 0;
    }
    return out;
  }
  [[nodiscard]] std::uint32_t all_vectors() const { return (1u << count_) - 1; }

  // As squared_distance, for these vectors.
  void look_at(std::uint32_t vectors, const TriangleAt& t, std::uint32_t number) {
    const Vec3 ab = t.b - t.a, bc = t.c - t.b, ca = t.a - t.c, normal = cross(ab, -ca);
    const Real square = squared_norm(normal);
    const Edge edges[3] = {Edge(t.a, ab, normal), Edge(t.b, bc, normal), Edge(t.c, ca, normal)};
    const Columns up = Columns::all(normal), from = Columns::all(t.a);
    const Lanes inverse = all_lanes(square > 0 ? 1 / square : 0);
    for (; vectors != 0; vectors &= vectors - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(vectors));
      const Columns& p = points_[i];
      const auto [over_ab, to_ab] = edges[0].seen_from(p);
      const auto [over_bc, to_bc] = edges[1].seen_from(p);
      const auto [over_ca, to_ca] = edges[2].seen_from(p);
      const Lanes height = dot(up, p - from), inside = minimum(minimum(over_ab, over_bc), over_ca);
      const Lanes to_edges = minimum(minimum(to_ab, to_bc), to_ca);
      const Lanes squared = square > 0 ? (inside >= 0 ? height * height * inverse : to_edges) : to_edges;
      nearest_[i] = squared < squared_[i] ? LaneNumbers{number, number, number, number} : nearest_[i];
      squared_[i] = minimum(squared, squared_[i]);
    }
  }

  [[nodiscard]] Found found(std::size_t point) const {
    return {static_cast<std::uint32_t>(nearest_[point / 4][point % 4]), squared_[point / 4][point % 4]};
  }

 private:
  static constexpr std::size_t most_vectors = most_points / 4;
  // `inward` lies in the plane of the triangle, across the edge.
  struct Edge {
    Edge(const Vec3& start, const Vec3& way, const Vec3& normal)
        : from(Columns::all(start)), along(Columns::all(way)), inward(Columns::all(cross(normal, way))) {
      const Real square = squared_norm(way);
      inverse = all_lanes(square > 0 ? 1 / square : 0);
    }
    // On which side a point is, and how far away squared.
    [[nodiscard]] [[gnu::always_inline]] inline std::pair<Lanes, Lanes> seen_from(const Columns& point) const {
      const Columns at = point - from;
      const Lanes share = minimum(maximum(dot(at, along) * inverse, all_lanes(0)), all_lanes(1));
      const Columns away = at - share * along;
      return {dot(at, inward), dot(away, away)};
    }
    Columns from, along, inward;
    Lanes inverse;
  };

  std::size_t count_;
  std::array<Columns, most_vectors> points_;
  std::array<Lanes, most_vectors> squared_;
  std::array<LaneNumbers, most_vectors> nearest_;
  Aabb box_ = Aabb::empty();
};

void NearestTriangle::find(std::span<const Vec3> points, std::span<const std::uint32_t> close,
                           std::span<Found> found) const {
  Search search(points);
  for (const std::uint32_t triangle : close) {
    search.look_at(search.all_vectors(), triangles_[triangle], triangle);
  }
  struct Waiting {
    std::uint32_t node, vectors;
  };
  std::array<Waiting, 64> waiting;  // one for each level at most
  waiting[0] = {0, search.all_vectors()};
  for (std::size_t count = 1; count > 0;) {
    const Waiting next = waiting[--count];
    const Node& node = nodes_[next.node];
    const std::uint32_t vectors = search.gaining(next.vectors, node.box);
    if (vectors == 0) {
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (const std::uint32_t some = search.gaining(vectors, discs_[i]); some != 0) {
        search.look_at(some, triangles_[i], i);
      }
    }
    if (node.count == 0) {
      std::uint32_t near = next.node + 1, far = node.first;
      if (search.squared_distance_to(nodes_[far].box) < search.squared_distance_to(nodes_[near].box)) {
        std::swap(near, far);
      }
      waiting[count++] = {far, vectors};
      waiting[count++] = {near, vectors};
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    found[i] = search.found(i);
  }
}

}  // namespace abut

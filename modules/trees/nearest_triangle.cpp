// SPDX-License-Identifier: Apache-2.0
module abut.trees.nearest_triangle;
import abut.core.standard;
import abut.math;

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

NearestTriangle::Found NearestTriangle::nearest(const Vec3& point, std::uint32_t close) const {
  Found best{close, squared_distance(point, triangles_[close])};
  struct Waiting {
    std::uint32_t node;
    Real squared;
  };
  std::array<Waiting, 64> waiting;  // one for each level at most
  waiting[0] = {0, nodes_[0].box.squared_distance(point)};
  for (std::size_t count = 1; count > 0;) {
    const Waiting next = waiting[--count];
    if (!(next.squared < best.squared)) {
      continue;
    }
    const Node& node = nodes_[next.node];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (const Real squared = squared_distance(point, triangles_[i]); squared < best.squared) {
        best = {i, squared};
      }
    }
    if (node.count == 0) {
      Waiting near{next.node + 1, nodes_[next.node + 1].box.squared_distance(point)},
          far{node.first, nodes_[node.first].box.squared_distance(point)};
      if (far.squared < near.squared) {
        std::swap(near, far);
      }
      waiting[count++] = far;
      waiting[count++] = near;
    }
  }
  return best;
}

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
module abut.elements.nearest;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

constexpr Real parallel_squared_sine = 1e-12;

// On a corner or on the edge between two.
struct OnBorder {
  std::uint32_t start, end;  // the same for a corner
  Real share;
  Vec3 point;
  Real square;
};

}  // namespace

NearestOnFace nearest_on_face(const Vec3& vertex, const std::array<Vec3, 3>& face) {
  std::array<std::uint32_t, 3> order{0, 1, 2};
  const auto put_in_order = [&](std::size_t i, std::size_t j) {
    if (is_placed_before(face[order[j]], face[order[i]])) {
      std::swap(order[i], order[j]);
    }
  };
  put_in_order(0, 1);
  put_in_order(1, 2);
  put_in_order(0, 1);
  const std::array<Vec3, 3> corners{face[order[0]], face[order[1]], face[order[2]]};

  // All corners are compared, also where an edge has a nearer point but for rounding. So no face around a feature names
  // one that is further away.
  std::array<Real, 3> squares{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    squares[i] = squared_norm(vertex - corners[i]);
  }
  const std::uint32_t first = squares[1] < squares[0] ? 1 : 0, closest = squares[2] < squares[first] ? 2 : first;
  OnBorder best{closest, closest, 0, corners[closest], squares[closest]};
  for (const auto& [start, end] : {std::pair(0u, 1u), std::pair(0u, 2u), std::pair(1u, 2u)}) {
    const Vec3 way = corners[end] - corners[start];
    const Real along = dot(way, vertex - corners[start]), length = squared_norm(way);
    if (along > 0 && along < length) {
      const Real share = along / length;
      const Vec3 point = corners[start] + share * way;
      if (const Real square = squared_norm(vertex - point); square < best.square) {
        best = {start, end, share, point, square};
      }
    }
  }

  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const Real square = squared_norm(normal);
  // How far the vertex lies on the inner side of the edge across from each corner.
  const std::array<Real, 3> inside{dot(cross(normal, corners[2] - corners[1]), vertex - corners[1]),
                                   dot(cross(normal, corners[0] - corners[2]), vertex - corners[2]),
                                   dot(cross(normal, corners[1] - corners[0]), vertex - corners[0])};
  if (inside[0] > 0 && inside[1] > 0 && inside[2] > 0) {
    const Real height = dot(vertex - corners[0], normal);
    if (const Real squared_height = height * height / square; squared_height < best.square) {
      const Real sum = inside[0] + inside[1] + inside[2];
      return {3,
              order,
              {inside[0] / sum, inside[1] / sum, inside[2] / sum},
              vertex - (height / square) * normal,
              squared_height};
    }
  }
  if (best.start == best.end) {
    return {1, {order[best.start], 0, 0}, {1, 0, 0}, best.point, best.square};
  }
  return {2, {order[best.start], order[best.end], 0}, {1 - best.share, best.share, 0}, best.point, best.square};
}

std::optional<NearestOfEdges> nearest_of_edges(const std::array<Vec3, 2>& a, const std::array<Vec3, 2>& b) {
  const bool is_a_turned = is_placed_before(a[1], a[0]), is_b_turned = is_placed_before(b[1], b[0]);
  std::array<std::array<Vec3, 2>, 2> edges{is_a_turned ? std::array{a[1], a[0]} : a,
                                           is_b_turned ? std::array{b[1], b[0]} : b};
  const bool are_swapped = is_placed_before(edges[1][0], edges[0][0]) ||
                           (edges[1][0] == edges[0][0] && is_placed_before(edges[1][1], edges[0][1]));
  if (are_swapped) {
    std::swap(edges[0], edges[1]);
  }
  const auto& [first, second] = edges;
  const Vec3 along = first[1] - first[0], across = second[1] - second[0], normal = cross(along, across);
  const Real square = squared_norm(normal);
  if (!(square > parallel_squared_sine * squared_norm(along) * squared_norm(across))) {
    return std::nullopt;
  }
  const Real share = dot(cross(second[0] - first[0], across), normal) / square;
  const Vec3 point = first[0] + share * along;
  // A projection: then an error of the share hardly matters where the edges are nearly parallel.
  const Real other_share = dot(across, point - second[0]) / squared_norm(across);
  if (!(share > 0 && share < 1 && other_share > 0 && other_share < 1)) {
    return std::nullopt;
  }
  const Vec3 other_point = second[0] + other_share * across;
  NearestOfEdges out{{share, other_share}, {point, other_point}, squared_norm(point - other_point)};
  if (are_swapped) {
    std::swap(out.shares[0], out.shares[1]);
    std::swap(out.points[0], out.points[1]);
  }
  out.shares[0] = is_a_turned ? 1 - out.shares[0] : out.shares[0];
  out.shares[1] = is_b_turned ? 1 - out.shares[1] : out.shares[1];
  return out;
}

}  // namespace abut

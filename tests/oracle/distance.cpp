// SPDX-License-Identifier: Apache-2.0
#include "distance.hpp"

#include <algorithm>
#include <limits>

#include "separation.hpp"

namespace oracle {

Measured measured(const Body& body) { return {{features_of(body.core)}, body.radius, std::nullopt, size_of(body)}; }

Measured measured(const HalfSpace& half_space) { return {{}, 0, half_space, 0}; }

Measured measured(const Soup& soup) {
  Measured result;
  result.size = size_of(soup);
  for (const auto& triangle : soup.triangles) {
    result.pieces.push_back(
        features_of({soup.points[triangle[0]], soup.points[triangle[1]], soup.points[triangle[2]]}));
  }
  return result;
}

namespace {

struct Plane {
  Vec normal;
  Quad offset;
};

// The plane in the world, relative to `origin`.
Plane placed_plane(const HalfSpace& half_space, const Pose& pose, const Vec& origin) {
  const Vec local{quad(half_space.normal[0]), quad(half_space.normal[1]), quad(half_space.normal[2])};
  const Vec normal = pose.rotate(unit(local));
  return {normal, quad(half_space.offset) + dot(normal, pose.position - origin)};
}

Answer from_half_space(const Measured& a, const Pose& pose_a, const Measured& b, const Pose& pose_b) {
  const Plane plane = placed_plane(*a.half_space, pose_a, pose_b.position);
  std::optional<Vec> lowest;
  for (const Features& piece : b.pieces) {
    for (const Vec& local : piece.points) {
      const Vec p = pose_b.rotate(local);
      if (!lowest || dot(plane.normal, p) < dot(plane.normal, *lowest)) lowest = p;
    }
  }
  const Vec low = lowest.value_or(Vec{}) - plane.normal * quad(b.radius);
  Answer answer;
  answer.distance = dot(plane.normal, low) - plane.offset;
  answer.core_distance = answer.distance + quad(b.radius);
  answer.normal = plane.normal;
  answer.witness = Witness{low - plane.normal * answer.distance + pose_b.position, low + pose_b.position};
  return answer;
}

Answer flipped(Answer answer) {
  answer.normal = -answer.normal;
  if (answer.witness) std::swap(answer.witness->a, answer.witness->b);
  return answer;
}

Answer with_radii(const CoreAnswer& core, Quad radius_a, Quad radius_b, const Vec& origin) {
  Answer answer;
  answer.core_distance = core.distance;
  answer.distance = core.distance - radius_a - radius_b;
  answer.normal = core.normal;
  if (core.witness) {
    answer.witness =
        Witness{core.witness->a + core.normal * radius_a + origin, core.witness->b - core.normal * radius_b + origin};
  }
  return answer;
}

std::vector<Features> placed_pieces(const Measured& shape, const Pose& pose, const Vec& origin) {
  std::vector<Features> result;
  for (const Features& piece : shape.pieces) result.push_back(placed(piece, pose, origin));
  return result;
}

}  // namespace

Answer signed_distance(const Measured& a, const Pose& pose_a, const Measured& b, const Pose& pose_b) {
  if (a.half_space) return from_half_space(a, pose_a, b, pose_b);
  if (b.half_space) return flipped(from_half_space(b, pose_b, a, pose_a));
  const Vec origin = pose_a.position;
  const std::vector<Features> pieces_a = placed_pieces(a, pose_a, origin);
  const std::vector<Features> pieces_b = placed_pieces(b, pose_b, origin);
  std::optional<CoreAnswer> best;
  for (const Features& piece_a : pieces_a) {
    for (const Features& piece_b : pieces_b) {
      const Quad apart = length(piece_a.centre - piece_b.centre) - piece_a.size - piece_b.size;
      if (best && apart > best->distance) continue;
      const CoreAnswer answer = core_distance(piece_a, piece_b);
      if (!best || answer.distance < best->distance) best = answer;
    }
  }
  return with_radii(best.value_or(CoreAnswer{}), quad(a.radius), quad(b.radius), origin);
}

namespace {

// Largest n.p over a shape, relative to `origin`; half-spaces answer only their own normal.
Quad highest_along(const Measured& shape, const Pose& pose, const Vec& origin, const Vec& n) {
  if (shape.half_space) return placed_plane(*shape.half_space, pose, origin).offset;
  std::optional<Quad> best;
  for (const Features& piece : shape.pieces) {
    for (const Vec& local : piece.points) {
      const Quad height = dot(n, pose.rotate(local) + (pose.position - origin));
      if (!best || height > *best) best = height;
    }
  }
  return best.value_or(0) + quad(shape.radius) * length(n);
}

}  // namespace

Quad separation_along(const Measured& a, const Pose& pose_a, const Measured& b, const Pose& pose_b,
                      const Vec& direction) {
  const Vec origin = pose_a.position;
  return -highest_along(b, pose_b, origin, -direction) - highest_along(a, pose_a, origin, direction);
}

Quad distance_to_point(const Measured& shape, const Pose& pose, const Vec& point) {
  Pose there;
  there.position = point;
  return signed_distance(shape, pose, measured(make_sphere(0)), there).distance;
}

}  // namespace oracle

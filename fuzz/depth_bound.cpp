// SPDX-License-Identifier: Apache-2.0
// How far a convex shape has to move to be parted from a surface: an upper bound of the depth of every contact of both.
module;
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>
#include <vector>
module abut.fuzz;

namespace abut::fuzz {
namespace {

struct Piece {
  std::array<Vec3, 3> corners;
  Vec3 normal;    // unit, or zero for no area
  bool has_back;  // whether it stops what comes from behind
  Distance near;  // to the convex shape
};

// The triangles of a surface, and how far each is from the convex shape. Nothing in a build without triangles.
std::optional<std::vector<Piece>> pieces_of(const Scene& scene) {
  const std::optional<std::size_t> triangle = find_kind("triangle");
  if (!triangle) {
    return std::nullopt;
  }
  return std::visit(
      [&]<class S>(const S& surface) -> std::optional<std::vector<Piece>> {
        if constexpr (Surface<S>) {
          std::vector<Piece> pieces;
          const std::vector<std::uint32_t> indices = surface.triangles().indices;
          for (std::uint32_t i = 0; i < indices.size() / 3; ++i) {
            // A missing triangle has three equal corners.
            if (indices[3 * i] == indices[3 * i + 1] && indices[3 * i] == indices[3 * i + 2]) {
              continue;
            }
            const auto part = surface.part(i);
            const auto& [a, b, c] = part.corners();
            const auto made = make_shape(*triangle, std::array{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z}, {}, {});
            Piece piece{part.corners(), part.normal(), !part.is_one_sided(), {}};
            if (!made || pair_distance(made.value(), scene.b, scene.ab, {}, piece.near) != Outcome::ok) {
              return std::nullopt;
            }
            pieces.push_back(piece);
          }
          return pieces;
        } else {
          return std::nullopt;
        }
      },
      *scene.a);
}

// Along a unit direction, from all pieces that are met on the way; infinite where that leads through a front.
Real depth_along(const Scene& scene, const std::vector<Piece>& pieces, const Vec3& direction) {
  const Real lowest =
      dot(direction, scene.ab.position) - reach_along(scene.b, -scene.ab.rotation.undo(direction)).value_or(0);
  // No way leads through a front that is entered by more than rounding, even where that is less than the tolerance.
  const Real noise = tolerance(scene), rounding = 16 * std::numeric_limits<Real>::epsilon() * scene.size;
  Real depth = 0;
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (const Piece& piece : pieces) {
      const auto& [a, b, c] = piece.corners;
      const Real own = std::max({dot(direction, a), dot(direction, b), dot(direction, c)}) - lowest;
      if (piece.near.distance > depth + noise || own <= rounding) {
        continue;
      }
      if (!piece.has_back && dot(direction, piece.normal) < -1e-12) {
        return std::numeric_limits<Real>::infinity();
      }
      if (own <= depth + noise) {
        continue;
      }
      depth = own;
      has_grown = true;
    }
  }
  return depth;
}

// The normals of contacts as the swapped scene has them.
Manifold turned(Manifold contacts, const Pose& ab) {
  for (ContactPoint& contact : contacts) {
    contact.normal = -ab.rotation.undo(contact.normal);
  }
  return contacts;
}

}  // namespace

std::optional<Real> reach_along(const AnyShape& shape, const Vec3& direction) {
  return std::visit(
      [&]<class S>(const S& s) -> std::optional<Real> {
        if constexpr (Convex<S>) {
          return dot(s.support(direction).point, direction) + s.radius();
        } else {
          return std::nullopt;
        }
      },
      shape);
}

std::optional<Real> depth_bound(const Scene& scene, const Manifold& found) {
  if (!reach_along(scene.b, {0, 0, 1})) {
    return reach_along(scene.a, {0, 0, 1}) ? depth_bound(swapped(scene), turned(found, scene.ab)) : std::nullopt;
  }
  const std::optional<std::vector<Piece>> pieces = pieces_of(scene);
  if (!pieces) {
    return std::nullopt;
  }
  Real least = std::numeric_limits<Real>::infinity();
  const auto consider = [&](const Vec3& direction) {
    if (squared_norm(direction) > 0) {
      least = std::min(least, depth_along(scene, *pieces, direction));
    }
  };
  for (const Piece& piece : *pieces) {
    // A triangle with one side that is met from behind holds nothing, and shows no way out.
    if (piece.near.distance <= 0 && (piece.has_back || dot(piece.near.normal, piece.normal) >= 0)) {
      consider(piece.near.normal);
      consider(piece.normal);
      if (piece.has_back) {
        consider(-piece.normal);
      }
    }
  }
  for (const ContactPoint& contact : found) {
    consider(contact.normal);
  }
  return least;
}

}  // namespace abut::fuzz

// SPDX-License-Identifier: Apache-2.0
// How deep a surface and another shape are in each other at least: a lower bound of the depth of the deepest contact.
//
// A move that parts the shapes parts each triangle from the other shape, or from each triangle of that. Two convex
// shapes overlap after the moves that lie in their Minkowski difference. Support points of it are the corners of a
// polytope in it, so no shorter move leaves the difference than one that leaves the polytope. The polytope grows where
// its surface is nearest to no move at all.
module;
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <variant>
#include <vector>
module abut.fuzz;

namespace abut::fuzz {
namespace {

// The point of a convex shape that lies furthest along a unit direction.
using Support = std::function<Vec3(const Vec3&)>;
using Corners = std::array<Vec3, 3>;

struct Face {
  std::array<std::size_t, 3> corners;  // counter-clockwise seen from outside
  Vec3 normal;
  Real height;  // of its plane along the normal
};

// A polytope that grows by points of a convex set.
class Growing {
 public:
  explicit Growing(const Support& support) : support_(support) {}

  // Whether four points span a volume that exceeds rounding.
  [[nodiscard]] bool begin(Real noise) {
    noise_ = noise;
    for (const Vec3& direction : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}}) {
      points_.push_back(support_(direction));
    }
    const Vec3 along = points_[1] - points_[0];
    if (!(norm(along) > noise)) {
      return false;
    }
    const Vec3 aside = unit(cross(along, {0, 0.6, 0.8})), other = unit(cross(along, aside));
    // Whichever lies further from what is known.
    const auto add_furthest = [&](const Vec3& first, const Vec3& second) {
      const std::array all{support_(first), support_(-first), support_(second), support_(-second)};
      const auto distance = [&](const Vec3& point) {
        const Vec3 from = point - points_[0];
        return points_.size() == 2 ? norm(cross(from, along)) : std::fabs(dot(from, first)) * norm(along);
      };
      points_.push_back(*std::ranges::max_element(all, {}, distance));
      return distance(points_.back()) > noise * norm(along);
    };
    if (!add_furthest(aside, other)) {
      return false;
    }
    const Vec3 across = unit(cross(along, points_[2] - points_[0]));
    if (!add_furthest(across, across)) {
      return false;
    }
    const bool is_above = dot(across, points_[3] - points_[0]) > 0;
    const std::size_t one = is_above ? 2 : 1, two = is_above ? 1 : 2;
    return add({0, one, two}) && add({0, two, 3}) && add({two, one, 3}) && add({one, 0, 3});
  }

  [[nodiscard]] const Face& nearest() const { return *std::ranges::min_element(faces_, {}, &Face::height); }

  // Adds a point beyond a face. False where that makes no difference, or a face without area.
  [[nodiscard]] bool grow(const Vec3& point) {
    const auto sees = [&](const Face& face) { return dot(face.normal, point) > face.height + 1e-3 * noise_; };
    std::vector<std::pair<std::size_t, std::size_t>> rim;
    for (const Face& face : faces_) {
      if (!sees(face)) {
        continue;
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const std::pair edge{face.corners[i], face.corners[(i + 1) % 3]};
        const auto opposite = std::ranges::find(rim, std::pair{edge.second, edge.first});
        if (opposite == rim.end()) {
          rim.push_back(edge);
        } else {
          rim.erase(opposite);
        }
      }
    }
    if (rim.size() < 3) {
      return false;
    }
    std::erase_if(faces_, sees);
    points_.push_back(point);
    return std::ranges::all_of(rim,
                               [&](const auto& edge) { return add({edge.first, edge.second, points_.size() - 1}); });
  }

 private:
  [[nodiscard]] static Vec3 unit(const Vec3& v) { return (1 / norm(v)) * v; }

  [[nodiscard]] bool add(const std::array<std::size_t, 3>& corners) {
    const Vec3 &a = points_[corners[0]], &b = points_[corners[1]], &c = points_[corners[2]];
    const Vec3 across = cross(b - a, c - a);
    const Real size = norm(across);
    if (!(size > 0)) {
      return false;
    }
    const Vec3 normal = (1 / size) * across;
    faces_.push_back({corners, normal, dot(normal, a)});
    return true;
  }

  const Support& support_;
  Real noise_ = 0;
  std::vector<Vec3> points_;
  std::vector<Face> faces_;
};

// The depth of two convex shapes that is proven, where it exceeds `known`; else some number that is no larger.
Real depth_of(const Support& difference, Real known, Real noise) {
  constexpr int most_points = 120;
  Growing polytope(difference);
  if (!polytope.begin(noise)) {
    return 0;
  }
  Real proven = 0;
  for (int i = 0; i < most_points; ++i) {
    const Face nearest = polytope.nearest();
    proven = std::max(proven, nearest.height);
    const Vec3 point = difference(nearest.normal);
    const Real most = dot(point, nearest.normal);
    // The depth is no larger than along any direction.
    if (most <= known + noise || most - nearest.height <= noise || !polytope.grow(point)) {
      break;
    }
  }
  return proven;
}

Vec3 furthest(const Corners& corners, const Vec3& direction) {
  return *std::ranges::max_element(corners, {}, [&](const Vec3& corner) { return dot(corner, direction); });
}

// The triangles of a surface that stop from both sides, or nothing.
std::optional<std::vector<Corners>> sheets_of(const AnyShape& shape) {
  return std::visit(
      []<class S>(const S& surface) -> std::optional<std::vector<Corners>> {
        if constexpr (Surface<S>) {
          std::vector<Corners> sheets;
          for (std::uint32_t i = 0; i < surface.triangles().indices.size() / 3; ++i) {
            const auto part = surface.part(i);
            if (!part.is_one_sided()) {
              sheets.push_back(part.corners());
            }
          }
          return sheets;
        } else {
          return std::nullopt;
        }
      },
      shape);
}

// What a side is made of, each with its support point in the frame of a.
std::vector<Support> parts_of(const AnyShape& shape, const Pose& pose) {
  std::vector<Support> parts;
  if (const auto sheets = sheets_of(shape)) {
    for (const Corners& local : *sheets) {
      const Corners corners{pose * local[0], pose * local[1], pose * local[2]};
      parts.emplace_back([corners](const Vec3& direction) { return furthest(corners, direction); });
    }
    return parts;
  }
  std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Convex<S>) {
          parts.emplace_back([&s, pose](const Vec3& direction) {
            return pose * s.support(pose.rotation.undo(direction)).point + s.radius() * direction;
          });
        }
      },
      shape);
  return parts;
}

}  // namespace

std::optional<Real> least_depth(const Scene& scene, const Manifold& found, Real known) {
  if (!sheets_of(scene.a) && !sheets_of(scene.b)) {
    return std::nullopt;
  }
  const Real noise = tolerance(scene);
  Real depth = known;
  const std::vector<Support> of_a = parts_of(scene.a, Pose::identity()), of_b = parts_of(scene.b, scene.ab);
  for (const Support& a : of_a) {
    for (const Support& b : of_b) {
      const Support difference = [&](const Vec3& direction) { return a(direction) - b(-direction); };
      const auto is_shallow = [&](const Vec3& direction) {
        return dot(difference(direction), direction) <= depth + noise;
      };
      const bool are_shallow =
          std::ranges::any_of(
              std::array{Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}},
              is_shallow) ||
          std::ranges::any_of(found, [&](const ContactPoint& contact) { return is_shallow(contact.normal); });
      if (!are_shallow) {
        depth = std::max(depth, depth_of(difference, depth, noise));
      }
    }
  }
  return depth;
}

}  // namespace abut::fuzz

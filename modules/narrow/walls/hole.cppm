// SPDX-License-Identifier: Apache-2.0
// A cavity against what is in it: the cavity stands for the solid that fills all space around it.
export module abut.narrow.walls.hole;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.walls.half_space;

export namespace abut {

// A flat wall as the half-space behind it.
class WallSolid {
 public:
  explicit WallSolid(const FlatWall& wall) : wall_(wall) {}
  [[nodiscard]] Aabb aabb(const Pose&) const { return Aabb::everything(); }
  [[nodiscard]] Vec3 normal() const { return -wall_.normal; }
  [[nodiscard]] Real offset() const { return -wall_.offset; }

 private:
  FlatWall wall_;
};

// Points of a core that may lie furthest from the axis or centre of a round wall, in the frame of the wall.
//  - A core with corners: all of its corners.
//  - A curved core: the ends of climbs that start in directions all around. A climb goes to the support point in the
//    direction of the last point. No step leads nearer to the axis or centre.
template <Convex B, class Visitor>
void visit_outermost(const RoundWall& wall, const B& b, const Pose& ab, Visitor&& visit) {
  if constexpr (!Curved<B>) {
    for (std::uint32_t i = 0; i < b.corner_count(); ++i) {
      visit(ab * b.corner(i), Feature{FeatureKind::vertex, i});
    }
  } else {
    constexpr int steps = 200;
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          Vec3 direction{static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)};
          if (squared_norm(wall.radial(direction)) == 0) {
            continue;
          }
          const auto top_along = [&](const Vec3& toward) { return ab * b.support(ab.rotation.undo(toward)).point; };
          Vec3 point = top_along(direction);
          Real before = 0;
          for (int step = 0; step < steps; ++step) {
            const Vec3 outward = wall.radial(point);
            direction = squared_norm(outward) > 0 ? outward : direction;
            Vec3 next = top_along(direction);
            const Vec3 stride = next - point;
            if (largest_magnitude(stride) <= touching_distance(largest_magnitude(next))) {
              point = next;
              break;
            }
            // Steps shrink by about the same factor, which is close to one where the core is nearly as round as the
            // wall. The sum of all further steps leads to the end (Aitken's extrapolation).
            Real length = norm(stride);
            if (length < before) {
              const Vec3 ahead = top_along(wall.radial(next + (length / (before - length)) * stride));
              if (squared_norm(wall.radial(ahead)) > squared_norm(wall.radial(next))) {
                next = ahead;
                length = 0;
              }
            }
            before = length;
            point = next;
          }
          visit(point, Feature{FeatureKind::whole, 0});
          const Face face = placed_face(b, ab, direction);
          for (const FaceVertex& vertex : face.vertices.span()) {
            visit(vertex.point, Feature{FeatureKind::vertex, vertex.vertex});
          }
        }
      }
    }
  }
}

// No point of a core lies further from the middle of a round wall. Around an axis: lines across directions all around
// it support the core, so it lies within the polygon between them, which is 0.12 % larger than a disc at most.
template <Convex B>
[[nodiscard]] Real most_outward(const RoundWall& wall, const B& b, const Pose& ab) {
  const Aabb box = b.aabb(Pose::identity());
  const Real by_box = norm(wall.radial(ab * box.centre())) + 0.5 * norm(box.high - box.low);
  if (!wall.is_along_z) {
    return by_box;
  }
  constexpr int directions = 64;
  constexpr Real angle = 2 * std::numbers::pi / directions;
  const Real sine = std::sin(angle), cosine = std::cos(angle);
  const auto support_at = [&](int i) {
    const Vec3 along{std::cos(i * angle), std::sin(i * angle), 0};
    return dot(along, ab * b.support(ab.rotation.undo(along)).point) + b.radius();
  };
  const Real first = support_at(0);
  Real before = first, square = 0;
  for (int i = 1; i <= directions; ++i) {
    const Real next = i < directions ? support_at(i) : first;
    const Real across = (next - cosine * before) / sine;
    square = std::max(square, before * before + across * across);
    before = next;
  }
  return std::min(by_box, std::sqrt(square));
}

// One point of a core against a round wall, as a contact from the wall to the rounded core.
[[nodiscard]] inline ContactPoint contact_at(const RoundWall& wall, const Vec3& core_point, Real radius,
                                             const Feature& feature) {
  const Vec3 radial = wall.radial(core_point);
  const Real far = norm(radial);
  const Vec3 outward = UnitVec3::make(radial).value_or(UnitVec3::from_unit_unchecked({1, 0, 0}));
  const Feature of_wall{FeatureKind::face, wall.face};
  return {core_point + (wall.radius - far) * outward,
          core_point + radius * outward,
          -outward,
          wall.radius - far - radius,
          of_wall,
          feature,
          contact_id(of_wall, feature)};
}

// The walls of a hole, whatever it is.
struct Walls {
  FlatWalls flat;
  std::optional<RoundWall> round;
};

template <Convex B>
[[nodiscard]] Outcome distance_in_walls(const Walls& walls, const B& b, const Pose& ab, const QuerySettings& settings,
                                        Distance& out) {
  if (!takes_closed_forms(settings.algorithm)) {
    return Outcome::unsupported;
  }
  out = {};
  out.distance = out.lower = out.upper = infinity;
  out.normal = {0, 0, 1};
  const auto keep_least = [&](const Distance& found) {
    if (found.distance < out.distance) {
      out = found;
    }
  };
  for (const FlatWall& wall : walls.flat.span()) {
    Distance found{};
    if (const Outcome outcome = half_space_distance(WallSolid(wall), b, ab, settings, found); outcome != Outcome::ok) {
      return outcome;
    }
    keep_least(found);
  }
  if (const auto& wall = walls.round) {
    visit_outermost(*wall, b, ab, [&](const Vec3& point, const Feature& feature) {
      const ContactPoint found = contact_at(*wall, point, b.radius(), feature);
      keep_least({found.distance, found.distance, found.distance, found.point_a, found.point_b, found.normal,
                  Algorithm::hole, 1});
    });
    if constexpr (Curved<B>) {
      // Climbs may miss the furthest point. No point is further out than this.
      out.lower = std::min(out.lower, wall->radius - most_outward(*wall, b, ab));
    }
  }
  out.algorithm = Algorithm::hole;
  return out.distance < infinity ? Outcome::ok : Outcome::unsupported;
}

template <Convex B>
[[nodiscard]] Outcome contacts_in_walls(const Walls& walls, const B& b, const Pose& ab, const QuerySettings& settings,
                                        Manifold& out) {
  if (!takes_closed_forms(settings.algorithm)) {
    return Outcome::unsupported;
  }
  for (const FlatWall& wall : walls.flat.span()) {
    const std::size_t first = out.size();
    if (const Outcome outcome = half_space_contacts(WallSolid(wall), b, ab, settings, out); outcome != Outcome::ok) {
      return outcome;
    }
    for (ContactPoint& contact : std::span(out).subspan(first)) {
      contact.feature_a = {FeatureKind::face, wall.face};
      contact.id = contact_id(contact.feature_a, contact.feature_b);
    }
  }
  if (const auto& wall = walls.round) {
    const std::size_t first = out.size();
    const Real noise = noise_of(b.extent() + largest_magnitude(ab.position) + wall->radius);
    visit_outermost(*wall, b, ab, [&](const Vec3& point, const Feature& feature) {
      const ContactPoint found = contact_at(*wall, point, b.radius(), feature);
      if (!(found.distance <= settings.margin)) {
        return;
      }
      // Only points that no other point of the core exceeds in their own direction.
      const Vec3 outward = -found.normal;
      const Real most = dot(outward, ab * b.support(ab.rotation.undo(outward)).point);
      const auto is_same = [&](const ContactPoint& other) {
        return largest_magnitude(other.point_b - found.point_b) <= noise;
      };
      if (dot(outward, point) >= most - noise && std::ranges::none_of(std::span(out).subspan(first), is_same)) {
        out.push_back(found);
      }
    });
  }
  return Outcome::ok;
}

template <Hole A, Convex B>
[[nodiscard]] Outcome hole_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                    Distance& out) {
  return distance_in_walls({a.flat_walls(), a.round_wall()}, b, ab, settings, out);
}
template <Hole A, Convex B>
[[nodiscard]] Outcome hole_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                    Manifold& out) {
  return contacts_in_walls({a.flat_walls(), a.round_wall()}, b, ab, settings, out);
}

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// A cavity against what is no convex shape: the triangles of a surface that reach furthest out, and points of the
// surface of a sampled solid.
export module abut.narrow.walls.hole_surfaces;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.field.field_surfaces;
import abut.narrow.walls.half_space_surfaces;
export import abut.narrow.walls.hole;
import abut.narrow.parts.nearest_of_parts;
import abut.narrow.parts.spread_points;
import abut.trees.boxes.furthest_first;

export namespace abut {

// How far boxes of a shape reach from the middle of a round wall.
class OutwardReach {
 public:
  OutwardReach(const RoundWall& wall, const Pose& ab) : wall_(wall), ab_(ab) {}

  [[nodiscard]] Real operator()(const Aabb& box) const {
    const Vec3 half = 0.5 * (box.high - box.low);
    const Vec3 wide =
        half.x * absolute(ab_.rotation.x) + half.y * absolute(ab_.rotation.y) + half.z * absolute(ab_.rotation.z);
    return norm(wall_.radial(absolute(ab_ * box.centre()) + wide));
  }
  // How much it may be off by rounding.
  [[nodiscard]] Real noise(const Aabb& whole) const {
    return rounding_of(largest_magnitude(maximum(absolute(whole.low), absolute(whole.high))) +
                       largest_magnitude(ab_.position) + wall_.radius);
  }

 private:
  RoundWall wall_;
  Pose ab_;
};

// The nearest answer for one wall after the other.
template <class OfFlat, class OfRound>
[[nodiscard]] Outcome nearest_of_walls(const Walls& walls, const OfFlat& of_flat, const OfRound& of_round,
                                       Distance& out) {
  out = no_distance();
  for (const FlatWall& wall : walls.flat.span()) {
    Distance found{};
    if (const Outcome outcome = of_flat(WallSolid(wall), found); outcome != Outcome::ok) {
      return outcome;
    }
    take_part(found, out);
  }
  if (walls.round) {
    take_part(of_round(*walls.round), out);
  }
  out.algorithm = Algorithm::hole;
  return Outcome::ok;
}

template <class OfFlat>
[[nodiscard]] Outcome contacts_of_flat_walls(const FlatWalls& walls, const OfFlat& of_flat, Manifold& out) {
  for (const FlatWall& wall : walls.span()) {
    const std::size_t first = out.size();
    if (const Outcome outcome = of_flat(WallSolid(wall)); outcome != Outcome::ok) {
      return outcome;
    }
    for (ContactPoint& contact : std::span(out).subspan(first)) {
      contact.feature_a = {FeatureKind::face, wall.face};
      contact.id = contact_id_of_part(contact.id, wall.face);
    }
  }
  return Outcome::ok;
}

template <Hole A, Surface B>
[[nodiscard]] Outcome hole_parts_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                          Distance& out) {
  if (!takes_closed_forms(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const auto of_flat = [&](const WallSolid& wall, Distance& found) {
    return half_space_parts_distance(wall, b, ab, settings, found);
  };
  const auto of_round = [&](const RoundWall& wall) {
    const OutwardReach reach(wall, ab);
    // Parts that reach as far as the furthest so far are passed over: of a ball in a ball, these would be all.
    const Real noise = reach.noise(b.aabb(Pose::identity()));
    Distance best = no_distance();
    Real limit = -infinity;
    visit_furthest_first(b, reach, limit, [&](std::uint32_t index) {
      Distance found{};
      if (distance_in_walls({{}, wall}, b.part(index), ab, settings, found) == Outcome::ok) {
        take_part(found, best);
      }
      limit = wall.radius - best.distance + noise;
    });
    return best;
  };
  return nearest_of_walls({a.flat_walls(), a.round_wall()}, of_flat, of_round, out);
}

// Of each triangle by itself.
template <Hole A, Surface B>
[[nodiscard]] Outcome hole_parts_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                          Manifold& out) {
  if (!takes_closed_forms(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const auto of_flat = [&](const WallSolid& wall) { return half_space_parts_contacts(wall, b, ab, settings, out); };
  Outcome outcome = contacts_of_flat_walls(a.flat_walls(), of_flat, out);
  if (const std::optional<RoundWall> wall = a.round_wall()) {
    const OutwardReach reach(*wall, ab);
    const Real limit = wall->radius - settings.margin - reach.noise(b.aabb(Pose::identity()));
    visit_furthest_first(b, reach, limit, [&](std::uint32_t index) {
      const std::size_t first = out.size();
      outcome = outcome == Outcome::ok ? contacts_in_walls({{}, wall}, b.part(index), ab, settings, out) : outcome;
      for (ContactPoint& contact : std::span(out).subspan(first)) {
        contact.feature_b = {FeatureKind::face, index};
        contact.id = contact_id_of_part(contact.id, index);
      }
    });
  }
  return outcome;
}

// The point of a field's surface that reaches furthest out.
template <SampledSolid F>
[[nodiscard]] Distance field_distance_in_round_wall(const RoundWall& wall, const F& field, const Pose& ab) {
  const OutwardReach reach(wall, ab);
  const SurfacePoints& surface = field.surface();
  const auto reach_at = [&](const Vec3& point) { return norm(wall.radial(ab * point)); };
  Real most = -infinity;
  Vec3 furthest = field.solid_box().centre();
  for (const SurfacePoints::Run& run : surface.runs) {
    if (reach(run.box) > most) {
      for (const Vec3& point : std::span(surface.points).subspan(run.first, run.count)) {
        if (const Real far = reach_at(point); far > most) {
          most = far;
          furthest = point;
        }
      }
    }
  }
  Real most_doubtful = most;
  for (const Vec3& point : surface.doubtful) {
    most_doubtful = std::max(most_doubtful, reach_at(point));
  }
  const ContactPoint at = contact_at(wall, ab * furthest, 0, {});
  const Real least_of_box = wall.radius - reach(field.solid_box());
  const Real distance = most > -infinity ? at.distance : least_of_box;
  const Real lower = std::max(std::min(distance, wall.radius - most_doubtful) - field.surface_error(), least_of_box);
  return {distance,
          std::min(lower, distance),
          most > -infinity ? distance : infinity,
          at.point_b - distance * at.normal,
          at.point_b,
          at.normal,
          Algorithm::hole,
          1};
}

// A container has no outside that could fit into a cavity.
template <Hole A, SampledSolid F>
[[nodiscard]] Outcome hole_field_distance(const A& a, const F& field, const Pose& ab, const QuerySettings& settings,
                                          Distance& out) {
  if (!takes_closed_forms(settings.algorithm) || field.is_inside_out()) {
    return Outcome::unsupported;
  }
  return nearest_of_walls(
      {a.flat_walls(), a.round_wall()},
      [&](const WallSolid& wall, Distance& found) {
        return half_space_field_distance(wall, field, ab, settings, found);
      },
      [&](const RoundWall& wall) { return field_distance_in_round_wall(wall, field, ab); }, out);
}

template <Hole A, SampledSolid F>
[[nodiscard]] Outcome hole_field_contacts(const A& a, const F& field, const Pose& ab, const QuerySettings& settings,
                                          Manifold& out) {
  if (!takes_closed_forms(settings.algorithm) || field.is_inside_out()) {
    return Outcome::unsupported;
  }
  const auto of_flat = [&](const WallSolid& wall) { return half_space_field_contacts(wall, field, ab, settings, out); };
  const Outcome outcome = contacts_of_flat_walls(a.flat_walls(), of_flat, out);
  if (const std::optional<RoundWall> wall = a.round_wall()) {
    const OutwardReach reach(*wall, ab);
    const SurfacePoints& surface = field.surface();
    for (const SurfacePoints::Run& run : surface.runs) {
      if (wall->radius - reach(run.box) > settings.margin) {
        continue;
      }
      SpreadPoints spread(contact_at(*wall, ab * run.box.centre(), 0, {}).normal);
      for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
        const Vec3 point = ab * surface.points[i];
        if (const Real distance = wall->radius - norm(wall->radial(point)); distance <= settings.margin) {
          spread.add(i, point, distance);
        }
      }
      spread.visit([&](const SpreadPoints::Kept& kept) {
        const Feature of_field{FeatureKind::cell, surface.cells[kept.index]};
        out.push_back(contact_at(*wall, ab * surface.points[kept.index], 0, of_field));
      });
    }
  }
  return outcome;
}

}  // namespace abut

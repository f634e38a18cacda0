// SPDX-License-Identifier: Apache-2.0
// A sampled solid against what is no convex shape: surfaces triangle by triangle, half-spaces and other fields by
// points of its surface.
export module abut.narrow.field.field_surfaces;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.field.field_contacts;
import abut.narrow.field.field_descent;
import abut.narrow.parts.nearest_of_parts;
import abut.narrow.parts.spread_points;

export namespace abut {

// Whether a contact pushes to the front of a triangle, from which the field comes.
template <class Part>
[[nodiscard]] bool is_in_front(const Part& part, const Pose& ab, const Vec3& normal) {
  if constexpr (requires { part.is_one_sided(); }) {
    return !part.is_one_sided() || dot(part.normal(), ab.rotation.undo(normal)) < 0;
  } else {
    return true;
  }
}

template <SampledSolid F, Surface B>
[[nodiscard]] Outcome field_parts_distance(const F& field, const B& b, const Pose& ab, const QuerySettings& settings,
                                           Distance& out) {
  if (!fields_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  out = no_distance();
  out.algorithm = Algorithm::field;
  Outcome outcome = Outcome::ok;
  const Aabb around = transformed(field.solid_box(), ab.inverse());
  const auto consider = [&](const typename B::Part& part) {
    Distance found{};
    outcome = field_distance(field, part, ab, settings, found);
    take_part(found, out);
  };
  const auto start = b.part_near(around.centre());
  consider(start);
  const auto near = [&] {
    return field.is_inside_out() ? Aabb::everything() : around.inflated(std::max(out.upper, Real{0}));
  };
  Aabb query = near();
  b.visit_parts(query, [&](const typename B::Part& part, std::uint32_t index) {
    const Vec3 centre = part.centre();
    Real reach = 0;
    for (const Vec3& corner : part.corners()) {
      reach = std::max(reach, norm(corner - centre));
    }
    if (index != start.index() &&
        field.least_within(field.value_at(ab * centre).value, reach) < std::max(out.upper, Real{0})) {
      consider(part);
      query = near();
    }
  });
  return outcome;
}

template <SampledSolid F, Surface B>
[[nodiscard]] Outcome field_parts_contacts(const F& field, const B& b, const Pose& ab, const QuerySettings& settings,
                                           Manifold& out) {
  if (!fields_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const std::size_t first = out.size();
  Aabb query = field.is_inside_out()
                   ? Aabb::everything()
                   : transformed(field.solid_box(), ab.inverse()).inflated(std::max(settings.margin, Real{0}));
  Outcome outcome = Outcome::ok;
  Manifold of_part;
  b.visit_parts(query, [&](const typename B::Part& part, std::uint32_t index) {
    of_part.clear();
    const Outcome one = field_contacts(field, part, ab, settings, of_part);
    outcome = one == Outcome::ok ? outcome : one;
    for (ContactPoint& contact : of_part) {
      if (is_in_front(part, ab, contact.normal)) {
        contact.id = contact_id_of_part(contact.id, index);
        contact.feature_b = {FeatureKind::face, index};
        out.push_back(contact);
      }
    }
  });
  // Triangles share their corners.
  const std::span<ContactPoint> found = std::span(out).subspan(first);
  const auto place = [](const ContactPoint& contact) {
    return std::tuple(contact.point_b.x, contact.point_b.y, contact.point_b.z, contact.feature_b.index);
  };
  std::ranges::sort(found, {}, place);
  const auto is_same = [](const ContactPoint& a, const ContactPoint& c) { return a.point_b == c.point_b; };
  out.resize(first + static_cast<std::size_t>(std::unique(found.begin(), found.end(), is_same) - found.begin()),
             ContactPoint{});
  return outcome;
}

// The lowest that a box reaches along a direction.
[[nodiscard]] inline Real lowest_of(const Aabb& box, const Vec3& direction) {
  return dot(box.centre(), direction) - 0.5 * dot(box.high - box.low, absolute(direction));
}

// A container reaches everywhere, and so behind every plane.
template <HalfSpace A, SampledSolid F>
[[nodiscard]] Outcome half_space_field_distance(const A& a, const F& field, const Pose& ab,
                                                const QuerySettings& settings, Distance& out) {
  if (!fields_support(settings.algorithm) || field.is_inside_out()) {
    return Outcome::unsupported;
  }
  const Vec3 normal = ab.rotation.undo(a.normal());
  const Real offset = a.offset() - dot(a.normal(), ab.position);
  const SurfacePoints& surface = field.surface();
  Real least = infinity;
  Vec3 lowest = field.solid_box().centre();
  for (const SurfacePoints::Run& run : surface.runs) {
    if (lowest_of(run.box, normal) < least) {
      for (const Vec3& point : std::span(surface.points).subspan(run.first, run.count)) {
        if (const Real height = dot(normal, point); height < least) {
          least = height;
          lowest = point;
        }
      }
    }
  }
  Real least_doubtful = least;
  for (const Vec3& point : surface.doubtful) {
    least_doubtful = std::min(least_doubtful, dot(normal, point));
  }
  const Real distance = (least < infinity ? least : lowest_of(field.solid_box(), normal)) - offset;
  const Vec3 point_b = ab * lowest;
  out = {distance,
         std::max(std::min(distance, least_doubtful - offset) - field.surface_error(),
                  lowest_of(field.solid_box(), normal) - offset),
         least < infinity ? distance : infinity,
         point_b - distance * a.normal(),
         point_b,
         a.normal(),
         Algorithm::field,
         1};
  out.lower = std::min(out.lower, out.distance);
  return Outcome::ok;
}

template <HalfSpace A, SampledSolid F>
[[nodiscard]] Outcome half_space_field_contacts(const A& a, const F& field, const Pose& ab,
                                                const QuerySettings& settings, Manifold& out) {
  if (!fields_support(settings.algorithm) || field.is_inside_out()) {
    return Outcome::unsupported;
  }
  const Vec3 normal = ab.rotation.undo(a.normal());
  const Real offset = a.offset() - dot(a.normal(), ab.position);
  const SurfacePoints& surface = field.surface();
  for (const SurfacePoints::Run& run : surface.runs) {
    if (lowest_of(run.box, normal) - offset > settings.margin) {
      continue;
    }
    SpreadPoints spread(normal);
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
      if (const Real height = dot(normal, surface.points[i]) - offset; height <= settings.margin) {
        spread.add(i, surface.points[i], height);
      }
    }
    spread.visit([&](const SpreadPoints::Kept& kept) {
      const Vec3 point = ab * surface.points[kept.index];
      const Feature of_plane{FeatureKind::whole, 0}, of_field{FeatureKind::cell, surface.cells[kept.index]};
      out.push_back({point - kept.height * a.normal(), point, a.normal(), kept.height, of_plane, of_field,
                     contact_id(of_plane, of_field)});
    });
  }
  return Outcome::ok;
}

// Points of the surface of `other` where a field has values up to a limit, which may shrink on the way. `placed` tells
// where `other` is in the frame of the field.
template <SampledSolid F, SampledSolid G, class Visitor>
void visit_points_in_field(const F& field, const G& other, const Pose& placed, const Real& limit, Visitor&& visit) {
  const SurfacePoints& surface = other.surface();
  for (const SurfacePoints::Run& run : surface.runs) {
    const Real reach = 0.5 * norm(run.box.high - run.box.low);
    if (field.least_within(field.value_at(placed * run.box.centre()).value, reach) > limit) {
      continue;
    }
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
      if (const FieldValue found = field.value_at(placed * surface.points[i]); found.value <= limit) {
        visit(run, i, found);
      }
    }
  }
}

// The least value of a field at points of the surface of another one, as a distance from the field.
template <SampledSolid F, SampledSolid G>
[[nodiscard]] Distance distance_to_surface_of(const F& field, const G& other, const Pose& placed) {
  Real least = infinity;
  std::uint32_t deepest = no_index;
  visit_points_in_field(field, other, placed, least,
                        [&](const SurfacePoints::Run&, std::uint32_t i, const FieldValue& found) {
                          if (found.value < least) {
                            least = found.value;
                            deepest = i;
                          }
                        });
  Real least_doubtful = least;
  for (const Vec3& about : other.surface().doubtful) {
    least_doubtful = std::min(least_doubtful, field.value_at(placed * about).value);
  }
  if (deepest == no_index) {
    Distance none = no_distance();
    none.lower = least_doubtful < infinity ? -infinity : infinity;
    return none;
  }
  const PointCore point(0);
  const Pose at{Rotation::identity(), placed * other.surface().points[deepest]};
  const auto touch = CoreInField<F, PointCore>(field, point, at).touch({0, 0, 0});
  return distance_of_touch(
      field, touch, 0, least_nearby(field, least_doubtful, other.surface_error()), [&](const Vec3& direction) {
        return other.is_inside_out() ? -infinity : lowest_of(transformed(other.solid_box(), placed), direction);
      });
}

// Stands in where neither solid has a surface, and so nothing that could be met.
[[nodiscard]] inline Distance distance_of_middles(const Aabb& a, const Aabb& b) {
  Distance out = no_distance();
  const Vec3 way = b.centre() - a.centre();
  out.algorithm = Algorithm::field;
  out.normal = UnitVec3::make(way).value_or(UnitVec3::axis_z());
  out.distance = dot(way, out.normal);
  out.point_a = a.centre();
  out.point_b = b.centre();
  return out;
}

template <SampledSolid F, SampledSolid G>
[[nodiscard]] Outcome two_fields_distance(const F& a, const G& b, const Pose& ab, const QuerySettings& settings,
                                          Distance& out) {
  if (!fields_support(settings.algorithm) || (a.is_inside_out() && b.is_inside_out())) {
    return Outcome::unsupported;
  }
  out = distance_to_surface_of(a, b, ab);
  Distance of_b = distance_to_surface_of(b, a, ab.inverse());
  move_by(of_b, ab, true);
  // Either bounds the distance by itself.
  const Real lower = std::max(out.lower, of_b.lower), upper = std::min(out.upper, of_b.upper);
  if (of_b.distance < out.distance) {
    out = of_b;
  }
  if (!(out.distance < infinity)) {
    out = distance_of_middles(a.solid_box(), transformed(b.solid_box(), ab));
  }
  out.lower = std::min(lower, out.distance);
  out.upper = std::max(upper, out.distance);
  return Outcome::ok;
}

// The distance of the point of least value, as of distance_to_surface_of.
template <SampledSolid F, SampledSolid G>
Real contacts_with_surface_of(const F& field, const G& other, const Pose& placed, Real margin, bool is_of_a,
                              Manifold& out) {
  const SurfacePoints& surface = other.surface();
  const PointCore point(0);
  // The deepest point of each run.
  const SurfacePoints::Run* last = nullptr;
  std::uint32_t deepest = 0;
  Real least = infinity, least_of_all = infinity, distance = infinity;
  const auto append = [&] {
    const Pose at{Rotation::identity(), placed * surface.points[deepest]};
    const Feature feature{FeatureKind::cell, surface.cells[deepest]};
    const auto touch = CoreInField<F, PointCore>(field, point, at).touch({0, 0, 0});
    ContactPoint found = contact_of_touch(touch, 0, feature);
    if (least < least_of_all) {
      least_of_all = least;
      distance = found.distance;
    }
    if (found.distance <= margin && !touch.is_of_nothing()) {
      // Cells of both sides have the same numbers.
      found.id = contact_id_of_part(found.id, is_of_a ? 1 : 0);
      out.push_back(found);
    }
  };
  visit_points_in_field(field, other, placed, margin,
                        [&](const SurfacePoints::Run& run, std::uint32_t i, const FieldValue& found) {
                          if (&run != last) {
                            if (last != nullptr) {
                              append();
                            }
                            last = &run;
                            least = infinity;
                          }
                          if (found.value < least) {
                            least = found.value;
                            deepest = i;
                          }
                        });
  if (last != nullptr) {
    append();
  }
  return distance;
}

template <SampledSolid F, SampledSolid G>
[[nodiscard]] Outcome two_fields_contacts(const F& a, const G& b, const Pose& ab, const QuerySettings& settings,
                                          Manifold& out) {
  if (!fields_support(settings.algorithm) || (a.is_inside_out() && b.is_inside_out())) {
    return Outcome::unsupported;
  }
  const std::size_t first = out.size();
  const Real of_b = contacts_with_surface_of(a, b, ab, settings.margin, false, out);
  const std::size_t second = out.size();
  const Real of_a = contacts_with_surface_of(b, a, ab.inverse(), settings.margin, true, out);
  for (ContactPoint& contact : std::span(out).subspan(second)) {
    move_by(contact, ab, true);
  }
  bound_depths(std::min(of_a, of_b), first, out);
  return Outcome::ok;
}

}  // namespace abut

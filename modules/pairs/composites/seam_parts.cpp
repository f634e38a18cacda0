// SPDX-License-Identifier: Apache-2.0
module abut.pairs.composites.seam_parts;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.ways.continuation;
import abut.narrow.ways.nearest_face;
import abut.pairs.registry;
import abut.pairs.composites.children;

namespace abut {
namespace {

constexpr auto are_surfaces = []<class... S>(const std::variant<S...>*) {
  return std::array<bool, sizeof...(S)>{Surface<S>...};
}(static_cast<const AnyShape::Variant*>(nullptr));
constexpr auto are_weldable = []<class... S>(const std::variant<S...>*) {
  return std::array<bool, sizeof...(S)>{(Convex<S> || HalfSpace<S>)...};
}(static_cast<const AnyShape::Variant*>(nullptr));

// False of what is no surface.
template <class Ask>
bool ask_surface(const AnyShape& shape, Ask&& ask) {
  bool answer = false;
  with_surface(shape, [&](const auto& surface) { answer = ask(surface); });
  return answer;
}

// What a search on two cores leaves of a point or a normal, as a share of their size.
constexpr Real point_noise = 1e-11, rise_noise = 1e-9;

// What holds more than a point of a convex shape rises from there, wherever the rest of it lies.
bool goes_on_at_convex(const AnyShape& part, const Vec3& point, const Vec3& normal, Real size) {
  const Real noise = noise_of(largest_magnitude(point));
  if (!(reach_along(part, normal) - dot(normal, point) > rise_noise * size + noise)) {
    return false;
  }
  return holds_at(part, point, size);
}

template <Convex S>
void add_faces(const S& shape, std::vector<Vec3>& faces) {
  if constexpr (Faceted<S>) {
    for (const auto& four : shape.facets().planes) {
      for (int lane = 0; lane < 4; ++lane) {
        faces.push_back({four.x[lane], four.y[lane], four.z[lane]});
      }
    }
  } else {
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      for (const Vec3& direction : {axis, -axis}) {
        [[clang::uninitialized]] const Face face = shape.supporting_face(direction);
        if (squared_norm(face.normal) > 0) {
          faces.push_back(face.normal);
        }
      }
    }
  }
}

}  // namespace

bool is_surface_kind(std::size_t kind) { return are_surfaces[kind]; }
bool is_surface(const AnyShape& shape) { return is_surface_kind(shape.index()); }
bool is_weldable_kind(std::size_t kind) { return are_weldable[kind]; }
bool is_weldable(const AnyShape& shape) { return is_weldable_kind(shape.index()); }

Real half_size_of(const AnyShape& shape) {
  const Aabb box =
      std::visit([](const auto& s) { return s.aabb(Pose::identity()); }, static_cast<const AnyShape::Variant&>(shape));
  return box.is_bounded() ? 0.5 * largest_magnitude(box.high - box.low) : infinity;
}

Real reach_along(const AnyShape& shape, const Vec3& direction) {
  return std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Convex<S>) {
          return dot(direction, s.support(direction).point) + s.radius() * norm(direction);
        } else if constexpr (HalfSpace<S>) {
          constexpr Real same = 1e-9;
          return largest_magnitude(direction - s.normal()) <= same ? s.offset() : infinity;
        } else {
          const Aabb box = s.aabb(Pose::identity());
          return dot(direction, box.centre()) + 0.5 * dot(absolute(direction), box.high - box.low);
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

bool goes_on_at(const AnyShape& part, const Vec3& point, const Vec3& normal, Real size) {
  return is_weldable(part)
             ? goes_on_at_convex(part, point, normal, size)
             : ask_surface(part, [&](const auto& surface) { return goes_on(surface, point, normal, size); });
}

bool holds_at(const AnyShape& part, const Vec3& point, Real size) {
  if (!is_weldable(part)) {
    return ask_surface(part, [&](const auto& surface) {
      return any_around(surface, point, size, [](const TriangleCorners&, Real) { return true; });
    });
  }
  const std::optional<Distance> found = part.distance_to(point);
  return found && found->distance <= crack_share * size + noise_of(largest_magnitude(point));
}

bool lies_on(const AnyShape& part, const Vec3& point, Real size) {
  const Real noise = point_noise * size + noise_of(largest_magnitude(point));
  if (!is_weldable(part)) {
    return ask_surface(part, [&](const auto& surface) {
      return any_around(surface, point, size,
                        [&](const TriangleCorners& corners, Real) { return holds(corners, point, noise); });
    });
  }
  const std::optional<Distance> found = part.distance_to(point);
  return found && std::fabs(found->distance) <= noise;
}

bool has_face_at(const AnyShape& surface, const Vec3& point, const Vec3& normal, Real size) {
  return ask_surface(surface, [&](const auto& its) { return has_face(its, point, normal, size); });
}

std::vector<Vec3> faces_of(const AnyShape& part, const Vec3& point, const Vec3& direction, Real size) {
  std::vector<Vec3> faces;
  std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Surface<S>) {
          if (const std::optional<Vec3> face = nearest_face_normal(s, point, direction, size)) {
            faces.push_back(*face);
          }
        } else if constexpr (Convex<S>) {
          add_faces(s, faces);
        } else if constexpr (HalfSpace<S>) {
          faces.push_back(s.normal());
        }
      },
      static_cast<const AnyShape::Variant&>(part));
  return faces;
}

std::optional<AnyShape> half_space_under(const Vec3& normal, Real height) {
  const std::array<Real, 4> parameters{normal.x, normal.y, normal.z, height};
  std::optional<AnyShape> made;
  const auto make = [&]<class S>() {
    if constexpr (HalfSpace<S>) {
      if (const Result<S> shape = S::make(parameters, {}, {})) {
        made.emplace(shape.value());
      }
    }
  };
  [&]<class... S>(const std::variant<S...>*) {
    (make.template operator()<S>(), ...);
  }(static_cast<const AnyShape::Variant*>(nullptr));
  return made;
}

Feature face_along(const AnyShape& part, const Vec3& direction) {
  return std::visit(
      [&]<class S>(const S& s) -> Feature {
        if constexpr (Convex<S>) {
          [[clang::uninitialized]] const Face face = s.supporting_face(direction);
          if (squared_norm(face.normal) > 0) {
            return {FeatureKind::face, face.index};
          }
        }
        return {FeatureKind::whole, 0};
      },
      static_cast<const AnyShape::Variant&>(part));
}

}  // namespace abut

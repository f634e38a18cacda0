// SPDX-License-Identifier: Apache-2.0
module abut.pairs.taken_apart.convex_part;
import abut.capability;
import abut.core.bug;
import abut.core.standard;
import abut.math;
import abut.pairs.registry;

namespace abut {
namespace {

const AnyShape::Variant& variant_of(const AnyShape& shape) { return shape; }

// Of a shape that is convex.
template <class Answer, class Function>
Answer visit_convex(const AnyShape& shape, Function&& function) {
  return std::visit(
      [&]<class S>(const S& s) -> Answer {
        if constexpr (Convex<S>) {
          return function(s);
        } else {
          report_bug("a part is convex", __FILE_NAME__, __LINE__);
        }
      },
      variant_of(shape));
}

}  // namespace

bool is_convex_kind(std::size_t kind) {
  static constexpr auto are_convex = []<class... S>(const std::variant<S...>*) {
    return std::array<bool, sizeof...(S)>{(BoxCored<S> || Convex<S>)...};
  }(static_cast<const AnyShape::Variant*>(nullptr));
  return are_convex[kind];
}

std::optional<ConvexPart> ConvexPart::of(const AnyShape& shape) {
  return std::visit(
      [&]<class S>(const S& s) -> std::optional<ConvexPart> {
        if constexpr (BoxCored<S>) {
          return ConvexPart(Cuboid{s.half()}, s.radius());
        } else if constexpr (Convex<S>) {
          return ConvexPart(&shape, s.radius());
        } else {
          return std::nullopt;
        }
      },
      variant_of(shape));
}

SupportPoint ConvexPart::support_of_shape(const Vec3& direction) const {
  return visit_convex<SupportPoint>(*std::get<const AnyShape*>(core_),
                                    [&](const auto& shape) { return shape.support(direction); });
}

Face ConvexPart::supporting_face(const Vec3& direction) const {
  const SupportPoint furthest = support(direction);
  Face face;
  face.vertices.push_back({furthest.point, furthest.index, 0});
  return face;
}

Vec3 ConvexPart::centre() const {
  if (const Triangle* triangle = std::get_if<Triangle>(&core_)) {
    return triangle->centre();
  }
  const AnyShape* const* shape = std::get_if<const AnyShape*>(&core_);
  return shape == nullptr ? Vec3{0, 0, 0} : visit_convex<Vec3>(**shape, [](const auto& s) { return s.centre(); });
}

Real ConvexPart::extent() const {
  if (const Cuboid* cuboid = std::get_if<Cuboid>(&core_)) {
    return largest_magnitude(cuboid->half);
  }
  const Triangle* triangle = std::get_if<Triangle>(&core_);
  return triangle != nullptr
             ? triangle->extent()
             : visit_convex<Real>(*std::get<const AnyShape*>(core_), [](const auto& s) { return s.extent(); });
}

Aabb ConvexPart::aabb(const Pose& pose) const {
  if (const Cuboid* cuboid = std::get_if<Cuboid>(&core_)) {
    const Vec3 half = cuboid->half;
    const Rotation& r = pose.rotation;
    return Aabb::around(pose.position, half.x * absolute(r.x) + half.y * absolute(r.y) + half.z * absolute(r.z))
        .inflated(radius_);
  }
  const Triangle* triangle = std::get_if<Triangle>(&core_);
  return triangle != nullptr
             ? triangle->aabb(pose)
             : visit_convex<Aabb>(*std::get<const AnyShape*>(core_), [&](const auto& s) { return s.aabb(pose); });
}

bool ConvexPart::is_curved() const {
  const AnyShape* const* shape = std::get_if<const AnyShape*>(&core_);
  return shape != nullptr && visit_convex<bool>(**shape, []<class S>(const S&) { return Curved<S>; });
}

std::optional<Vec3> ConvexPart::only_front() const {
  if (const Triangle* triangle = std::get_if<Triangle>(&core_)) {
    return triangle->is_one_sided() ? std::optional(triangle->normal()) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// Two surfaces: the triangles that are near each other, which both trees find together.
export module abut.narrow.two_surfaces;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.convex;
import abut.narrow.parts.nearest_of_parts;
export import abut.narrow.surface.particles_on_surface;
export import abut.narrow.surface.surfaces;
import abut.narrow.surface.triangle_source;
import abut.narrow.parts.two_parts;
import abut.narrow.two_surfaces.two_sources;

export namespace abut {

template <Surface A, Surface B>
[[nodiscard]] Outcome surfaces_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                        Manifold& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  contacts_of_surfaces(SourceOf<A>(a), SourceOf<B>(b), ab, settings, out);
  return Outcome::ok;
}

// The gap between the planes across a normal that hold all of one surface and all of another. What lies too far behind
// its plane is not the nearest.
template <Surface A, Surface B>
class [[gsl::Pointer]] SlabBetween {
 public:
  SlabBetween(const A& a, const B& b, const Pose& ab) : a_(a), b_(b), ab_(ab) {}

  void turn(const Vec3& normal) {
    normal_ = normal;
    local_ = ab_.rotation.undo(normal);
    shift_ = dot(normal, ab_.position);
    high_a_ = -lowest_of(a_, -normal_);
    low_b_ = lowest_of(b_, local_) + shift_;
  }
  // No point of the other surface is nearer to the part.
  [[nodiscard]] Real gap_of(std::uint32_t part, bool is_of_b) const {
    return is_of_b ? least_along(b_.corners(part), local_) + shift_ - high_a_
                   : low_b_ + least_along(a_.corners(part), -normal_);
  }
  // No points of two parts are nearer to each other.
  [[nodiscard]] Real gap_of(const Triangle& part, const Triangle& other) const {
    return least_along(other.corners(), local_) + shift_ + least_along(part.corners(), -normal_);
  }

 private:
  const A& a_;
  const B& b_;
  const Pose& ab_;
  Vec3 normal_{0, 0, 0}, local_{0, 0, 0};
  Real shift_ = 0, high_a_ = infinity, low_b_ = -infinity;
};

// The depth of the whole, or the nearest two triangles, each as a sheet.
template <Surface A, Surface B>
[[nodiscard]] Outcome surfaces_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                        Distance& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const bool has_solid = stopping_sides(a) == StoppingSides::solid || stopping_sides(b) == StoppingSides::solid;
  if (has_solid && depth_of_surfaces(SourceOf<A>(a), SourceOf<B>(b), ab, settings, out)) {
    return Outcome::ok;
  }
  out = no_distance();
  Triangle other = b.part_near(ab.undo(a.aabb(Pose::identity()).centre()));
  Triangle triangle = a.part_near(ab * other.centre());
  take_nearer(triangle, other, ab, settings, out);
  // What is as near as the nearest so far, within rounding, is passed over: of parallel surfaces, that would be all.
  const Real rounding = 4 * noise_of_two(a, b, ab);
  SlabBetween<A, B> slab(a, b, ab);
  const auto reach = [&] {
    return out.distance > rounding ? out.distance - rounding : std::max(out.distance, Real{0});
  };
  slab.turn(out.normal);
  const auto visit = [&](const Triangle& part, const Triangle& part_of_b) {
    if (slab.gap_of(part, part_of_b) <= reach() && take_nearer(part, part_of_b, ab, settings, out)) {
      triangle = part;
      other = part_of_b;
      slab.turn(out.normal);
    }
    return out.distance < -rounding ? -infinity : reach();  // the depth is that of the whole
  };
  visit_two_parts(a, b, ab, reach(), visit,
                  [&](std::uint32_t part, bool is_of_b) { return slab.gap_of(part, is_of_b) <= reach(); });
  out.lower = out.distance > rounding ? std::min(out.lower, out.distance - rounding) : out.lower;
  const Real noise = noise_of(core_size(triangle, other, ab));
  if (!has_solid && out.distance < -noise) {
    static_cast<void>(depth_of_surfaces(SourceOf<A>(a), SourceOf<B>(b), ab, settings, out));
  }
  return Outcome::ok;
}

}  // namespace abut

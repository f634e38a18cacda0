// Composites: a mesh or a height field against anything, triangle by triangle.
module;
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>
export module abut.narrowphase.parts;
import abut.core;
import abut.math;
import abut.narrowphase.convex;
import abut.narrowphase.half_space;
import abut.narrowphase.triangle_contacts;
import abut.shape;

export namespace abut {

[[nodiscard]] inline bool parts_support(Algorithm algorithm) {
  return algorithm == Algorithm::automatic || algorithm == Algorithm::gjk_epa;
}

// Distance of a composite and a convex shape: of the nearest or deepest part. Starts from a part near
// the shape and shrinks the box that is still of interest with every better one.
template <Composite A, Convex B>
void nearest_part(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Distance& best) {
  const Aabb around = b.aabb(ab);
  const auto consider = [&](const typename A::Part& part) {
    const Distance distance = rounded(separate_from_triangle(part, b, ab, settings, infinity), 0, b.radius());
    const std::uint32_t iterations = best.iterations + distance.iterations;
    if (distance.distance < best.distance) {
      best = distance;
    }
    best.iterations = iterations;
  };
  consider(a.part_near(ab * b.centre()));
  Aabb query = best.distance < infinity ? around.inflated(std::max(best.distance, Real{0})) : Aabb::everything();
  a.visit_parts(query, [&](const typename A::Part& part, std::uint32_t) {
    consider(part);
    if (best.distance < infinity) {
      query = around.inflated(std::max(best.distance, Real{0}));
    }
  });
  // The bounds of the nearest part hold for the whole only as far as other parts go.
  best.lower = std::min(best.lower, best.distance);
}

[[nodiscard]] inline Distance no_distance() {
  Distance none{};
  none.distance = none.lower = none.upper = infinity;
  none.normal = {0, 0, 1};
  none.algorithm = Algorithm::gjk_epa;
  return none;
}

template <Composite A, Convex B>
[[nodiscard]] Outcome parts_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Distance& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  out = no_distance();
  nearest_part(a, b, ab, settings, out);
  return Outcome::ok;
}

template <Composite A, Convex B>
[[nodiscard]] Outcome parts_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Manifold& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  Aabb query = b.aabb(ab).inflated(std::max(settings.margin, Real{0}));
  a.visit_parts(query, [&](const typename A::Part& part, std::uint32_t) { triangle_contacts(part, b, ab, settings, out); });
  return Outcome::ok;
}

// Two composites: the parts of b one by one, each a convex shape to a.
template <Composite A, Composite B>
[[nodiscard]] Outcome composites_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Distance& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  out = no_distance();
  const Aabb around = a.aabb(ab.inverse());
  nearest_part(a, b.part_near(around.centre()), ab, settings, out);
  Aabb query = out.distance < infinity ? around.inflated(std::max(out.distance, Real{0})) : Aabb::everything();
  b.visit_parts(query, [&](const typename B::Part& part, std::uint32_t) {
    nearest_part(a, part, ab, settings, out);
    query = around.inflated(std::max(out.distance, Real{0}));
  });
  return Outcome::ok;
}

template <Composite A, Composite B>
[[nodiscard]] Outcome composites_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Manifold& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  Aabb query = a.aabb(ab.inverse()).inflated(std::max(settings.margin, Real{0}));
  b.visit_parts(query, [&](const typename B::Part& part, std::uint32_t index) {
    const std::size_t first = out.size();
    Aabb box = part.aabb(ab).inflated(std::max(settings.margin, Real{0}));
    a.visit_parts(box, [&](const typename A::Part& other, std::uint32_t) { triangle_contacts(other, part, ab, settings, out); });
    for (std::size_t i = first; i < out.size(); ++i) {
      out[i].id = mixed(out[i].id ^ (std::uint64_t{index} << 32));
      out[i].feature_b = {FeatureKind::face, index};
    }
  });
  return Outcome::ok;
}

// A half-space against every part: what lies behind the plane counts.
template <HalfSpace A, Composite B>
[[nodiscard]] Outcome half_space_parts_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Distance& out) {
  out = no_distance();
  Aabb everything = Aabb::everything();
  Outcome outcome = Outcome::ok;
  b.visit_parts(everything, [&](const typename B::Part& part, std::uint32_t) {
    Distance distance{};
    outcome = half_space_distance(a, part, ab, settings, distance);
    if (outcome == Outcome::ok && distance.distance < out.distance) {
      out = distance;
    }
  });
  return outcome;
}

template <HalfSpace A, Composite B>
[[nodiscard]] Outcome half_space_parts_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Manifold& out) {
  Aabb everything = Aabb::everything();
  Outcome outcome = Outcome::ok;
  b.visit_parts(everything, [&](const typename B::Part& part, std::uint32_t index) {
    const std::size_t first = out.size();
    outcome = half_space_contacts(a, part, ab, settings, out);
    for (std::size_t i = first; i < out.size(); ++i) {
      out[i].id = mixed(out[i].id + index);
      out[i].feature_b = {FeatureKind::face, index};
    }
  });
  return outcome;
}

}  // namespace abut

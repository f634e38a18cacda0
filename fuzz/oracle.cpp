// SPDX-License-Identifier: Apache-2.0
module;
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>
module abut.fuzz;

namespace abut::fuzz {
namespace {

std::string fault(std::string_view what, Real got, Real expected) {
  return std::string(what) + ": got " + to_text(got) + ", expected " + to_text(expected);
}

bool is_convex(const AnyShape& shape) {
  return std::visit([]<class S>(const S&) { return Convex<S>; }, shape);
}
// The box of a hole is that of its cavity.
bool is_unbounded(const AnyShape& shape) { return shape.is_hole() || !aabb_of(shape, Pose::identity()).is_bounded(); }
// Convex, bounded or not: the least translation that parts it is unique in length.
bool is_solid(const AnyShape& shape) {
  return std::visit([]<class S>(const S&) { return Convex<S> || HalfSpace<S>; }, shape);
}
// A surface without fronts.
bool is_two_sided(const AnyShape& shape) {
  return std::visit(
      []<class S>(const S& s) {
        if constexpr (Surface<S>) {
          return !s.has_fronts();
        } else {
          return false;
        }
      },
      shape);
}

// Whether contacts are found from all sides.
bool has_back(const AnyShape& shape) {
  return std::visit(
      []<class S>(const S& s) {
        if constexpr (Surface<S>) {
          return !s.has_fronts();
        } else {
          return Convex<S> || HalfSpace<S> || SampledSolid<S> || Hole<S>;
        }
      },
      shape);
}

// How far the answers of a sampled field may differ from each other: they come from values of several places.
Real doubt_of(const AnyShape& shape) {
  return std::visit(
      []<class S>(const S& s) -> Real {
        if constexpr (SampledSolid<S>) {
          return s.surface_error();
        } else {
          return 0;
        }
      },
      shape);
}
Real doubt_of(const Scene& scene) { return doubt_of(scene.a) + doubt_of(scene.b); }

// Whether the field is nowhere negative, as where a single sample is inside and values are means. Its box may be that
// of samples, in which nothing lies.
bool has_no_surface(const AnyShape& shape) {
  return std::visit(
      []<class S>(const S& s) {
        if constexpr (SampledSolid<S>) {
          return s.surface().points.empty() && s.surface().doubtful.empty();
        } else {
          return false;
        }
      },
      shape);
}

// Directions spread over the sphere, on a Fibonacci spiral.
std::span<const Vec3> sweep() {
  static const auto directions = [] {
    std::array<Vec3, 128> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Real z = 1 - (2 * static_cast<Real>(i) + 1) / static_cast<Real>(all.size());
      const Real around = 2.399963229728653 * static_cast<Real>(i), radius = std::sqrt(1 - z * z);
      all[i] = {radius * std::cos(around), radius * std::sin(around), z};
    }
    return all;
  }();
  return directions;
}

// What is asked of the points of an answer. They may stand in for a surface that is not there.
struct Claim {
  bool must_be_outermost, may_stand_in;
};

// A point in the frame of the shape must lie in it, and in what bounds it along the outward direction.
Verdict judge_point(const AnyShape& shape, const Vec3& point, const Vec3& outward, const Claim& claim, Real noise,
                    std::string_view name) {
  // The walls of a cavity go on beyond the box of what is cut out.
  if (!shape.is_hole() && !(claim.may_stand_in && has_no_surface(shape)) &&
      !aabb_of(shape, Pose::identity()).inflated(noise + doubt_of(shape)).overlaps({point, point})) {
    return std::string(name) + " is outside the box of its shape";
  }
  if (!is_convex(shape)) {
    return std::nullopt;
  }
  for (const Vec3& direction : sweep()) {
    const Real most = reach_along(shape, direction).value_or(0), got = dot(point, direction);
    if (got > most + noise) {
      return fault(std::string(name) + " is off its shape", got, most);
    }
  }
  const Real most = reach_along(shape, outward).value_or(0), got = dot(point, outward);
  if (claim.must_be_outermost && got < most - noise) {
    return fault(std::string(name) + " is below the surface", got, most);
  }
  return std::nullopt;
}

// What holds for distances and contacts alike.
Verdict judge_record(const Scene& scene, Real distance, const Vec3& point_a, const Vec3& point_b, const Vec3& normal,
                     const Claim& claim) {
  const Real noise = tolerance(scene);
  if (!std::isfinite(distance) || !is_finite(point_a) || !is_finite(point_b) || !is_finite(normal)) {
    return "a number is not finite";
  }
  if (std::fabs(norm(normal) - 1) > 1e-12) {
    return fault("length of the normal", norm(normal), 1);
  }
  const Real along = dot(point_b - point_a, normal);
  if (std::fabs(along - distance) > noise) {
    return fault("distance along the normal of the points", along, distance);
  }
  if (Verdict verdict = judge_point(scene.a, point_a, normal, claim, noise, "point_a")) {
    return verdict;
  }
  return judge_point(scene.b, scene.ab.undo(point_b), -scene.ab.rotation.undo(normal), claim, noise, "point_b");
}

Outcome distance_of(const Scene& scene, Algorithm algorithm, Distance& out) {
  return pair_distance(scene.a, scene.b, scene.ab, {.algorithm = algorithm}, out);
}

Real radius_of(const AnyShape& shape) {
  return std::visit(
      []<class S>(const S& s) -> Real {
        if constexpr (Convex<S>) {
          return s.radius();
        } else {
          return 0;
        }
      },
      shape);
}

// A core that only touches triangles at their edges goes through the surface or grazes it, and rounding tells which.
// Then the depth is either that of the rounding alone or that of the contacts.
bool is_touch_of_edges(const Scene& scene, const Distance& one, const Distance& other) {
  const bool is_surface = !(is_solid(scene.a) && is_solid(scene.b));
  const Real radii = radius_of(scene.a) + radius_of(scene.b), first = one.distance + radii,
             second = other.distance + radii;
  return is_surface && std::min(std::fabs(first), std::fabs(second)) <= 1e-3 * tolerance(scene) &&
         std::max(first, second) <= tolerance(scene);
}

// Searches in a field end within a ten-thousandth of a cell. Places swapped round otherwise, so that they end
// elsewhere: where values are flat, rounding of these moves their least by its root. A way to the surface changes as
// much.
Real search_error_of(const AnyShape& shape) {
  constexpr Real share = 1e-4;
  return std::visit(
      []<class S>(const S& s) -> Real {
        if constexpr (SampledSolid<S>) {
          return share * s.finest();
        } else {
          return 0;
        }
      },
      shape);
}

Verdict judge_swap(const Scene& scene, const Distance& found) {
  Distance other{};
  if (distance_of(swapped(scene), Algorithm::automatic, other) != Outcome::ok) {
    return "the swapped pair has no answer";
  }
  const Real noise = tolerance(scene) + search_error_of(scene.a) + search_error_of(scene.b);
  if (!(std::fabs(other.distance - found.distance) <= noise) && !is_touch_of_edges(scene, found, other)) {
    return fault("distance of the swapped pair", other.distance, found.distance);
  }
  return std::nullopt;
}

// Apart boxes mean apart shapes. Without a surface, values stand in for one, and there is no upper bound.
Verdict judge_boxes(const Scene& scene, const Distance& found) {
  const bool is_bounded = found.upper < std::numeric_limits<Real>::infinity();
  if (scene.a->is_hole() || scene.b->is_hole() ||
      (!is_bounded && (has_no_surface(scene.a) || has_no_surface(scene.b)))) {
    return std::nullopt;
  }
  const Aabb a = aabb_of(scene.a, Pose::identity()), b = aabb_of(scene.b, scene.ab);
  if (!a.inflated(tolerance(scene)).overlaps(b) && found.distance <= 0) {
    return fault("distance of shapes with boxes apart", found.distance, tolerance(scene));
  }
  return std::nullopt;
}

// Moved by its depth, a convex shape touches another one, and overlaps nothing of a surface of two sides.
Verdict judge_parted(const Scene& scene, const Distance& found) {
  const bool is_of_surface =
      (is_two_sided(scene.a) && is_convex(scene.b)) || (is_convex(scene.a) && is_two_sided(scene.b));
  if (!(is_solid(scene.a) && is_solid(scene.b)) && !is_of_surface) {
    return std::nullopt;
  }
  if (found.distance >= 0) {
    return std::nullopt;
  }
  Scene parted = scene;
  parted.ab.position += -found.distance * found.normal;
  Distance left{};
  if (distance_of(parted, Algorithm::automatic, left) != Outcome::ok) {
    return "shapes moved to touching have no answer";
  }
  if (is_of_surface ? !(left.distance >= -2 * tolerance(scene)) : !(std::fabs(left.distance) <= 2 * tolerance(scene))) {
    return fault("distance after parting along the normal", left.distance, 0);
  }
  return std::nullopt;
}

Verdict judge_scaled(std::size_t place_a, std::size_t place_b, const Record& record, const Scene& scene,
                     const Distance& found) {
  const Result<Scene> larger = make_scene(place_a, place_b, record, 2);
  if (!larger) {
    return "the doubled scene is refused: " + larger.error().message;
  }
  Distance doubled{};
  if (distance_of(larger.value(), Algorithm::automatic, doubled) != Outcome::ok) {
    return "the doubled scene has no answer";
  }
  if (!(std::fabs(doubled.distance - 2 * found.distance) <= 2 * tolerance(scene))) {
    return fault("distance of the doubled scene", doubled.distance, 2 * found.distance);
  }
  return std::nullopt;
}

}  // namespace

// Rounding of the input's largest length, with three digits to spare for badly shaped input.
Real tolerance(const Scene& scene) { return 1e-9 * scene.size; }

std::optional<Real> gap_along(const Scene& scene, const Vec3& direction) {
  const std::optional<Real> a = reach_along(scene.a, direction),
                            b = reach_along(scene.b, -scene.ab.rotation.undo(direction));
  return a && b ? std::optional(dot(direction, scene.ab.position) - *a - *b) : std::nullopt;
}

// The depth of a surface is the length of a translation that may end with several touches. Its points lie across each
// other and need not be outermost.
bool is_depth_of_surface(const Scene& scene, const Distance& found) {
  return !(is_solid(scene.a) && is_solid(scene.b)) && found.distance <= 0;
}

Verdict judge_distance(const Scene& scene, const Distance& found) {
  // The deepest point of a solid in a field may lie below its surface. What holes leave of a
  // solid may be nearest beside the nearest points of the solids (docs/shapes.md).
  const bool must_be_outermost =
      !has_holes(scene.a) && !has_holes(scene.b) && doubt_of(scene) == 0 && !is_depth_of_surface(scene, found);
  const Claim claim{must_be_outermost, !(found.upper < std::numeric_limits<Real>::infinity())};
  if (Verdict verdict = judge_record(scene, found.distance, found.point_a, found.point_b, found.normal, claim)) {
    return verdict;
  }
  const Real noise = tolerance(scene);
  if (!(found.lower <= found.upper) || !(found.lower <= found.distance + noise) ||
      !(found.distance <= found.upper + noise)) {
    return "the distance " + to_text(found.distance) + " is not within [" + to_text(found.lower) + ", " +
           to_text(found.upper) + "]";
  }
  if (const std::optional<Real> gap = gap_along(scene, found.normal)) {
    if (std::fabs(*gap - found.distance) > noise) {
      return fault("gap along the normal", *gap, found.distance);
    }
    for (const Vec3& direction : sweep()) {
      const Real other = gap_along(scene, direction).value_or(0);
      if (other > found.distance + noise) {
        return fault("distance although another direction has a larger gap", found.distance, other);
      }
    }
  }
  return judge_boxes(scene, found);
}

Verdict judge_contacts(const Scene& scene, const Distance& distance, const Manifold& found) {
  const Real noise = tolerance(scene) + doubt_of(scene);
  if (distance.distance > scene.margin + noise && !found.empty()) {
    return fault("distance of a contact of shapes that are apart",
                 std::ranges::min_element(found, {}, &ContactPoint::distance)->distance, distance.distance);
  }
  const bool solid = is_solid(scene.a) && is_solid(scene.b);
  // Without an upper bound there may be nothing to touch, as in a field whose samples are all positive.
  const bool is_sure = distance.upper < std::numeric_limits<Real>::infinity();
  if (is_sure && distance.distance < scene.margin - noise && found.empty() && has_back(scene.a) && has_back(scene.b)) {
    return fault("no contacts at distance", distance.distance, scene.margin);
  }
  Real deepest = std::numeric_limits<Real>::infinity();
  for (const ContactPoint& contact : found) {
    if (Verdict verdict =
            judge_record(scene, contact.distance, contact.point_a, contact.point_b, contact.normal, {false, false})) {
      return "contact: " + *verdict;
    }
    if (contact.distance > scene.margin + noise) {
      return fault("distance of a contact", contact.distance, scene.margin);
    }
    deepest = std::min(deepest, contact.distance);
  }
  if (solid && !found.empty() && std::fabs(deepest - distance.distance) > noise) {
    return fault("distance of the deepest contact", deepest, distance.distance);
  }
  // In a valley no contact is as deep as the whole.
  if (!found.empty() && has_back(scene.a) && has_back(scene.b) &&
      (deepest < distance.distance - noise || (distance.distance > 0 && deepest > distance.distance + noise))) {
    return fault("distance of the deepest contact of a surface", deepest, distance.distance);
  }
  // What is proven without the library.
  const Real known = found.empty() ? 0 : std::max({-deepest, -distance.distance, Real{0}});
  if (const std::optional<Real> least = least_depth(scene, found, known); least && *least > known + 2 * noise) {
    return fault("distance of the deepest contact although two parts are deeper", -known, -*least);
  }
  // Where shapes only touch, triangles are parted along many ways, and the one that parts the whole may not be found.
  if (!found.empty() && distance.distance < -noise) {
    const std::optional<Real> bound = depth_bound(scene, found);
    // What leans by a thousandth is longer by half a millionth.
    if (bound && -deepest > (1 + 1e-6) * *bound + noise) {
      return fault("distance of a contact although less parts the shapes", deepest, -*bound);
    }
  }
  return std::nullopt;
}

Verdict judge_other_routes(const Scene& scene, const Distance& found) {
  const Real noise = tolerance(scene);
  Distance other{};
  if (distance_of(scene, Algorithm::gjk_epa, other) == Outcome::ok &&
      !(std::fabs(other.distance - found.distance) <= noise) && !is_touch_of_edges(scene, found, other)) {
    return fault("distance by GJK and EPA", other.distance, found.distance);
  }
  for (const Algorithm algorithm : {Algorithm::libccd_gjk, Algorithm::libccd_mpr}) {
    if (distance_of(scene, algorithm, other) != Outcome::ok) {
      continue;
    }
    const std::optional<Real> gap = gap_along(scene, other.normal);
    if (gap && *gap > found.distance + noise) {
      return fault("distance although libccd's normal has a larger gap", found.distance, *gap);
    }
  }
  return std::nullopt;
}

Verdict judge(std::size_t place_a, std::size_t place_b, const Record& record) {
  const Result<Scene> made = make_scene(place_a, place_b, record);
  if (!made) {
    return "the scene is refused: " + made.error().message;
  }
  const Scene& scene = made.value();
  Distance found{};
  const Outcome outcome = distance_of(scene, Algorithm::automatic, found);
  if (!is_supported(place_a, place_b)) {
    return outcome == Outcome::unsupported ? Verdict() : "an unsupported pair has an answer";
  }
  // Two solids without end always overlap.
  if (outcome == Outcome::unsupported && doubt_of(scene) > 0 && is_unbounded(scene.a) && is_unbounded(scene.b)) {
    return std::nullopt;
  }
  if (outcome != Outcome::ok) {
    return "the pair has no answer";
  }
  Manifold contacts;
  if (pair_contacts(scene.a, scene.b, scene.ab, {.margin = scene.margin}, contacts) != Outcome::ok) {
    return "the pair has no contacts query";
  }
  // A depth of surfaces is that of their contacts without a margin.
  Manifold touching;
  if (pair_contacts(scene.a, scene.b, scene.ab, {}, touching) != Outcome::ok) {
    return "the pair has no contacts query without a margin";
  }
  if (Verdict verdict = judge_distance(scene, found)) {
    return verdict;
  }
  if (Verdict verdict = judge_contacts(scene, found, contacts)) {
    return verdict;
  }
  if (Verdict verdict = judge_swap(scene, found)) {
    return verdict;
  }
  if (Verdict verdict = judge_parted(scene, found)) {
    return verdict;
  }
  if (Verdict verdict = judge_scaled(place_a, place_b, record, scene, found)) {
    return verdict;
  }
  return judge_other_routes(scene, found);
}

}  // namespace abut::fuzz

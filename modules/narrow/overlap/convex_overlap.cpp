// SPDX-License-Identifier: Apache-2.0
module abut.narrow.overlap.convex_overlap;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.apart.box_cores;
import abut.narrow.apart.gjk;
import abut.narrow.apart.wide_gjk;
import abut.narrow.cores.core_separation;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;
import abut.narrow.fan.box_sat;
import abut.narrow.fan.sat;
import abut.narrow.fan.triangle_sat;
import abut.narrow.overlap.convex_side;

namespace abut {
namespace {

// What is left open is for a search with more digits.
enum class Within : std::uint8_t { no, yes, open };

// GJK (Gilbert, Johnson, Keerthi 1988) up to the first proof of either answer. support_of(direction) tells the points
// of two cores that reach furthest toward each other. `v`: the closest point of the difference so far; it leads from
// the second one to the first.
template <class SupportOf>
[[nodiscard]] Within search(const SupportOf& support_of, Real reach, Vec3& v) {
  constexpr int most_rounds = 48, most_stalls = 4;
  Simplex simplex{};
  Real square = squared_norm(v);
  int stalls = 0;
  for (int round = 0; round < most_rounds; ++round) {
    if (round > 0 && square <= reach * reach) {
      return Within::yes;
    }
    const SupportPair pair = support_of(-v);
    const Vec3 newest = pair.a - pair.b;
    const Real low = dot(v, newest);
    if (low > 0 && low * low > reach * reach * square) {
      return Within::no;
    }
    const DifferenceVertex vertex{newest, pair.a, no_index, no_index};
    if (simplex.contains(vertex)) {
      return Within::open;
    }
    const ClosestPoint closest = closest_to_origin(simplex, newest);
    simplex.push(vertex);
    if (closest.vertices == all_of_tetrahedron) {
      return Within::yes;
    }
    const Real closest_square = squared_norm(closest.point);
    if (round > 0 && !(closest_square < square) && ++stalls > most_stalls) {
      return Within::open;
    }
    keep(simplex, closest.vertices);
    v = closest.point;
    square = closest_square;
  }
  return Within::open;
}

// The same with twice the digits. Cores whose distance is not proven are within reach if the points found are.
template <class SupportOf>
[[nodiscard]] [[gnu::noinline]] bool search_wide(const SupportOf& support_of, const Vec3& toward, Real size, Real error,
                                                 Real reach) {
  Difference cores{};
  cores.support = [&support_of](const Vec3& direction) { return support_of(direction); };
  cores.size = size;
  const GjkResult found = wide_gjk(cores, toward, error, reach, error).gjk;
  return !found.beyond && (found.overlap || found.upper <= reach + error);
}

template <class SupportOf>
[[nodiscard]] bool is_within_by(const SupportOf& support_of, const Vec3& start, Real size, Real error, Real reach) {
  Vec3 closest = start;
  const Within answer = search(support_of, reach + rounding_of(size), closest);
  return answer == Within::open ? search_wide(support_of, -closest, size, error, reach) : answer == Within::yes;
}

[[nodiscard]] Real error_of(const ConvexSide& a, Real extent_b, bool is_b_curved, Real size) {
  const bool are_curved = a.is_curved || is_b_curved;
  return (are_curved ? usual_error_of_curves : usual_error) * 2 * (a.extent + extent_b) + rounding_of(size);
}

// Whether points prove the answer: the distance lies between (square - gap) / sqrt(square) and sqrt(square).
[[nodiscard]] Within judge(const NearPoints& near, Real reach) {
  if (near.square <= reach * reach) {
    return Within::yes;
  }
  const Real low = near.square - near.gap;
  return low > 0 && low * low > reach * reach * near.square ? Within::no : Within::open;
}

[[nodiscard]] Within judge_boxes(const Vec3& half_a, const Vec3& half_b, const Pose& ab, Real reach, Real size) {
  const Real noise = noise_of(size);
  const SatResult axes = sat_of_boxes(half_a, half_b, ab, noise, reach + noise);
  if (axes.separation > reach + noise) {
    return Within::no;
  }
  // All axes are there: boxes that none of them parts overlap.
  if (axes.separation <= 0 || reach == 0) {
    return Within::yes;
  }
  return judge(near_points_of_boxes(half_a, half_b, ab, rounding_of(size), 0), reach + rounding_of(size));
}

// A point or a segment along Z, placed by ab, and a box around the origin.
[[nodiscard]] Within judge_in_box(const Vec3& half, const FormOfCore& b, const Vec3& position, const Vec3& axis,
                                  Real reach, Real size) {
  const NearPoints near = b.form == CoreForm::point ? near_points_of_point(half, lanes_of(position))
                                                    : near_points_of_segment(half, lanes_of(position), lanes_of(axis),
                                                                             b.half.z, rounding_of(size));
  return judge(near, reach + rounding_of(size));
}

[[nodiscard]] Within judge_forms(const FormOfCore& a, const FormOfCore& b, const Pose& ab, Real reach) {
  const Real size = 2 * (largest_magnitude(a.half) + largest_magnitude(b.half)) + largest_magnitude(ab.position);
  if (a.form == CoreForm::box && b.form == CoreForm::box) {
    return judge_boxes(a.half, b.half, ab, reach, size);
  }
  if (b.form <= a.form) {
    return judge_in_box(a.half, b, ab.position, ab.rotation.z, reach, size);
  }
  const Pose back = ab.inverse();
  return judge_in_box(b.half, a, back.position, back.rotation.z, reach, size);
}

// A point and a core that knows its nearest one.
[[nodiscard]] std::optional<Real> distance_of_point(const ConvexSide& a, const ConvexSide& b, const Pose& ab) {
  return a.form.form == CoreForm::point   ? b.distance_to(ab.undo({0, 0, 0}))
         : b.form.form == CoreForm::point ? a.distance_to(ab.position)
                                          : std::nullopt;
}

[[nodiscard]] Real size_of(const TriangleCorners& triangle) {
  return std::fmax(std::fmax(largest_magnitude(triangle[0]), largest_magnitude(triangle[1])),
                   largest_magnitude(triangle[2]));
}
[[nodiscard]] Vec3 middle_of(const TriangleCorners& triangle) {
  return (1.0 / 3.0) * (triangle[0] + triangle[1] + triangle[2]);
}

[[nodiscard]] Vec3 support_of_triangle(const TriangleCorners& triangle, const Vec3& direction) {
  return support_of(triangle, direction).point;
}

}  // namespace

std::optional<bool> are_forms_within(const FormOfCore& a, const FormOfCore& b, const Pose& ab, Real reach) {
  if (a.form == CoreForm::other || b.form == CoreForm::other) {
    return std::nullopt;
  }
  const Within answer = judge_forms(a, b, ab, reach);
  return answer == Within::open ? std::nullopt : std::optional(answer == Within::yes);
}

bool are_cores_within(const ConvexSide& a, const ConvexSide& b, const Pose& ab, Real reach) {
  if (const std::optional<bool> answer = are_forms_within(a.form, b.form, ab, reach)) {
    return *answer;
  }
  const Vec3 centre = ab * b.centre, start = a.centre - centre;
  const Real size = 2 * (a.extent + b.extent) + largest_magnitude(a.centre) + largest_magnitude(centre);
  if (const std::optional<Real> distance = distance_of_point(a, b, ab)) {
    return *distance <= reach + rounding_of(size);
  }
  const auto support_of = [&](const Vec3& direction) {
    return SupportPair{a.support(direction), ab * b.support(ab.rotation.undo(-direction)), no_index, no_index};
  };
  return is_within_by(support_of, start, size, error_of(a, b.extent, b.is_curved, size), reach);
}

bool is_core_within(const ConvexSide& core, const TriangleCorners& triangle, Real reach) {
  const Real size = 2 * core.extent + largest_magnitude(core.centre) + size_of(triangle);
  const auto support_of = [&](const Vec3& direction) {
    return SupportPair{core.support(direction), support_of_triangle(triangle, -direction), no_index, no_index};
  };
  return is_within_by(support_of, core.centre - middle_of(triangle), size, error_of(core, size, false, size), reach);
}

bool are_triangles_within(const TriangleCorners& a, const TriangleCorners& b, Real reach) {
  const Real size = 2 * std::fmax(size_of(a), size_of(b)), noise = noise_of(size);
  if (reach == 0) {
    const Triangle first(a, 0, false), second(b, 0, false);
    if (const std::optional<SatResult> axes = triangle_sat(first, second, Pose::identity(), noise, noise)) {
      if (std::fabs(axes->separation) > noise) {
        return axes->separation < 0;
      }
    }
  }
  const auto support_of = [&](const Vec3& direction) {
    return SupportPair{support_of_triangle(a, direction), support_of_triangle(b, -direction), no_index, no_index};
  };
  return is_within_by(support_of, middle_of(a) - middle_of(b), size, usual_error * size, reach);
}

}  // namespace abut

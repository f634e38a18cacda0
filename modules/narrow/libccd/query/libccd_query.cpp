// SPDX-License-Identifier: Apache-2.0
module;
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
#include <ccd/ccd.h>
#include <ccd/quat.h>
#pragma clang diagnostic pop
module abut.narrow.libccd;
import abut.capability;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

// libccd's expanding polytope knows no limit and may go round in circles. Each point costs it as long as there are
// points already, so a query would take 30 ms. After this many support points, twice what round bodies need, it is
// shown the origin. That adds nothing to any polytope and so ends it.
constexpr std::uint32_t support_limit = 1000;
constexpr Real least_size = 1e-300;  // smaller ones have no inverse

struct Body {
  SupportFunction support;
  Vec3 centre;
  Real size;
  mutable std::uint32_t supports_asked = 0;
  // What is not a number came in or out: libccd would reach for vertices that it does not have.
  mutable bool is_lost = false;

  [[nodiscard]] bool is_over() const { return is_lost || supports_asked > support_limit; }
  [[nodiscard]] Vec3 support_toward(const Vec3& direction) const {
    ++supports_asked;
    if (is_over() || !is_finite(direction)) {
      is_lost = true;
      return {0, 0, 0};
    }
    const Vec3 point = support(direction);
    is_lost = !is_finite(point);
    return is_lost ? Vec3{0, 0, 0} : (1 / size) * point;
  }
};

Vec3 from_ccd(const ccd_vec3_t& v) { return {ccdVec3X(&v), ccdVec3Y(&v), ccdVec3Z(&v)}; }

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const Vec3 p = static_cast<const Body*>(object)->support_toward(from_ccd(*direction));
  ccdVec3Set(out, p.x, p.y, p.z);
}

void centre(const void* object, ccd_vec3_t* out) {
  const Body& body = *static_cast<const Body*>(object);
  const Vec3 p = (1 / body.size) * body.centre;
  ccdVec3Set(out, p.x, p.y, p.z);
}

}  // namespace

Outcome libccd_query(const SupportFunction& support_a, const SupportFunction& support_b, const Vec3& centre_a,
                     const Vec3& centre_b, Algorithm algorithm, Real size, Real error, Distance& out) {
  const Real unit = size > least_size ? size : 1;
  const Body a{support_a, centre_a, unit}, b{support_b, centre_b, unit};
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = centre;
  ccd.max_iterations = 500;
  ccd.epa_tolerance = error / unit;
  ccd.mpr_tolerance = error / unit;

  ccd_real_t depth = 0;
  ccd_vec3_t direction{}, position{};
  const bool mpr = algorithm == Algorithm::libccd_mpr;
  // 0 is an overlap, -1 none, -2 out of memory.
  const int found = mpr ? ccdMPRPenetration(&a, &b, &ccd, &depth, &direction, &position)
                        : ccdGJKPenetration(&a, &b, &ccd, &depth, &direction, &position);
  if (a.is_over() || b.is_over()) {
    return Outcome::not_converged;
  }
  if (found == 0) {
    const auto normal = UnitVec3::make(from_ccd(direction));
    const Vec3 middle = unit * from_ccd(position);
    if (!normal || !std::isfinite(depth) || depth < 0 || !is_finite(middle)) {
      return Outcome::not_converged;
    }
    const Real overlap = unit * depth;
    const Vec3 half = (0.5 * overlap) * normal->vec();
    // libccd promises no bounds: the interval is left open on the side that it does not know.
    out = {-overlap, -overlap, 0, middle + half, middle - half, *normal, algorithm, 0};
    return Outcome::ok;
  }
  if (found != -1) {
    return Outcome::not_converged;
  }
  return Outcome::apart;
}

}  // namespace abut

module;
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
#include <ccd/ccd.h>
#include <ccd/quat.h>
#pragma clang diagnostic pop
module abut.narrowphase.libccd;
import abut.core.standard;
import abut.math;
import abut.shape;

namespace abut {
namespace {

// libccd's expanding polytope knows no limit of its own and may go round in circles. From this many
// support points on it is shown the origin, which adds nothing to any polytope and so ends it.
constexpr std::uint32_t support_limit = 5000;

struct Body {
  SupportFunction support;
  Vec3 centre;
  mutable std::uint32_t supports_asked = 0;

  [[nodiscard]] bool is_exhausted() const { return supports_asked > support_limit; }
};

Vec3 from_ccd(const ccd_vec3_t& v) { return {ccdVec3X(&v), ccdVec3Y(&v), ccdVec3Z(&v)}; }

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const Body& body = *static_cast<const Body*>(object);
  ++body.supports_asked;
  const Vec3 p = body.is_exhausted() ? Vec3{0, 0, 0} : body.support(from_ccd(*direction));
  ccdVec3Set(out, p.x, p.y, p.z);
}

void centre(const void* object, ccd_vec3_t* out) {
  const Vec3& p = static_cast<const Body*>(object)->centre;
  ccdVec3Set(out, p.x, p.y, p.z);
}

}  // namespace

Outcome libccd_query(const SupportFunction& support_a, const SupportFunction& support_b, const Vec3& centre_a,
                     const Vec3& centre_b, Algorithm algorithm, Distance& out) {
  const Body a{support_a, centre_a}, b{support_b, centre_b};
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = centre;
  ccd.max_iterations = 500;
  ccd.epa_tolerance = 1e-9;
  ccd.mpr_tolerance = 1e-9;

  ccd_real_t depth = 0;
  ccd_vec3_t direction{}, position{};
  const bool mpr = algorithm == Algorithm::libccd_mpr;
  // 0 is an overlap, -1 none, -2 out of memory.
  const int found = mpr ? ccdMPRPenetration(&a, &b, &ccd, &depth, &direction, &position)
                        : ccdGJKPenetration(&a, &b, &ccd, &depth, &direction, &position);
  if (a.is_exhausted()) {
    return Outcome::not_converged;
  }
  if (found == 0) {
    const auto normal = UnitVec3::make(from_ccd(direction));
    const Vec3 middle = from_ccd(position);
    if (!normal || !std::isfinite(depth) || depth < 0 || !is_finite(middle)) {
      return Outcome::not_converged;
    }
    const Vec3 half = (0.5 * depth) * normal->vec();
    // libccd promises no bounds: the interval is left open on the side that it does not know.
    out = {-depth, -depth, 0, middle + half, middle - half, *normal, algorithm, 0};
    return Outcome::ok;
  }
  if (found != -1) {
    return Outcome::not_converged;
  }
  return Outcome::apart;
}

}  // namespace abut

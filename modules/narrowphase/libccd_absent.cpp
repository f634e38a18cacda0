module abut.narrowphase.libccd;
import abut.math;
import abut.shape;

namespace abut {

Outcome libccd_query(const SupportFunction&, const SupportFunction&, const Vec3&, const Vec3&, Algorithm, Real, Real,
                     Distance&) {
  return Outcome::unsupported;
}

}  // namespace abut

// GJK with twice the digits, for cores on which rounding stops the usual one: slivers and needles beside bodies that are a
// million times as large, rims and edges that almost touch. Takes some ten times as long, and is compiled once for all cores.
export module abut.narrowphase.wide_gjk;
import abut.core.standard;
import abut.math;
import abut.narrowphase.gjk;
import abut.shape;

export namespace abut {

// The points of two cores that reach furthest toward each other.
struct SupportPair {
  Vec3 a, b;
  std::uint32_t index_a, index_b;
};
// Of a along a direction and of b against it.
using SupportPairFunction = std::function<SupportPair(const Vec3& direction)>;

struct WideGjkResult {
  GjkResult gjk;
  Vec3 point_a, point_b;  // closest, of cores that are apart
};

// As gjk, from the direction `toward` on.
[[nodiscard]] WideGjkResult wide_gjk(const SupportPairFunction& support, const Vec3& toward, Real size, Real error, Real limit,
                                     Real unproven);

template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline, gnu::cold]] WideGjkResult wide_gjk(const A& a, const B& b, const Pose& ab, const Vec3& toward, Real size,
                                                                  Real error, Real limit, Real unproven) {
  const auto placement = place(b, ab);
  const auto support = [&](const Vec3& direction) {
    const SupportPoint on_a = a.support(direction), on_b = placed_support(b, placement, -direction);
    return SupportPair{on_a.point, on_b.point, on_a.index, on_b.index};
  };
  // One reference fits into the function itself: no memory is asked for.
  const SupportPairFunction function = [&support](const Vec3& direction) { return support(direction); };
  return wide_gjk(function, toward, size, error, limit, unproven);
}

}  // namespace abut

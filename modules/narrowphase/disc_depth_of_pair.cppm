// How deep a polyhedron and a cylinder or a cone overlap, of any two shapes that can be asked so.
export module abut.narrowphase.disc_depth_of_pair;
import abut.core.standard;
import abut.math;
import abut.narrowphase.core_separation;
import abut.narrowphase.disc_depth;
import abut.narrowphase.disc_depth_of_hull;
import abut.narrowphase.hull_sat_facets;
import abut.shape;

export namespace abut {

// A core that is the convex hull of two discs around Z.
template <class S>
concept HullOfDiscs = Convex<S> && requires(const S& shape) {
  { shape.discs() } -> std::same_as<Discs>;
};

template <class S>
concept TriedOnDiscs = (BoxCored<S> && S::core_axes > 0) || Faceted<S>;
template <class A, class B>
concept PolyhedronAndDiscs = (TriedOnDiscs<A> && HullOfDiscs<B>) || (HullOfDiscs<A> && TriedOnDiscs<B>);

struct ProvenDepth {
  Real depth, lower;
  Vec3 normal;  // unit, from a to b, in the frame of a
};

// Nothing where the cores hardly overlap, or no least depth is proven.
template <Convex A, Convex B>
  requires PolyhedronAndDiscs<A, B>
[[nodiscard]] std::optional<ProvenDepth> disc_depth(const A& a, const B& b, const Pose& ab, Real size, Real error) {
  const Real slack = error / 4;
  if constexpr (HullOfDiscs<B>) {
    DiscDepth least(mirrored(b.discs(), ab.position, ab.rotation.z), slack, 8 * epsilon * size);
    if constexpr (Faceted<A>) {
      if (!has_facets(a, noise_of(size))) {
        return std::nullopt;
      }
      search_facets(a, least);
    } else {
      search_box(a.half(), least);
    }
    return least.is_proven() && least.depth() > slack ? std::optional(ProvenDepth{least.depth(), least.depth() - slack, least.direction()})
                                                      : std::nullopt;
  } else {
    const std::optional<ProvenDepth> found = disc_depth(b, a, ab.inverse(), size, error);
    return found ? std::optional(ProvenDepth{found->depth, found->lower, -(ab.rotation * found->normal)}) : std::nullopt;
  }
}

}  // namespace abut

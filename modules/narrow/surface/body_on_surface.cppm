// SPDX-License-Identifier: Apache-2.0
// A convex shape on a surface: how deep it is, and where it touches.
export module abut.narrow.surface.body_on_surface;
export import abut.capability;
import abut.core.standard;
import abut.core;
export import abut.math;
export import abut.narrow.surface.bodies_on_surface;
import abut.narrow.surface.contacts_under_planes;
import abut.narrow.parts.nearest_of_parts;
import abut.narrow.surface.separating_translation;
export import abut.narrow.surface.triangle_source;

export namespace abut {

// A rod without radius may pass between two triangles, through the edge that they share, and overlap neither. The
// search gives it a radius that is less than 1e-9 of all answers, and the way that it finds is measured for the rod.
template <Convex B>
[[nodiscard]] B searched(const B& b) {
  if constexpr (SegmentCored<B>) {
    constexpr Real share = 1e-10;
    return b.radius() > 0 ? b : B(b.half().z, share * b.half().z);
  } else {
    return b;
  }
}

// The translation that was found, for the shape itself.
template <Convex B>
[[nodiscard]] SeparatingTranslation of_body(const SeparatingTranslation& found, SurfaceSearch<B>& search, const B& b) {
  if constexpr (SegmentCored<B>) {
    return b.radius() > 0 ? found : search.of_thinner(found, b);
  } else {
    return found;
  }
}

template <Convex B>
class OneOfBodies final : public BodyOnSurface {
 public:
  // Where a constructor may throw, the compiler gives memory back without its size, which no allocator of a host knows.
  OneOfBodies(const B& b, const Pose& ab, const QuerySettings& settings) noexcept
      : thick_(searched(b)), ab_(ab), settings_(settings) {}
  void gather(const TriangleSource& surface) { search_.emplace(surface, thick_, ab_, settings_, 0, surface.sides()); }

  Vec3 centre() const override { return placed_centre(thick_, ab_); }
  bool is_met() const override { return search_->is_met(); }
  TranslationSearch begin() override { return search_->begin(); }
  SurfaceExit exit_along(const Vec3& direction, Real from, Real enough) override {
    return search_->exit_along(direction, from, enough);
  }
  Obstacles& obstacles() override { return *search_; }
  Vec3 last_point(const SeparatingTranslation& translation) const override {
    return search_->last_point(translation, thick_);
  }

 private:
  B thick_;
  Pose ab_;
  QuerySettings settings_;
  std::optional<SurfaceSearch<B>> search_;
};

// A ball, which keeps nothing between questions: there may be many, and little is near one.
template <PointCored B>
class [[gsl::Pointer]] OneOfBalls final : public BodyOnSurface, public Obstacles {
 public:
  OneOfBalls(const TriangleSource& surface, const B& b, const Pose& ab, const QuerySettings& settings) noexcept
      : surface_(surface), ball_(b), ab_(ab), settings_(settings) {}

  Vec3 centre() const override { return placed_centre(ball_, ab_); }
  bool is_met() const override { return look().is_met(); }
  TranslationSearch begin() override { return look().begin(); }
  SurfaceExit exit_along(const Vec3& direction, Real from, Real enough) override {
    return look().exit_along(direction, from, enough);
  }
  SurfaceExit exit_along(const Vec3& direction, Real enough) override { return exit_along(direction, 0, enough); }
  void visit_planes(const TakePlane& take) const override { obstacles_of(look()).visit_planes(take); }
  void visit_single_ways(const TakeStart& take) const override { obstacles_of(look()).visit_single_ways(take); }
  void visit_own_directions(bool are_few, std::span<const TranslationStart> starts,
                            const TakeStart& take) const override {
    obstacles_of(look()).visit_own_directions(are_few, starts, take);
  }
  Obstacles& obstacles() override { return *this; }
  Vec3 last_point(const SeparatingTranslation& translation) const override {
    return centre() - ball_.radius() * last_touch(translation).normal;
  }

 private:
  [[nodiscard]] SurfaceSearch<B> look() const {
    return SurfaceSearch<B>(surface_, ball_, ab_, settings_, 0, surface_.sides());
  }
  [[nodiscard]] static const Obstacles& obstacles_of(const SurfaceSearch<B>& search [[clang::lifetimebound]]) {
    return search;
  }

  const TriangleSource& surface_;
  B ball_;
  Pose ab_;
  QuerySettings settings_;
};

// See surface_kernels.
template <Convex B>
void append_surface_contacts(const TriangleSource& surface, const B& b, const Pose& ab, const QuerySettings& settings,
                             Manifold& out) {
  const std::size_t first = out.size();
  const B thick = searched(b);
  [[clang::uninitialized]] SurfaceSearch<B> search(surface, thick, ab, settings, settings.margin, surface.sides());
  std::optional<SeparatingTranslation> translation;
  if (search.is_met()) {
    const SeparatingTranslation found = search.find();
    if (!found.touches.empty()) {
      translation = of_body(found, search, b);
    }
  }
  ContactsUnderPlanes<B>(surface, b, ab, settings, search, out).append(translation ? &*translation : nullptr);
  number_apart(std::span(out).subspan(first));
}

template <Convex B>
[[nodiscard]] bool find_surface_depth(const TriangleSource& surface, const B& b, const Pose& ab,
                                      const QuerySettings& settings, StoppingSides sides, Distance& out) {
  const B thick = searched(b);
  [[clang::uninitialized]] SurfaceSearch<B> search(surface, thick, ab, settings, 0, sides);
  if (!search.is_met()) {
    return false;
  }
  const SeparatingTranslation found = search.find();
  if (found.touches.empty()) {
    return false;
  }
  out = no_distance();
  const Real thickness = thick.radius() - b.radius(), length = found.length - thickness;
  out.distance = -length;
  out.lower = -length - search.tolerance();
  out.upper = -std::min(found.least - thickness, length) + search.tolerance();
  out.normal = found.direction;
  out.point_b = search.last_point(found, b);
  out.point_a = out.point_b + length * found.direction;
  out.algorithm = sides == StoppingSides::solid ? Algorithm::solid : Algorithm::separating_translation;
  out.iterations = 1;
  return true;
}
// What is met from the backs of fronts alone has no contact, and the depth that it has in a sheet.
template <Convex B>
[[nodiscard]] bool find_surface_depth(const TriangleSource& surface, const B& b, const Pose& ab,
                                      const QuerySettings& settings, Distance& out) {
  const StoppingSides sides = surface.sides();
  return find_surface_depth(surface, b, ab, settings, sides, out) ||
         (sides == StoppingSides::front && find_surface_depth(surface, b, ab, settings, StoppingSides::both, out));
}

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// Shapes against a universe: what they overlap, what is closest, and what they meet when they move.
module abut.queries;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.pairs.two_shapes.overlap;
import abut.pairs.any_shape;
import abut.queries.filter;
import abut.scene;

namespace abut {

std::vector<CastContact> cast_shape(const Scene& scene, const AnyShape& shape, const Pose& pose,
                                    const Vec3& displacement, const QueryFilter& filter, HitMode mode) {
  Hits<CastContact> hits(mode, 1);
  const auto visit_place = [&](std::uint32_t place) {
    if (hits.limit() < 0 || !admits(filter, scene, place)) {
      return;
    }
    std::optional<ShapeCastHit> hit;
    const Outcome outcome = cast_shapes(shape, pose, displacement, scene.shape_at(place), scene.world_at(place),
                                        {0, 0, 0}, {}, hits.limit(), hit);
    if (outcome == Outcome::ok && hit) {
      hits.add({scene.id_at(place), *hit}, hit->fraction);
    }
  };
  const Aabb box = aabb_of(shape, pose);
  if (!box.is_bounded()) {
    scene.visit(Aabb::everything(), visit_place);
  } else {
    const Real size = std::max(largest_magnitude(box.low), largest_magnitude(box.high));
    const Aabb reached = box.inflated(rounding_of(size + largest_magnitude(displacement)));
    scene.sweep(reached, displacement, 1, [&](std::uint32_t place, Real) {
      visit_place(place);
      return hits.limit();
    });
  }
  return hits.in_order();
}

std::vector<GeometryId> find_overlaps(const Scene& scene, const AnyShape& shape, const Pose& pose, Real margin,
                                      const QueryFilter& filter) {
  std::vector<GeometryId> found;
  Manifold contacts;
  scene.visit(aabb_of(shape, pose).inflated(std::max(margin, Real{0})), [&](std::uint32_t place) {
    if (!admits(filter, scene, place)) {
      return;
    }
    bool is_met = false;
    const Outcome outcome = pair_overlaps(shape, scene.shape_at(place), pose, scene.world_at(place), margin,
                                          OverlapRule::of_contacts, contacts, is_met);
    if (outcome == Outcome::ok && is_met) {
      found.push_back(scene.id_at(place));
    }
  });
  std::ranges::sort(found, {}, &GeometryId::slot);
  return found;
}

namespace {

struct Candidate {
  Real nearest;  // of the boxes
  std::uint32_t place;
};

Real distance_of(const Aabb& a, const Aabb& b) {
  return norm(maximum(maximum(a.low - b.high, b.low - a.high), Vec3{0, 0, 0}));
}

// Of the geometries whose boxes lie within a radius, from the nearest box on.
class Nearest {
 public:
  void search(const Scene& scene, const AnyShape& shape, const Pose& pose, Real radius, const QueryFilter& filter) {
    const Aabb box = aabb_of(shape, pose);
    std::vector<Candidate> near;
    scene.visit(box.inflated(radius), [&](std::uint32_t place) {
      if (admits(filter, scene, place)) {
        near.push_back({distance_of(box, aabb_of(scene.shape_at(place), scene.world_at(place))), place});
      }
    });
    std::ranges::sort(near, [](const Candidate& a, const Candidate& b) {
      return std::tuple(a.nearest, a.place) < std::tuple(b.nearest, b.place);
    });
    for (const Candidate& candidate : near) {
      if (best_ && candidate.nearest > std::max(best_->distance.distance, Real{0})) {
        return;
      }
      Distance distance{};
      const Outcome outcome =
          pair_distance(shape, scene.shape_at(candidate.place), pose, scene.world_at(candidate.place), {}, distance);
      // Without an upper bound nothing is there that could be met: holes took all of it.
      const bool is_there = outcome == Outcome::ok && distance.upper < infinity;
      const NearGeometry found{scene.id_at(candidate.place), distance};
      if (is_there && (!best_ || order_of(found) < order_of(*best_))) {
        best_ = found;
      }
    }
  }
  [[nodiscard]] const std::optional<NearGeometry>& best() const [[clang::lifetimebound]] { return best_; }
  [[nodiscard]] Real distance() const { return best_ ? best_->distance.distance : infinity; }

 private:
  [[nodiscard]] static std::tuple<Real, std::uint32_t> order_of(const NearGeometry& near) {
    return {near.distance.distance, near.geometry.slot};
  }
  std::optional<NearGeometry> best_;
};

}  // namespace

// The radius grows until something lies within it: no geometry is nearer than its box.
std::optional<NearGeometry> find_closest(const Scene& scene, const AnyShape& shape, const Pose& pose, Real max_distance,
                                         const QueryFilter& filter) {
  constexpr Real growth = 8;
  constexpr int most_searches = 16;
  const Aabb box = aabb_of(shape, pose);
  const Real size = box.is_bounded() ? largest_magnitude(box.high - box.low) : infinity;
  Real radius = std::max(size, 1e-6 * largest_magnitude(pose.position));
  Nearest nearest;
  for (int search = 0;; ++search) {
    radius = radius > 0 && search < most_searches ? std::min(radius, max_distance) : max_distance;
    nearest.search(scene, shape, pose, radius, filter);
    if (radius >= max_distance || nearest.distance() <= radius) {
      break;
    }
    // What is found beyond the radius bounds the next one.
    radius = std::min(growth * radius, std::max(nearest.distance(), radius));
  }
  return nearest.distance() <= max_distance ? nearest.best() : std::nullopt;
}

}  // namespace abut

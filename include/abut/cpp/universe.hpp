// SPDX-License-Identifier: Apache-2.0
// A universe, and what it can be asked. Its methods are in one header for each noun; abut_universe_step(universe, dt)
// is universe.step(dt), abut_part_set_pose(universe, part, &pose) is universe.set_pose(part, pose).
#ifndef ABUT_CPP_UNIVERSE_HPP
#define ABUT_CPP_UNIVERSE_HPP

#include <abut/abut.h>
#include <abut/cpp/universe_steps.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace abut {
inline namespace ABUT_ANSWERS {

class Universe : public UniverseSteps {
 public:
  [[nodiscard]] static Answer<Universe> create(OptionalRef<abut_universe_options> options = {}) {
    abut_universe* out = nullptr;
    const abut_status status = abut_universe_create(options.get(), &out);
    return detail::answer_with(status, [&] { return adopt(out); });
  }
  // Takes over a universe that the caller owns.
  [[nodiscard]] static Universe adopt(abut_universe* universe) noexcept { return Universe(universe); }
  // A universe from the bytes of another one: all ids name what they named there. A filter has to be set again.
  [[nodiscard]] static Answer<Universe> load(Span<const std::uint8_t> bytes) {
    abut_universe* out = nullptr;
    const abut_status status = abut_universe_load(bytes.data(), bytes.size(), &out);
    return detail::answer_with(status, [&] { return adopt(out); });
  }
  // All but the filter, the statistics and the pickers as bytes, the same on every machine.
  [[nodiscard]] Answer<std::vector<std::uint8_t>> save() const {
    return detail::collect<std::uint8_t>([this](std::uint8_t* data, std::size_t capacity, std::size_t* count) {
      return abut_universe_save(get(), data, capacity, count);
    });
  }
#ifndef ABUT_NO_EXCEPTIONS
  Universe() : Universe(create()) {}
  explicit Universe(const UniverseOptions& options) : Universe(create(options)) {}
#endif

  // The first geometry that a ray meets; with ABUT_HIT_ANY whichever is found first.
  [[nodiscard]] Answer<std::optional<QueryHit>> cast_ray(const Ray& ray, OptionalRef<abut_query_filter> filter = {},
                                                         HitMode mode = ABUT_HIT_NEAREST) const {
    QueryHit hit{};
    std::size_t count = 0;
    const abut_status status = abut_universe_cast_ray(get(), &ray, filter.get(), mode, &hit, 1, &count);
    return detail::answer_if_found(status, count, hit);
  }
  // Each geometry once, in the order in which the ray meets them.
  [[nodiscard]] Answer<std::vector<QueryHit>> cast_ray_all(const Ray& ray,
                                                           OptionalRef<abut_query_filter> filter = {}) const {
    return detail::collect<QueryHit>([&](QueryHit* data, std::size_t capacity, std::size_t* count) {
      return abut_universe_cast_ray(get(), &ray, filter.get(), ABUT_HIT_ALL, data, capacity, count);
    });
  }
  // The nearest hit of each ray; its geometry is null where there is none.
  Answer<void> cast_rays(Span<const Ray> rays, Span<QueryHit> out, OptionalRef<abut_query_filter> filter = {}) const {
    const abut_status sizes = detail::expect_as_many("out", out.size(), "rays", rays.size());
    return detail::answer(
        sizes != ABUT_OK ? sizes : abut_universe_cast_rays(get(), rays.data(), rays.size(), filter.get(), out.data()));
  }
  [[nodiscard]] Answer<std::vector<QueryHit>> cast_rays(Span<const Ray> rays,
                                                        OptionalRef<abut_query_filter> filter = {}) const {
    std::vector<QueryHit> out(rays.size());
    return detail::answer(abut_universe_cast_rays(get(), rays.data(), rays.size(), filter.get(), out.data()), out);
  }

  // The first geometry that a shape meets while it moves by a displacement without turning.
  [[nodiscard]] Answer<std::optional<CastHit>> cast_shape(const Shape& shape, const Pose& pose, Vec3 displacement,
                                                          OptionalRef<abut_query_filter> filter = {},
                                                          HitMode mode = ABUT_HIT_NEAREST) const {
    CastHit hit{};
    std::size_t count = 0;
    const abut_status status =
        abut_universe_cast_shape(get(), shape.get(), &pose, &displacement, filter.get(), mode, &hit, 1, &count);
    return detail::answer_if_found(status, count, hit);
  }
  [[nodiscard]] Answer<std::vector<CastHit>> cast_shape_all(const Shape& shape, const Pose& pose, Vec3 displacement,
                                                            OptionalRef<abut_query_filter> filter = {}) const {
    return detail::collect<CastHit>([&](CastHit* data, std::size_t capacity, std::size_t* count) {
      return abut_universe_cast_shape(get(), shape.get(), &pose, &displacement, filter.get(), ABUT_HIT_ALL, data,
                                      capacity, count);
    });
  }
  // The nearest hit of each shape; its geometry is null where there is none.
  [[nodiscard]] Answer<std::vector<CastHit>> cast_shapes(Span<const Shape> shapes, Span<const Pose> poses,
                                                         Span<const Vec3> displacements,
                                                         OptionalRef<abut_query_filter> filter = {}) const {
    const std::vector<const abut_shape*> pointers = Shape::pointers_of(shapes);
    std::vector<CastHit> out(shapes.size());
    const abut_status sizes =
        detail::first_failure(detail::expect_as_many("poses", poses.size(), "shapes", shapes.size()),
                              detail::expect_as_many("displacements", displacements.size(), "shapes", shapes.size()));
    return detail::answer(sizes != ABUT_OK
                              ? sizes
                              : abut_universe_cast_shapes(get(), pointers.data(), poses.data(), displacements.data(),
                                                          shapes.size(), filter.get(), out.data()),
                          out);
  }

  // The first geometry that a shape meets while it moves and turns.
  [[nodiscard]] Answer<std::optional<ImpactHit>> cast_movement(const Shape& shape, const Pose& pose,
                                                               const Movement& movement, double duration,
                                                               OptionalRef<abut_query_filter> filter = {},
                                                               OptionalRef<abut_impact_options> options = {},
                                                               HitMode mode = ABUT_HIT_NEAREST) const {
    ImpactHit hit{};
    std::size_t count = 0;
    const abut_status status = abut_universe_cast_movement(get(), shape.get(), &pose, &movement, duration,
                                                           options.get(), filter.get(), mode, &hit, 1, &count);
    return detail::answer_if_found(status, count, hit);
  }
  [[nodiscard]] Answer<std::vector<ImpactHit>> cast_movement_all(const Shape& shape, const Pose& pose,
                                                                 const Movement& movement, double duration,
                                                                 OptionalRef<abut_query_filter> filter = {},
                                                                 OptionalRef<abut_impact_options> options = {}) const {
    return detail::collect<ImpactHit>([&](ImpactHit* data, std::size_t capacity, std::size_t* count) {
      return abut_universe_cast_movement(get(), shape.get(), &pose, &movement, duration, options.get(), filter.get(),
                                         ABUT_HIT_ALL, data, capacity, count);
    });
  }
  // The first hit of each shape; its geometry is null where there is none.
  [[nodiscard]] Answer<std::vector<ImpactHit>> cast_movements(Span<const Shape> shapes, Span<const Pose> poses,
                                                              Span<const Movement> movements, double duration,
                                                              OptionalRef<abut_query_filter> filter = {},
                                                              OptionalRef<abut_impact_options> options = {}) const {
    const std::vector<const abut_shape*> pointers = Shape::pointers_of(shapes);
    std::vector<ImpactHit> out(shapes.size());
    const abut_status sizes =
        detail::first_failure(detail::expect_as_many("poses", poses.size(), "shapes", shapes.size()),
                              detail::expect_as_many("movements", movements.size(), "shapes", shapes.size()));
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_universe_cast_movements(get(), pointers.data(), poses.data(),
                                                                          movements.data(), shapes.size(), duration,
                                                                          options.get(), filter.get(), out.data()),
                          out);
  }

  // Geometries with which a shape has contacts up to a distance; with `out` as many as fit, and how many there are.
  [[nodiscard]] Answer<std::size_t> overlaps(const Shape& shape, const Pose& pose, double margin, Span<GeometryId> out,
                                             OptionalRef<abut_query_filter> filter = {}) const {
    std::size_t count = 0;
    return detail::answer(
        abut_universe_overlaps(get(), shape.get(), &pose, filter.get(), margin, out.data(), out.size(), &count), count);
  }
  [[nodiscard]] Answer<std::vector<GeometryId>> overlaps(const Shape& shape, const Pose& pose, double margin = 0,
                                                         OptionalRef<abut_query_filter> filter = {}) const {
    return detail::collect<GeometryId>([&](GeometryId* data, std::size_t capacity, std::size_t* count) {
      return abut_universe_overlaps(get(), shape.get(), &pose, filter.get(), margin, data, capacity, count);
    });
  }
  [[nodiscard]] Answer<GeometryLists> overlaps_of_each(Span<const Shape> shapes, Span<const Pose> poses,
                                                       double margin = 0,
                                                       OptionalRef<abut_query_filter> filter = {}) const {
    const std::vector<const abut_shape*> pointers = Shape::pointers_of(shapes);
    const abut_status sizes = detail::expect_as_many("poses", poses.size(), "shapes", shapes.size());
    return detail::collect_lists<GeometryLists>(shapes.size(), sizes, [&](GeometryLists& lists, std::size_t* count) {
      return abut_universe_overlaps_of_each(get(), pointers.data(), poses.data(), pointers.size(), filter.get(), margin,
                                            lists.offsets.data(), lists.all.data(), lists.all.size(), count);
    });
  }

  // Solids that hold a point, and surfaces that it lies on.
  [[nodiscard]] Answer<std::vector<GeometryId>> at_point(Vec3 position,
                                                         OptionalRef<abut_query_filter> filter = {}) const {
    return detail::collect<GeometryId>([&](GeometryId* data, std::size_t capacity, std::size_t* count) {
      return abut_universe_at_point(get(), &position, filter.get(), data, capacity, count);
    });
  }
  [[nodiscard]] Answer<GeometryLists> at_points(Span<const Vec3> positions,
                                                OptionalRef<abut_query_filter> filter = {}) const {
    return detail::collect_lists<GeometryLists>(
        positions.size(), ABUT_OK, [&](GeometryLists& lists, std::size_t* count) {
          return abut_universe_at_points(get(), positions.data(), positions.size(), filter.get(), lists.offsets.data(),
                                         lists.all.data(), lists.all.size(), count);
        });
  }

  // What is closest to a shape, up to a distance that may be infinite; nothing where nothing is near.
  [[nodiscard]] Answer<std::optional<Closest>> closest(const Shape& shape, const Pose& pose, double max_distance,
                                                       OptionalRef<abut_query_filter> filter = {}) const {
    Closest out{};
    std::uint32_t found = 0;
    const abut_status status =
        abut_universe_closest(get(), shape.get(), &pose, max_distance, filter.get(), &out, &found);
    return detail::answer_if_found(status, found, out);
  }
  // The same for each shape; the geometry is null where nothing is near.
  [[nodiscard]] Answer<std::vector<Closest>> closest_to_each(Span<const Shape> shapes, Span<const Pose> poses,
                                                             double max_distance,
                                                             OptionalRef<abut_query_filter> filter = {}) const {
    const std::vector<const abut_shape*> pointers = Shape::pointers_of(shapes);
    std::vector<Closest> out(shapes.size());
    const abut_status sizes = detail::expect_as_many("poses", poses.size(), "shapes", shapes.size());
    return detail::answer(sizes != ABUT_OK
                              ? sizes
                              : abut_universe_closest_to_each(get(), pointers.data(), poses.data(), shapes.size(),
                                                              max_distance, filter.get(), out.data()),
                          out);
  }

 private:
  explicit Universe(abut_universe* universe) noexcept : UniverseSteps(universe) {}
};

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif

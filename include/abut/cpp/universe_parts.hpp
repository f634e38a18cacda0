// SPDX-License-Identifier: Apache-2.0
// Parts of a universe: creating, placing, sleep and velocities.
#ifndef ABUT_CPP_UNIVERSE_PARTS_HPP
#define ABUT_CPP_UNIVERSE_PARTS_HPP

#include <abut/abut.h>
#include <abut/cpp/answer.hpp>
#include <abut/cpp/options.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace abut {
inline namespace ABUT_ANSWERS {

// Owns a universe of the C interface; moves, and is never copied.
class UniverseHandle {
 public:
  [[nodiscard]] abut_universe* get() const noexcept { return handle_.get(); }
  // Gives the universe to the caller, who destroys it.
  [[nodiscard]] abut_universe* release() noexcept { return handle_.release(); }
  explicit operator bool() const noexcept { return handle_ != nullptr; }

 protected:
  explicit UniverseHandle(abut_universe* handle) noexcept : handle_(handle) {}

 private:
  struct Destroy {
    void operator()(abut_universe* universe) const noexcept { abut_universe_destroy(universe); }
  };
  std::unique_ptr<abut_universe, Destroy> handle_;
};

// Batches take effect for all elements or for none.
class UniverseParts : public UniverseHandle {
 public:
  Answer<PartId> create_part(OptionalRef<abut_part_options> options = {}) {
    PartId out{};
    return detail::answer(abut_part_create(get(), options.get(), &out), out);
  }
  Answer<std::vector<PartId>> create_parts(Span<const abut_part_options> options) {
    std::vector<PartId> out(options.size());
    return detail::answer(abut_parts_create(get(), options.data(), options.size(), out.data()), out);
  }

  // With its geometries.
  Answer<void> destroy(PartId part) { return detail::answer(abut_part_destroy(get(), part)); }
  Answer<void> destroy(Span<const PartId> parts) {
    return detail::answer(abut_parts_destroy(get(), parts.data(), parts.size()));
  }

  Answer<void> set_pose(PartId part, const Pose& pose) {
    return detail::answer(abut_part_set_pose(get(), part, &pose));
  }
  Answer<void> set_poses(Span<const PartId> parts, Span<const Pose> poses) {
    const abut_status sizes = detail::expect_as_many("poses", poses.size(), "parts", parts.size());
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_parts_set_poses(get(), parts.data(), poses.data(), parts.size()));
  }
  [[nodiscard]] Answer<Pose> pose(PartId part) const {
    Pose out{};
    return detail::answer(abut_part_pose(get(), part, &out), out);
  }
  Answer<void> poses(Span<const PartId> parts, Span<Pose> out) const {
    const abut_status sizes = detail::expect_as_many("out", out.size(), "parts", parts.size());
    return detail::answer(sizes != ABUT_OK ? sizes : abut_parts_poses(get(), parts.data(), parts.size(), out.data()));
  }
  [[nodiscard]] Answer<std::vector<Pose>> poses(Span<const PartId> parts) const {
    std::vector<Pose> out(parts.size());
    return detail::answer(abut_parts_poses(get(), parts.data(), parts.size(), out.data()), out);
  }

  Answer<void> set_motion(PartId part, Motion motion) {
    return detail::answer(abut_part_set_motion(get(), part, motion));
  }
  Answer<void> set_motions(Span<const PartId> parts, Span<const abut_motion> motions) {
    const abut_status sizes = detail::expect_as_many("motions", motions.size(), "parts", parts.size());
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_parts_set_motions(get(), parts.data(), motions.data(), parts.size()));
  }
  [[nodiscard]] Answer<Motion> motion(PartId part) const {
    abut_motion out = ABUT_MOTION_DYNAMIC;
    const abut_status status = abut_part_motion(get(), part, &out);
    return detail::answer_with(status, [&] { return static_cast<Motion>(out); });
  }

  [[nodiscard]] Answer<std::uint64_t> user_data(PartId part) const {
    std::uint64_t out = 0;
    return detail::answer(abut_part_user_data(get(), part, &out), out);
  }
  Answer<void> set_user_data(PartId part, std::uint64_t user_data) {
    return detail::answer(abut_part_set_user_data(get(), part, user_data));
  }
  Answer<void> set_user_data(Span<const PartId> parts, Span<const std::uint64_t> user_data) {
    const abut_status sizes = detail::expect_as_many("user_data", user_data.size(), "parts", parts.size());
    return detail::answer(
        sizes != ABUT_OK ? sizes
                         : abut_parts_set_user_data(get(), parts.data(), user_data.data(), parts.size()));
  }
  // All of the universe.
  [[nodiscard]] Answer<std::vector<PartId>> parts() const {
    return detail::collect<PartId>([this](PartId* data, std::size_t capacity, std::size_t* count) {
      return abut_universe_parts(get(), data, capacity, count);
    });
  }

  // Without a Sleep the part never falls asleep by itself.
  Answer<void> set_sleep(PartId part, OptionalRef<abut_sleep> sleep) {
    return detail::answer(abut_part_set_sleep(get(), part, sleep.get()));
  }
  // One for each part, or none at all.
  Answer<void> set_sleep(Span<const PartId> parts, Span<const abut_sleep> sleeps) {
    const abut_status sizes =
        detail::expect_as_many("sleeps", sleeps.empty() ? parts.size() : sleeps.size(), "parts", parts.size());
    return detail::answer(
        sizes != ABUT_OK
            ? sizes
            : abut_parts_set_sleep(get(), parts.data(), sleeps.empty() ? nullptr : sleeps.data(), parts.size()));
  }
  [[nodiscard]] Answer<bool> is_asleep(PartId part) const {
    std::uint32_t out = 0;
    return detail::answer_bool(abut_part_is_asleep(get(), part, &out), out);
  }
  Answer<void> wake(PartId part) { return detail::answer(abut_part_wake(get(), part)); }
  Answer<void> wake(Span<const PartId> parts) {
    return detail::answer(abut_parts_wake(get(), parts.data(), parts.size()));
  }

  // Without a Velocity the part has none.
  Answer<void> set_velocity(PartId part, OptionalRef<Velocity> velocity) {
    return detail::answer(abut_part_set_velocity(get(), part, velocity.get()));
  }
  // One for each part, or none at all.
  Answer<void> set_velocities(Span<const PartId> parts, Span<const Velocity> velocities) {
    const abut_status sizes = detail::expect_as_many(
        "velocities", velocities.empty() ? parts.size() : velocities.size(), "parts", parts.size());
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_parts_set_velocities(get(), parts.data(),
                                                                       velocities.empty() ? nullptr : velocities.data(),
                                                                       parts.size()));
  }
  // From now on it follows from the poses.
  Answer<void> measure_velocity(PartId part) { return detail::answer(abut_part_measure_velocity(get(), part)); }
  Answer<void> measure_velocities(Span<const PartId> parts) {
    return detail::answer(abut_parts_measure_velocities(get(), parts.data(), parts.size()));
  }
  [[nodiscard]] Answer<PartVelocity> velocity(PartId part) const {
    Velocity out{};
    abut_velocity_source source = ABUT_VELOCITY_NONE;
    const abut_status status = abut_part_velocity(get(), part, &out, &source);
    return detail::answer_with(status, [&] { return PartVelocity{out, static_cast<VelocitySource>(source)}; });
  }
  [[nodiscard]] Answer<std::vector<Velocity>> velocities(Span<const PartId> parts) const {
    std::vector<Velocity> out(parts.size());
    return detail::answer(abut_parts_velocities(get(), parts.data(), parts.size(), out.data()), out);
  }

  // Without an Acceleration the part has none.
  Answer<void> set_acceleration(PartId part, OptionalRef<Acceleration> acceleration) {
    return detail::answer(abut_part_set_acceleration(get(), part, acceleration.get()));
  }
  // One for each part, or none at all.
  Answer<void> set_accelerations(Span<const PartId> parts, Span<const Acceleration> accelerations) {
    const std::size_t given = accelerations.empty() ? parts.size() : accelerations.size();
    const abut_status sizes = detail::expect_as_many("accelerations", given, "parts", parts.size());
    const Acceleration* const first = accelerations.empty() ? nullptr : accelerations.data();
    return detail::answer(
        sizes != ABUT_OK ? sizes : abut_parts_set_accelerations(get(), parts.data(), first, parts.size()));
  }
  [[nodiscard]] Answer<std::vector<Acceleration>> accelerations(Span<const PartId> parts) const {
    std::vector<Acceleration> out(parts.size());
    return detail::answer(abut_parts_accelerations(get(), parts.data(), parts.size(), out.data()), out);
  }

 protected:
  using UniverseHandle::UniverseHandle;
};

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif

// SPDX-License-Identifier: Apache-2.0
// abut through its C interface.
#include <abut/abut.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "abut_c_universe.hpp"
#include "universe.hpp"

namespace bench {
namespace {

class AbutWorld final : public Detector {
 public:
  AbutWorld(const World& world, std::span<const std::vector<Placement>> frames, unsigned threads, double time = 0)
      : time_(time) {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.threads = threads;
    universe_ = abut_c_universe(options);
    for (const auto& frame : frames) {
      std::vector<abut_pose>& poses = frames_.emplace_back();
      for (const Placement& placement : frame) {
        poses.push_back(abut_c_pose(placement));
      }
    }
    for (const Solid& solid : world.solids) {
      shapes_.push_back(abut_c_shape(solid));
    }
    shapes_.push_back(abut_c_shape(world.ground));
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      const AbutCBody body =
          add_abut_c_body(universe_, shapes_[world.bodies[i]], frames_.front()[i], ABUT_MOTION_DYNAMIC);
      parts_.push_back(body.part);
      geometries_.push_back(body.geometry);
    }
    add_abut_c_body(universe_, shapes_.back(), abut_c_pose(world.ground_at), ABUT_MOTION_STATIC);
  }

  void place(std::size_t frame) override {
    const std::vector<abut_pose>& poses = frames_[frame];
    expect_ok(abut_parts_set_poses(universe_.get(), parts_.data(), poses.data(), parts_.size()));
  }
  void detect() override { expect_ok(abut_universe_step(universe_.get(), time_)); }

  void follow(std::size_t share) {
    for (std::size_t i = 0; i < parts_.size(); i += share) {
      expect_ok(abut_part_measure_velocity(universe_.get(), parts_[i]));
      abut_geometry_options options;
      abut_geometry_options_init(&options, sizeof options);
      options.flags = ABUT_GEOMETRY_FAST;
      expect_ok(abut_geometry_set_options(universe_.get(), geometries_[i], &options));
    }
  }

  [[nodiscard]] Counts counts() const override {
    abut_step_stats stats;
    abut_step_stats_init(&stats, sizeof stats);
    expect_ok(abut_universe_stats(universe_.get(), &stats));
    Counts counts{stats.candidate_pairs, stats.touching_pairs, stats.contacts, 0};
    for (const Touch& touch : touches()) {
      counts.overlapping += touch.distance < 0 ? 1 : 0;
    }
    return counts;
  }

  // Geometries are created in the order of the bodies, so that slots, which count from 1, tell them.
  [[nodiscard]] std::vector<Touch> touches() const {
    const abut_contact* first = nullptr;
    std::size_t count = 0;
    expect_ok(abut_universe_contacts(universe_.get(), &first, &count));
    std::vector<abut_contact> contacts(count);
    std::copy_n(first, count, contacts.data());
    std::vector<Touch> out;
    for (const abut_contact& contact : contacts) {
      out.push_back({contact.geometry_a.slot - 1,
                     contact.geometry_b.slot - 1,
                     {contact.normal.x, contact.normal.y, contact.normal.z},
                     contact.distance});
    }
    return out;
  }

 private:
  AbutCUniverse universe_;
  std::vector<AbutCShape> shapes_;
  std::vector<abut_part_id> parts_;
  std::vector<abut_geometry_id> geometries_;
  std::vector<std::vector<abut_pose>> frames_;
  double time_;  // of a step
};

}  // namespace

void give_surface(Solid& solid) {
  if (!is_hull(solid.kind)) {
    return;
  }
  const AbutCShape shape = abut_c_shape(solid);
  std::size_t vertex_count = 0, triangle_count = 0;
  expect_ok(abut_shape_triangles(shape.get(), nullptr, 0, &vertex_count, nullptr, 0, &triangle_count));
  std::vector<double> xyz(3 * vertex_count);
  std::vector<std::uint32_t> corners(3 * triangle_count);
  expect_ok(abut_shape_triangles(shape.get(), xyz.data(), vertex_count, &vertex_count, corners.data(), triangle_count,
                                 &triangle_count));
  solid.points.clear();
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    solid.points.push_back({xyz[i], xyz[i + 1], xyz[i + 2]});
  }
  solid.triangles.clear();
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    solid.triangles.push_back(
        {static_cast<int>(corners[i]), static_cast<int>(corners[i + 1]), static_cast<int>(corners[i + 2])});
  }
}

std::unique_ptr<Detector> make_abut_world(const World& world, unsigned threads) {
  return std::make_unique<AbutWorld>(world, world.frames, threads);
}

std::unique_ptr<Detector> make_abut_world_of_fast(const World& world, bool follows) {
  auto detector = std::make_unique<AbutWorld>(world, world.frames, 1, 1.0 / 60);
  if (follows) {
    detector->follow(world.fast_share);
  }
  return detector;
}

std::vector<Touch> touches(const World& world, std::span<const Placement> placements) {
  const std::vector<std::vector<Placement>> frames{{placements.begin(), placements.end()}};
  AbutWorld detector(world, frames, 1);
  detector.detect();
  return detector.touches();
}

}  // namespace bench

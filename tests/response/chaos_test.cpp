// SPDX-License-Identifier: Apache-2.0
// Random scenes whose kinds, rules, links and bodies change at any time: all stays finite, or is refused by name.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

class Chaos {
 public:
  explicit Chaos(unsigned seed)
      : random_(seed), scene_([&](abut_response_options& its) {
          its.solver = pick(std::array{ABUT_SOLVER_NEWTON, ABUT_SOLVER_SWEEPS});
          its.threads = pick(std::array{1U, 3U});
        }) {
    scene_.floor();
    for (int i = 0; i < 8; ++i) add_body();
  }

  void run(int steps) {
    for (int i = 0; i < steps; ++i) {
      change();
      const double dt = std::pow(10, pick(std::array{-4.0, -2.0, -1.5}));
      const abut_status status = abut_response_step(scene_.response(), dt);
      // Numbers too far apart are told; bodies are then where they were.
      ASSERT_TRUE(status == ABUT_OK || status == ABUT_NOT_CONVERGED || status == ABUT_OUT_OF_RANGE)
          << status << " " << abut_last_error_message();
      const abut_energy energy = scene_.energy();
      ASSERT_TRUE(std::isfinite(energy.kinetic) && std::isfinite(energy.potential));
      for (const abut_response_island& island : scene_.islands())
        ASSERT_TRUE(std::isfinite(island.residuals.contact) && std::isfinite(island.residuals.motion));
      bring_back();
    }
  }

 private:
  template <class List>
  typename List::value_type pick(const List& list) {
    return list.at(random_() % list.size());
  }
  double any(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  void add_body() {
    const Shape shape = random_() % 2 == 0 ? ball(any(0.1, 0.6)) : block(any(0.1, 0.6), any(0.1, 0.6), any(0.1, 0.6));
    const abut_pose pose{{any(-1, 1), any(-1, 1), any(0.2, 2)}, no_turn};
    parts_.push_back(
        scene_.body(shape, pose, std::pow(10, any(-6, 6)), {{any(-1, 1), any(-1, 1), 0}, {0, any(-3, 3), 0}}));
  }

  void change() {
    abut_response* const its = scene_.response();
    switch (random_() % 8) {
      case 0: {
        const std::string parameters = "mu=" + pick(std::array<std::string, 4>{"0", "0.3", "1", "1e6"}) +
                                       "&d=" + pick(std::array<std::string, 3>{"0", "10", "1e20"}) +
                                       "&adhesion=" + pick(std::array<std::string, 2>{"0", "5"}) + "&break=30" +
                                       pick(std::array<std::string, 5>{"", "&k=1", "&k=1e4", "&k=1e12", "&k=1e30"});
        const char* kind = pick(std::array{"friction", "penalty", "augmented", "stick", "slide", "none"});
        abut_response_side side{ABUT_RESPONSE_SIDE_ANY, 0, 0};
        if (random_() % 2 == 0) {
          const abut_part_id part = pick(parts_);
          side = {ABUT_RESPONSE_SIDE_PART, part.slot, part.generation};
        }
        if (random_() % 3 == 0) require(abut_response_clear_rules(its));
        require(abut_response_add_rule(its, &side, nullptr, kind, parameters.c_str(), nullptr));
        break;
      }
      case 1: {
        abut_link_options options;
        abut_link_options_init(&options, sizeof options);
        const abut_part_id a = pick(parts_), b = pick(parts_);
        if (random_() % 2 == 0) options.a = a;
        options.b = b;
        options.point_a = scene_.pose(a).position;
        options.point_b = scene_.pose(b).position;
        options.stiffness = pick(std::array{0.0, 1e2, 1e9});
        options.most_force = pick(std::array{0.0, 20.0});
        options.break_force = pick(std::array{0.0, 50.0});
        std::uint64_t number = 0;
        if (a.slot != b.slot) require(abut_response_add_link(its, &options, &number));
        links_.push_back(number);
        break;
      }
      case 2: static_cast<void>(abut_response_remove_link(its, links_.empty() ? 0 : pick(links_))); break;
      case 3: {
        abut_body_options options;
        abut_body_options_init(&options, sizeof options);
        const abut_part_id part = pick(parts_);
        require(abut_response_body(its, part, &options.mass));
        options.integrator = pick(std::array{ABUT_INTEGRATOR_STATIC, ABUT_INTEGRATOR_RK4, ABUT_INTEGRATOR_MIDPOINT,
                                             ABUT_INTEGRATOR_IMPLICIT});
        require(abut_response_add_bodies(its, &part, 1, &options));
        break;
      }
      case 4:
        require(abut_part_destroy(scene_.universe(), parts_.front()));
        parts_.erase(parts_.begin());
        add_body();
        break;
      default: break;
    }
  }

  // What explicit springs or the push apart have thrown far away.
  void bring_back() {
    for (const abut_part_id part : parts_) {
      const abut_pose at = scene_.pose(part);
      const abut_velocity velocity = scene_.velocity(part);
      if (std::fabs(at.position.x) + std::fabs(at.position.y) + std::fabs(at.position.z) < 50 &&
          std::fabs(velocity.linear.x) + std::fabs(velocity.linear.z) + std::fabs(velocity.angular.x) < 1e3)
        continue;
      const abut_pose start{{any(-1, 1), any(-1, 1), 2}, no_turn};
      const abut_velocity rest{};
      require(abut_part_set_pose(scene_.universe(), part, &start));
      require(abut_part_set_velocity(scene_.universe(), part, &rest));
    }
  }

  std::mt19937 random_;
  Scene scene_;
  std::vector<abut_part_id> parts_;
  std::vector<std::uint64_t> links_;
};

TEST(Chaos, StaysFinite) {
  const char* const given = std::getenv("ABUT_SEED");
  const unsigned seed = given == nullptr ? std::random_device()() : static_cast<unsigned>(std::stoul(given));
  std::printf("ABUT_SEED=%u\n", seed);
  for (unsigned i = 0; i < 20; ++i) {
    Chaos chaos(seed + i);
    chaos.run(60);
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << seed << " " << i;
  }
}

}  // namespace

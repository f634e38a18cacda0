// SPDX-License-Identifier: Apache-2.0
// Bodies that rest, roll and slide on flat grounds of every kind while their poses tremble: how often contacts come and
// go, how often they get new ids, how far normals lean, and how far bodies drift from the closed form.
#include <abut/response.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "flags.hpp"
#include "scene.hpp"
#include "steadiness_grounds.hpp"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* usage = R"(usage: abut_bench_steadiness --json FILE [--steps N] [--only TEXT]

Writes what contacts did over the steps, for each ground, body, motion and jitter.
  --steps N     of each run; bodies that move go the same way in any number (10000)
  --only TEXT   only runs with this in their name, such as "plane/ball/rolling"
)";

// Which way bodies go: askew to all edges of the grounds.
constexpr Point along{0.96, 0.28, 0}, across{-0.28, 0.96, 0};
constexpr double dt = 1e-3, way = 2.5;

struct Body {
  std::string name, motion;
  abut::Shape shape;
  double height;  // of its origin at rest
  Point axis;     // where its local Z points
  double speed;   // as a part of the way by the time
  double radius;  // on which it rolls; 0 where it slides
  double friction;
};

std::vector<Body> bodies() {
  const abut::Shape ball = abut::Shape::sphere(0.5), box = abut::Shape::box(0.4, 0.3, 0.2),
                    capsule = abut::Shape::capsule(0.25, 0.4);
  const Point up{0, 0, 1};
  return {{"ball", "resting", ball, 0.5, up, 0, 0, 0.5},
          {"box", "resting", box, 0.2, up, 0, 0, 0.5},
          {"capsule", "resting", capsule, 0.25, along, 0, 0, 0.5},
          {"ball", "rolling", ball, 0.5, up, 1, 0.5, 0.5},
          {"capsule", "rolling", capsule, 0.25, across, 1, 0.25, 0.5},
          {"ball", "sliding", ball, 0.5, up, 1, 0, 0},
          {"box", "sliding", box, 0.2, up, 1, 0, 0},
          {"capsule", "sliding", capsule, 0.25, along, 1, 0, 0}};
}

struct Jitter {
  std::string_view name;
  double size;  // below 0: to a neighbouring number
};
constexpr std::array jitters{Jitter{"0", 0}, Jitter{"1 ulp", -1}, Jitter{"1e-9", 1e-9}, Jitter{"1e-6", 1e-6}};

class Trembling {
 public:
  explicit Trembling(double size) : size_(size) {}

  // The trembling of the step before is taken back.
  [[nodiscard]] abut::Pose next(abut::Pose pose) {
    const std::array<double*, 3> coordinates{&pose.position.x, &pose.position.y, &pose.position.z};
    for (std::size_t i = 0; i < 3; ++i) {
      double& value = *coordinates.at(i);
      const double calm = value - last_.at(i);
      const double moved =
          size_ < 0 ? std::nextafter(calm, random_.below(2) == 0 ? 1e9 : -1e9) : calm + size_ * random_.uniform(-1, 1);
      last_.at(i) = moved - calm;
      value = moved;
    }
    return pose;
  }
  [[nodiscard]] const Point& last() const { return last_; }

 private:
  double size_;
  Point last_{};
  Random random_{7};
};

struct Seen {
  std::size_t lost = 0, flicker = 0, fresh = 0, contacts = 0, count = 0;
  double lean = 0, drift = 0;

  void add(const abut::Span<const abut::Contact>& list, bool is_first) {
    lost += list.empty() ? 1 : 0;
    flicker += !is_first && list.size() != count ? 1 : 0;
    count = list.size();
    for (const abut::Contact& contact : list) {
      ++contacts;
      fresh += !is_first && contact.age == 0 ? 1 : 0;
      lean = std::max(lean, std::hypot(contact.normal.x, contact.normal.y));
    }
  }
};

abut::Quat turn_to(const Point& axis) {
  // From local Z the shorter way.
  const double w = std::sqrt((1 + axis[2]) / 2);
  return {w, -axis[1] / (2 * w), axis[0] / (2 * w), 0};
}

Json run(const Ground& ground, const Body& body, const Jitter& jitter, std::size_t steps) {
  abut::Universe universe(abut::UniverseOptions().with_tolerance_mode(ABUT_TOLERANCE_MARGIN));
  abut::Response response(universe);
  const abut::GeometryOptions touching = abut::GeometryOptions().with_tolerance(1e-3);
  const abut::PartId floor = universe.create_part(abut::PartOptions().with_motion(ABUT_MOTION_STATIC));
  for (std::size_t i = 0; i < ground.shapes.size(); ++i) {
    universe.create_geometry(floor, ground.shapes[i], touching.with_pose(ground.poses[i]));
  }
  universe.set_material_pair(0, 0, abut::ContactMaterial().with_friction(body.friction, body.friction));
  const double speed = body.speed * way / (static_cast<double>(steps) * dt);
  const Point start{-0.5 * way * body.speed * along[0] + 0.1, -0.5 * way * body.speed * along[1] + 0.1, body.height};
  const abut::PartId part =
      universe.create_part(abut::PartOptions().with_pose({{start[0], start[1], start[2]}, turn_to(body.axis)}));
  universe.create_geometry(part, body.shape, touching);
  response.add_body(part, abut::BodyOptions());
  const double turning = body.radius > 0 ? speed / body.radius : 0;
  universe.set_velocity(
      part, abut::Velocity{{speed * along[0], speed * along[1], 0}, {-turning * along[1], turning * along[0], 0}});
  Trembling trembling(jitter.size);
  Seen seen;
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < steps; ++i) {
    universe.set_pose(part, trembling.next(universe.pose(part)));
    response.step(dt);
    const abut::Span<const abut::Contact> contacts = universe.contacts();
    seen.add(contacts, i == 0);
    const abut::Vec3 now = abut::Pose(universe.pose(part)).position;
    const double far = speed * dt * static_cast<double>(i + 1);
    const Point& shaken = trembling.last();
    seen.drift =
        std::max(seen.drift, std::hypot(now.x - shaken[0] - start[0] - far * along[0],
                                        now.y - shaken[1] - start[1] - far * along[1], now.z - shaken[2] - start[2]));
  }
  const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - begin;
  const auto all = static_cast<double>(steps);
  return {{"ground", ground.name},
          {"body", body.name},
          {"motion", body.motion},
          {"jitter", std::string(jitter.name)},
          {"lost", static_cast<double>(seen.lost) / all},
          {"flicker", static_cast<double>(seen.flicker) / all},
          {"churn", static_cast<double>(seen.fresh) / static_cast<double>(std::max<std::size_t>(seen.contacts, 1))},
          {"lean", seen.lean},
          {"drift", seen.drift},
          {"microseconds", spent.count() / all}};
}

void run_all(const std::vector<std::string>& words) {
  std::filesystem::path path;
  std::string only;
  std::size_t steps = 10'000;
  for (const auto& [name, value] : flags_of(words, usage)) {
    if (name == "--json") {
      path = value;
    } else if (name == "--steps") {
      steps = count_of(name, value);
    } else if (name == "--only") {
      only = value;
    } else {
      refuse(name, usage);
    }
  }
  if (path.empty()) {
    throw std::runtime_error(std::string("--json is missing\n") + usage);
  }
  Json rows = Json::array();
  for (const Ground& ground : flat_grounds()) {
    std::fprintf(stderr, "%s\n", ground.name.c_str());
    for (const Body& body : bodies()) {
      if ((ground.name + "/" + body.name + "/" + body.motion).find(only) == std::string::npos) {
        continue;
      }
      for (const Jitter& jitter : jitters) {
        rows.push_back(run(ground, body, jitter, steps));
      }
    }
  }
  std::ofstream file(path);
  file << Json{{"steps", steps}, {"dt", dt}, {"rows", std::move(rows)}}.dump() << '\n';
  if (!file.flush()) {
    throw std::runtime_error(path.string() + " cannot be written");
  }
}

}  // namespace
}  // namespace bench

int main(int count, char** words) { return bench::main_of(count, words, bench::usage, bench::run_all); }

// SPDX-License-Identifier: Apache-2.0
#include "conformance.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <utility>

#include "support.hpp"
#include "truth.hpp"

namespace backend {
namespace {

using abut_test::require;
using Pair = std::pair<std::uint32_t, std::uint32_t>;  // of slots

struct Body {
  Solid solid;
  abut_motion motion = ABUT_MOTION_DYNAMIC;
};
struct Setting {
  std::string name;
  std::vector<Body> bodies;
  double margin = 0;
};

Solid ball(double radius, const abut_pose& pose) { return {Form::ball, {radius, 0, 0}, pose}; }
Solid block(double x, double y, double z, const abut_pose& pose) { return {Form::block, {x, y, z}, pose}; }

// About the axis (1, 2, 3).
abut_quat turned(double angle) {
  const double share = std::sin(angle / 2) / std::sqrt(14.0);
  return {std::cos(angle / 2), share, 2 * share, 3 * share};
}

// Bodies of all forms in a room that is too small for them.
Setting crowd(std::uint32_t seed, double margin) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1.5, 1.5), size(0.2, 0.4), angle(0, 6);
  Setting setting{"crowd of seed " + std::to_string(seed) + ", margin " + std::to_string(margin), {}, margin};
  for (int i = 0; i < 45; ++i) {
    const abut_pose pose{{place(random), place(random), place(random)}, turned(angle(random))};
    const double first = size(random), second = size(random), third = size(random);
    const auto form = static_cast<Form>(i % 3);
    setting.bodies.push_back({{form, {first, second, third}, pose}, ABUT_MOTION_DYNAMIC});
  }
  return setting;
}

std::vector<Setting> settings() {
  using abut_test::at;
  return {{"two balls", {{ball(0.5, at(0, 0, 0))}, {ball(0.5, at(0.9, 0.1, 0))}}},
          {"two balls apart", {{ball(0.5, at(0, 0, 0))}, {ball(0.5, at(0.7, 0.72, 0))}}},
          {"two balls within the margin", {{ball(0.5, at(0, 0, 0))}, {ball(0.5, at(1.05, 0, 0))}}, 0.1},
          {"a ball on a block", {{block(1, 1, 0.5, at(0, 0, 0)), ABUT_MOTION_STATIC}, {ball(0.5, at(0.3, 0.2, 0.98))}}},
          {"a block on a block",
           {{block(1, 1, 0.5, at(0, 0, 0)), ABUT_MOTION_STATIC}, {block(0.3, 0.3, 0.3, at(0.3, 0.2, 0.79))}}},
          {"a capsule on a block",
           {{block(1, 1, 0.5, at(0, 0, 0)), ABUT_MOTION_STATIC},
            {{Form::capsule, {0.25, 0.4, 0}, {{0, 0, 0.74}, {std::sqrt(0.5), 0, std::sqrt(0.5), 0}}}}}},
          crowd(1, 0),
          crowd(2, 0),
          crowd(3, 0.1)};
}

abut_test::Shape shape_of(const Solid& solid) {
  switch (solid.form) {
    case Form::ball: return abut_test::make_sphere(solid.sizes[0]);
    case Form::capsule: return abut_test::make_capsule(solid.sizes[0], solid.sizes[1]);
    case Form::block: return abut_test::make_box(solid.sizes[0], solid.sizes[1], solid.sizes[2]);
  }
  return {};
}

abut_universe_options options_of(const Setting& setting, std::uint32_t threads = 1) {
  abut_universe_options options = abut_test::default_universe_options();
  options.tolerance_mode = setting.margin > 0 ? ABUT_TOLERANCE_MARGIN : ABUT_TOLERANCE_DEAD_BAND;
  options.threads = threads;
  options.max_contacts = 0;
  return options;
}

// A universe of a setting, whose slots are the places of the bodies, from 1 on. Counts how often its detector is asked.
class World {
 public:
  World(const Setting& setting, const Detector* detector, std::uint32_t threads = 1)
      : bodies_(setting.bodies), options_(options_of(setting, threads)), universe_(&options_) {
    for (const Body& body : bodies_) {
      parts_.push_back(universe_.add_part(body.solid.pose, body.motion));
      geometries_.push_back(universe_.add_geometry(parts_.back(), shape_of(body.solid), setting.margin / 2));
    }
    if (detector == nullptr) return;
    detector_ = *detector;
    require(abut_backend_set(universe_, detector_.accepts == nullptr ? nullptr : accepts, find, this));
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() = default;

  std::vector<abut_contact> step() {
    calls = asked = 0;
    return universe_.step();
  }
  void move(std::size_t body, const abut_pose& pose) {
    bodies_.at(body).solid.pose = pose;
    universe_.move(parts_.at(body), pose);
  }
  const Solid& solid(std::uint32_t slot) const { return bodies_.at(slot - 1).solid; }
  std::size_t size() const { return bodies_.size(); }
  abut_test::Universe& universe() { return universe_; }

  int calls = 0;
  std::size_t asked = 0;

 private:
  static std::uint32_t accepts(void* context, abut_shape_kind a, abut_shape_kind b) {
    const Detector& detector = static_cast<World*>(context)->detector_;
    return detector.accepts(detector.context, a, b);
  }
  static void find(void* context, abut_universe* universe, const abut_backend_pair* pairs, std::size_t count) {
    auto& world = *static_cast<World*>(context);
    ++world.calls;
    world.asked += count;
    world.detector_.find(world.detector_.context, universe, pairs, count);
  }

  std::vector<Body> bodies_;
  abut_universe_options options_;
  abut_test::Universe universe_;
  std::vector<abut_part_id> parts_;
  std::vector<abut_geometry_id> geometries_;
  Detector detector_{};
};

// The least distance of the contacts of each pair.
std::map<Pair, double> deepest_of(const std::vector<abut_contact>& contacts) {
  std::map<Pair, double> deepest;
  for (const abut_contact& its : contacts) {
    const auto [found, is_new] = deepest.try_emplace({its.geometry_a.slot, its.geometry_b.slot}, its.distance);
    if (!is_new) found->second = std::min(found->second, its.distance);
  }
  return deepest;
}

class Judge {
 public:
  explicit Judge(const Detector& detector) : detector_(detector) {}

  void look_at(const Setting& setting) {
    setting_ = setting.name;
    World world(setting, &detector_);
    const std::vector<abut_contact> contacts = world.step();
    expect(world.calls == 1, "the detector was not asked once");
    look_at_pairs(setting, world, contacts);
    for (const abut_contact& contact : contacts) look_at_contact(world, contact);
    look_at_rest(world, contacts);
    look_at_small_motion(world, contacts);
    look_at_threads(setting);
    look_at_order(setting, contacts);
    look_at_end(world);
  }
  std::vector<std::string> shortfalls() && { return std::move(shortfalls_); }

 private:
  template <class... Words>
  void expect(bool is_right, const Words&... words) {
    if (is_right) return;
    std::ostringstream sentence;
    sentence << detector_.name << ", " << setting_ << ": ";
    (sentence << ... << words);
    shortfalls_.push_back(sentence.str());
  }

  // Who touches, and how deep.
  void look_at_pairs(const Setting& setting, const World& world, const std::vector<abut_contact>& contacts) {
    const std::map<Pair, double> deepest = deepest_of(contacts);
    for (std::uint32_t low = 1; low <= world.size(); ++low) {
      for (std::uint32_t high = low + 1; high <= world.size(); ++high) {
        const Truth truth = truth_of(world.solid(low), world.solid(high));
        const auto found = deepest.find({low, high});
        const double beyond = truth.distance - setting.margin;
        const bool is_sure = truth.is_exact || truth.distance < 0;
        if (beyond > detector_.error) {
          expect(found == deepest.end(), "slots ", low, " and ", high, " have contacts and are ", truth.distance,
                 " apart");
        } else if (beyond < -detector_.error && is_sure) {
          expect(found != deepest.end(), "slots ", low, " and ", high, " have no contact at ", truth.distance);
        }
        if (found != deepest.end() && truth.is_exact) {
          expect(std::fabs(found->second - truth.distance) <= detector_.error, "slots ", low, " and ", high, " are at ",
                 truth.distance, ", the contacts say ", found->second);
        }
      }
    }
  }

  // The record by itself, and where its points lie.
  void look_at_contact(const World& world, const abut_contact& contact) {
    const std::uint32_t a = contact.geometry_a.slot, b = contact.geometry_b.slot;
    expect(a < b, "slot ", a, " comes before ", b);
    expect(abut_contact_validate(&contact) == ABUT_OK, "a record is wrong: ", abut_last_error_message());
    const double at_a = distance_of(world.solid(a), contact.point_a),
                 at_b = distance_of(world.solid(b), contact.point_b);
    expect(std::fabs(at_a) <= detector_.error, "point_a of slots ", a, " and ", b, " is ", at_a, " off its surface");
    expect(std::fabs(at_b) <= detector_.error, "point_b of slots ", a, " and ", b, " is ", at_b, " off its surface");
  }

  // Nothing moves: the same contacts, a step older, and nobody is asked.
  void look_at_rest(World& world, const std::vector<abut_contact>& before) {
    const std::vector<abut_contact> contacts = world.step();
    expect(world.calls == 0, "the detector was asked of ", world.asked, " pairs at rest");
    bool is_same = contacts.size() == before.size();
    for (std::size_t i = 0; is_same && i < contacts.size(); ++i) {
      is_same = contacts[i].id == before[i].id && contacts[i].distance == before[i].distance && contacts[i].age == 1;
    }
    expect(is_same, "contacts at rest change");
  }

  // All bodies move by less than they are exact: pairs that have as many contacts as before have the same ids.
  void look_at_small_motion(World& world, const std::vector<abut_contact>& before) {
    for (std::size_t i = 0; i < world.size(); ++i) {
      abut_pose pose = world.solid(static_cast<std::uint32_t>(i + 1)).pose;
      pose.position.x += i % 2 == 0 ? 1e-7 : -1e-7;
      world.move(i, pose);
    }
    std::map<Pair, std::multiset<std::uint64_t>> old_ids, new_ids;
    for (const abut_contact& its : before) old_ids[{its.geometry_a.slot, its.geometry_b.slot}].insert(its.id);
    for (const abut_contact& its : world.step()) new_ids[{its.geometry_a.slot, its.geometry_b.slot}].insert(its.id);
    std::size_t kept = 0, compared = 0;
    for (const auto& [pair, ids] : new_ids) {
      const auto found = old_ids.find(pair);
      if (found == old_ids.end() || found->second.size() != ids.size()) continue;
      ++compared;
      kept += found->second == ids ? 1 : 0;
      expect(std::set<std::uint64_t>(ids.begin(), ids.end()).size() == ids.size(), "an id occurs twice in a pair");
    }
    expect(10 * kept >= 9 * compared, kept, " of ", compared, " pairs keep their ids");
  }

  // As many threads as the build has: the same bits.
  void look_at_threads(const Setting& setting) {
    World one(setting, &detector_), four(setting, &detector_, abut_test::threads_of_build(4));
    one.step();
    four.step();
    expect(one.universe().hash() == four.universe().hash(), "threads change the contacts");
  }

  // Bodies in the other order: a and b of each pair change places.
  void look_at_order(const Setting& setting, const std::vector<abut_contact>& before) {
    Setting turned_round = setting;
    std::reverse(turned_round.bodies.begin(), turned_round.bodies.end());
    World world(turned_round, &detector_);
    const auto last = static_cast<std::uint32_t>(setting.bodies.size() + 1);
    std::map<Pair, double> mirrored;
    for (const auto& [pair, depth] : deepest_of(world.step())) {
      mirrored[{last - pair.second, last - pair.first}] = depth;
    }
    for (const auto& [pair, depth] : deepest_of(before)) {
      const auto found = mirrored.find(pair);
      if (found != mirrored.end()) {
        expect(std::fabs(found->second - depth) <= 2 * detector_.error, "the order changes the depth of slots ",
               pair.first, " and ", pair.second, " from ", depth, " to ", found->second);
      } else {
        expect(depth >= setting.margin - 2 * detector_.error, "the order takes the contacts of slots ", pair.first,
               " and ", pair.second);
      }
    }
  }

  // The first body goes far away: its pairs end, and no others.
  void look_at_end(World& world) {
    std::set<Pair> ended;
    for (const auto& [pair, depth] : deepest_of(world.universe().contacts())) {
      if (pair.first == 1) ended.insert(pair);
    }
    world.move(0, abut_test::at(100, 0, 0));
    world.step();
    std::set<Pair> told;
    for (const abut_event& event : world.universe().events()) {
      if (event.kind == ABUT_EVENT_END && (event.flags & ABUT_EVENT_CONTACT) == 0) {
        told.emplace(event.geometry_a.slot, event.geometry_b.slot);
      }
    }
    expect(told == ended, told.size(), " pairs ended in place of ", ended.size());
  }

  const Detector& detector_;
  std::string setting_;
  std::vector<std::string> shortfalls_;
};

}  // namespace

std::vector<std::string> shortfalls_of(const Detector& detector) {
  Judge judge(detector);
  for (const Setting& setting : settings()) judge.look_at(setting);
  return std::move(judge).shortfalls();
}

}  // namespace backend

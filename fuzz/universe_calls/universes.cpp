// SPDX-License-Identifier: Apache-2.0
#include "universes.hpp"

#include <algorithm>
#include <bit>
#include <iterator>

namespace universe_calls {
namespace {

void expect_ok(abut_status status, const char* call) {
  require(status == ABUT_OK,
          std::string(call) + " answered " + abut_status_name(status) + ": " + abut_last_error_message());
}

template <class Value>
bool has_same_bits(const Value& a, const Value& b) {
  using Bytes = std::array<unsigned char, sizeof(Value)>;
  return std::bit_cast<Bytes>(a) == std::bit_cast<Bytes>(b);
}

template <class Value>
bool has_same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return std::ranges::equal(a, b, [](const Value& x, const Value& y) { return has_same_bits(x, y); });
}

// Owns the shapes until the program ends.
class ShapeList {
 public:
  ShapeList() {
    for (int i = 0; i < 27; ++i) {
      const Triple half{1 + i % 3, 1 + i / 3 % 3, 1 + i / 9};
      abut_shape* shape = nullptr;
      expect_ok(abut_box_create(half[0], half[1], half[2], &shape), "abut_box_create");
      shapes_.push_back({shape, true, half});
    }
    // A build may be without the others.
    const abut_vec3 up{0, 0, 1};
    const std::array<double, 12> corners{-1, -1, -1, 2, 0, 0, 0, 2, 0, 0, 0, 2};
    add("sphere", [](abut_shape** out) { return abut_sphere_create(1.5, out); });
    add("capsule", [](abut_shape** out) { return abut_capsule_create(0.75, 1.25, out); });
    add("plane", [&](abut_shape** out) { return abut_plane_create(&up, -2, out); });
    add("hull", [&](abut_shape** out) { return abut_hull_create(corners.data(), corners.size() / 3, out); });
  }
  ~ShapeList() {
    for (const Shape& its : shapes_) {
      abut_shape_release(its.shape);
    }
  }
  ShapeList(const ShapeList&) = delete;
  ShapeList& operator=(const ShapeList&) = delete;

  const std::vector<Shape>& all() const { return shapes_; }

 private:
  template <class Create>
  void add(const char* kind, Create&& create) {
    if (abut_shape_kind_by_name(kind) != 0) {
      abut_shape* shape = nullptr;
      expect_ok(create(&shape), kind);
      shapes_.push_back({shape, false, {}});
    }
  }

  std::vector<Shape> shapes_;
};

}  // namespace

const std::vector<Shape>& shapes() {
  static const ShapeList list;
  return list.all();
}

Found found_in(const abut_universe* universe) {
  Found found;
  const abut_contact* contacts = nullptr;
  const abut_event* events = nullptr;
  std::size_t count = 0;
  expect_ok(abut_universe_contacts(universe, &contacts, &count), "abut_universe_contacts");
  std::copy_n(contacts, count, std::back_inserter(found.contacts));
  expect_ok(abut_universe_events(universe, &events, &count), "abut_universe_events");
  std::copy_n(events, count, std::back_inserter(found.events));
  abut_step_stats_init(&found.stats, sizeof found.stats);
  expect_ok(abut_universe_stats(universe, &found.stats), "abut_universe_stats");
  expect_ok(abut_universe_hash(universe, &found.hash), "abut_universe_hash");
  return found;
}

Snapshot snapshot_of(const abut_universe* universe) {
  Snapshot all;
  std::size_t count = 0;
  expect_ok(abut_universe_parts(universe, nullptr, 0, &count), "abut_universe_parts");
  all.parts.resize(count);
  expect_ok(abut_universe_parts(universe, all.parts.data(), count, &count), "abut_universe_parts");
  all.poses.resize(count);
  expect_ok(abut_parts_poses(universe, all.parts.data(), count, all.poses.data()), "abut_parts_poses");
  for (const abut_part_id part : all.parts) {
    expect_ok(abut_part_motion(universe, part, &all.motions.emplace_back()), "abut_part_motion");
  }
  expect_ok(abut_universe_geometries(universe, nullptr, 0, &count), "abut_universe_geometries");
  all.geometries.resize(count);
  expect_ok(abut_universe_geometries(universe, all.geometries.data(), count, &count), "abut_universe_geometries");
  for (const abut_geometry_id geometry : all.geometries) {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    expect_ok(abut_geometry_describe(universe, geometry, &info), "abut_geometry_describe");
    all.infos.push_back(info);
  }
  // The tags that sequences use.
  for (std::uint32_t a = 0; a < 3; ++a) {
    for (std::uint32_t b = a; b < 3; ++b) {
      abut_policy policy;
      abut_policy_init(&policy, sizeof policy);
      expect_ok(abut_policy_get(universe, a, b, &policy), "abut_policy_get");
      all.policies.push_back(policy);
    }
  }
  all.found = found_in(universe);
  expect_ok(abut_universe_revision(universe, &all.revision), "abut_universe_revision");
  return all;
}

bool is_same(const abut_contact& a, const abut_contact& b) { return has_same_bits(a, b); }

bool is_same(const Snapshot& a, const Snapshot& b) {
  return has_same_bits(a.parts, b.parts) && has_same_bits(a.geometries, b.geometries) &&
         has_same_bits(a.infos, b.infos) && has_same_bits(a.poses, b.poses) && has_same_bits(a.motions, b.motions) &&
         has_same_bits(a.policies, b.policies) && has_same_bits(a.found.contacts, b.found.contacts) &&
         has_same_bits(a.found.events, b.found.events) && has_same_bits(a.found.stats, b.found.stats) &&
         a.found.hash == b.found.hash && has_same_bits(a.revision, b.revision);
}

Universes::Universes(const Call& setup) {
  abut_universe_options_init(&options_, sizeof options_);
  options_.tolerance_mode = setup.has(1, 0) ? ABUT_TOLERANCE_MARGIN : ABUT_TOLERANCE_DEAD_BAND;
  options_.max_contacts = static_cast<std::uint32_t>(std::array{4, 0, 1, 4}.at(setup.pick(2, 4)));
  // Events of pairs and what goes on are on in most universes: without them
  // less can be judged.
  options_.events = std::array<abut_event_bits, 8>{7, 7, 7, 3, 5, 1, 4, 0}.at(setup.pick(3, 8));
  options_.origin = {static_cast<double>(setup.number(4, -1, 1)) * 8, 0, 0};
  for (std::size_t i = 0; i < universe_count; ++i) {
    abut_universe_options options = options_;
    options.broadphase = static_cast<abut_broadphase>(setup.pick(5 + i, 5));
    options.threads = 1 + static_cast<std::uint32_t>(setup.pick(8 + i, 3));
    if (abut_has_feature("threads") == 0) {
      options.threads = 1;
    }
    if (i == 2) {
      options.broadphase = ABUT_BROADPHASE_BRUTE;
      options.threads = 1;
    }
    expect_ok(abut_universe_create(&options, &universes_.at(i)), "abut_universe_create");
    filters_.at(i).universe = universes_.at(i);
  }
}

Universes::~Universes() {
  for (abut_universe* universe : universes_) {
    abut_universe_destroy(universe);
  }
}

}  // namespace universe_calls

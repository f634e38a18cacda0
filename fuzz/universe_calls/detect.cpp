// SPDX-License-Identifier: Apache-2.0
// Detections, and what is compared after each.
#include <algorithm>
#include <cmath>
#include <map>

#include "play.hpp"

namespace universe_calls {
namespace {

Slots slots_of(const abut_contact& contact) { return {contact.geometry_a.slot, contact.geometry_b.slot}; }

std::map<Slots, std::vector<abut_contact>> by_pair(const std::vector<abut_contact>& contacts) {
  std::map<Slots, std::vector<abut_contact>> pairs;
  for (const abut_contact& contact : contacts) {
    pairs[slots_of(contact)].push_back(contact);
  }
  return pairs;
}

// The same but for the generations of ids, which differ from universe to
// universe.
bool is_same_but_ids(abut_contact a, const abut_contact& b) {
  a.geometry_a.generation = b.geometry_a.generation;
  a.geometry_b.generation = b.geometry_b.generation;
  return is_same(a, b);
}

// What is left of a contact when its history is: age, value, and what is copied
// from options.
abut_contact place_of(abut_contact contact) {
  contact.age = 0;
  contact.user_data = 0;
  return contact;
}

void compare_runs(const Found& a, const Found& b, const char* what) {
  require(a.hash == b.hash, std::string("hashes differ: ") + what);
  require(a.contacts.size() == b.contacts.size() && a.events.size() == b.events.size(),
          std::string("counts differ: ") + what);
  for (std::size_t i = 0; i < a.contacts.size(); ++i) {
    require(is_same_but_ids(a.contacts[i], b.contacts[i]), std::string("contacts differ: ") + what);
  }
}

}  // namespace

void Play::before_detection() {
  for (std::size_t u = 0; u < universe_count; ++u) {
    FilterContext& filter = universes_.filter(u);
    filter.asked.clear();
    require(abut_universe_hash(universes_.at(u), &filter.hash_before) == ABUT_OK, "abut_universe_hash failed");
  }
}

void Play::detect(const Call& call) {
  const Operation operation = call.operation();
  Scope scope;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  abut_aabb region{};
  before_detection();
  if (operation == Operation::detect_pairs) {
    scope.coverage = Coverage::pairs;
    const std::vector<std::size_t> living = world_.living_geometries();
    for (std::size_t i = 0; i < call.pick(1, 7) && !living.empty(); ++i) {
      pairs.emplace_back(living[call.pick(2 + 2 * i, living.size())], living[call.pick(3 + 2 * i, living.size())]);
      scope.pairs.push_back(std::minmax(world_.geometries[pairs.back().first].ids[0].slot,
                                        world_.geometries[pairs.back().second].ids[0].slot));
    }
  } else if (operation == Operation::detect_region) {
    scope.coverage = Coverage::region;
    for (std::size_t i = 0; i < 3; ++i) {
      scope.region[0].at(i) = call.number(1 + i, -8, 4);
      scope.region[1].at(i) = scope.region[0].at(i) + call.number(4 + i, 0, 9);
    }
    const auto &low = scope.region[0], &high = scope.region[1];
    region = {{static_cast<double>(low[0]), static_cast<double>(low[1]), static_cast<double>(low[2])},
              {static_cast<double>(high[0]), static_cast<double>(high[1]), static_cast<double>(high[2])}};
  } else if (operation == Operation::detect_all) {
    scope.coverage = Coverage::everything;
  }
  on_each("a detection", [&](std::size_t u, abut_universe* its) {
    if (u == 2 || scope.coverage == Coverage::everything) {
      return abut_universe_detect_all(its);
    }
    if (scope.coverage == Coverage::pairs) {
      std::vector<abut_geometry_id> a, b;
      for (const auto& [one, other] : pairs) {
        a.push_back(world_.geometries[one].ids.at(u));
        b.push_back(world_.geometries[other].ids.at(u));
      }
      return abut_universe_detect_pairs(its, a.data(), b.data(), a.size());
    }
    if (scope.coverage == Coverage::region) {
      return abut_universe_detect_region(its, &region);
    }
    return call.has(1, 0) ? abut_universe_step(its, 0.25) : abut_universe_detect_changed(its);
  });
  after_detection(scope, scope.coverage == Coverage::pairs || scope.coverage == Coverage::region);
}

void Play::after_detection(const Scope& scope, bool is_partial) {
  is_exactly_full_ = is_exactly_full_ && !is_partial;
  Found first = found_in(universes_.at(0));
  const Found second = found_in(universes_.at(1)), full = found_in(universes_.at(2));
  if (tamper_) {
    tamper_(first);
  }
  counts_.detections += 1;
  counts_.contacts += first.contacts.size();
  counts_.events += first.events.size();
  counts_.filtered += universes_.filter(0).asked.size();
  follow_focus();
  judge_detection(world_, scope, first);
  compare_runs(first, second, "the same calls with another broad phase and other threads");
  if (is_exactly_full_) {
    compare_runs(first, full, "steps and full detections");
  }
  compare_with_full(first, full);
  judge_sleep();
  settle_filters();
  judge_reasons();
  compare_state();
  compare_velocities();
  judge_islands();
}

// Tags as they should be after a detection; where the model does not know a box, as the first universe says.
void Play::follow_focus() {
  for (const std::size_t i : world_.living_geometries()) {
    Geometry& geometry = world_.geometries[i];
    if (!world_.is_focused(geometry)) {
      continue;
    }
    std::optional<std::uint32_t> tag = world_.focused_tag(geometry);
    if (!tag) {
      abut_geometry_info info;
      abut_geometry_info_init(&info, sizeof info);
      require(abut_geometry_describe(universes_.at(0), geometry.ids[0], &info) == ABUT_OK,
              "a geometry that lives cannot be described");
      tag = info.tag;
      require(*tag == world_.focus->focus.near_tag || *tag == world_.focus->focus.far_tag,
              "the focus gave a tag that is not its own");
    }
    geometry.is_switched = *tag != geometry.options.tag;
    geometry.options.tag = *tag;
    counts_.switched += geometry.is_switched ? 1 : 0;
  }
}

// What the filters were asked is the same everywhere; what they parked is
// parked from then on.
void Play::settle_filters() {
  const std::vector<Slots>& asked = universes_.filter(0).asked;
  std::map<std::uint32_t, std::size_t> living;
  for (const std::size_t i : world_.living_geometries()) {
    living[world_.geometries[i].ids[0].slot] = i;
  }
  for (std::size_t u = 0; u < universe_count; ++u) {
    require(universes_.filter(u).complaint.empty(), universes_.filter(u).complaint);
    require(universes_.filter(u).asked == asked, "the filters of two universes were asked about other pairs");
  }
  std::vector<std::pair<std::size_t, abut_parking>> parked;
  for (const auto& [low, high] : asked) {
    require(living.contains(low) && living.contains(high), "the filter was asked about what is gone");
    const Geometry &a = world_.geometries[living[low]], &b = world_.geometries[living[high]];
    require(world_.is_admitted_before_filter(a, b), "the filter was asked about a pair that was left out before");
    require(world_.is_near(a, b) != Answer::no, "the filter was asked about a pair that is not near");
    if (const std::optional<abut_parking> parking =
            world_.filter.parking_of(a.options.user_data, b.options.user_data)) {
      parked.emplace_back(living[high], *parking);
    }
  }
  for (const auto& [geometry, parking] : parked) {
    world_.geometries[geometry].options.parking = parking;
    world_.geometries[geometry].is_moved = true;
  }
}

// The universe tells why two geometries are apart, as the model knows it.
void Play::judge_reasons() const {
  constexpr abut_apart_reasons known = ABUT_APART_PART | ABUT_APART_MOTION | ABUT_APART_PARKING | ABUT_APART_EXCLUSION |
                                       ABUT_APART_LAYERS | ABUT_APART_RULE;
  const std::vector<std::size_t> living = world_.living_geometries();
  for (const std::size_t i : living) {
    for (const std::size_t k : living) {
      const Geometry &a = world_.geometries.at(i), &b = world_.geometries.at(k);
      if (i >= k) {
        continue;
      }
      abut_apart_reasons reasons = 0;
      require(abut_universe_why_apart(universes_.at(0), a.ids[0], b.ids[0], &reasons) == ABUT_OK,
              "nobody tells why two are apart");
      const abut_apart_reasons expected = world_.reasons_apart(a, b);
      require((reasons & known) == expected, "two are apart for the reasons " + std::to_string(reasons) +
                                                 ", of which those of the model are " + std::to_string(expected));
      if (expected != 0) {
        continue;
      }
      const Answer near = world_.is_near(a, b);
      const bool are_apart = (reasons & ABUT_APART_BOXES) != 0, is_refused = (reasons & ABUT_APART_FILTER) != 0;
      require(near == Answer::maybe || are_apart == (near == Answer::no), "boxes are near and apart");
      require(near != Answer::yes || is_refused != world_.filter.keeps(a.options.user_data, b.options.user_data),
              "the filter said something else");
    }
  }
}

// A pair that is up to date has the contacts that a full detection finds. Which
// points of many are kept depends on those of the step before, and so on when
// the pair was looked at: then the depth is the same, not the point.
void Play::compare_with_full(const Found& first, const Found& full) const {
  const auto ours = by_pair(first.contacts), theirs = by_pair(full.contacts);
  const auto at = [](const auto& all, const Slots& slots) {
    const auto found = all.find(slots);
    return found == all.end() ? std::vector<abut_contact>{} : found->second;
  };
  const auto is_same_contact = [](const abut_contact& x, const abut_contact& y) {
    return is_same_but_ids(place_of(x), place_of(y));
  };
  // Depths that differ by less than 1e-5 of the extent of a patch are the same
  // to the reduction; extents are below 32.
  constexpr double tie = 32e-5;
  for (const auto& [slots, contacts] : theirs) {
    require(world_.pairs.contains(slots), "a full detection finds contacts of a pair that does not meet");
  }
  for (const auto& [slots, pair] : world_.pairs) {
    if (pair.is_stale) {
      continue;
    }
    const std::vector<abut_contact> a = at(ours, slots), b = at(theirs, slots);
    const bool agrees = world_.max_contacts == 0
                            ? std::ranges::equal(a, b, is_same_contact)
                            : a.empty() == b.empty() && (a.empty() || std::fabs(a[0].distance - b[0].distance) <= tie);
    require(agrees, "pair " + std::to_string(slots.first) + "-" + std::to_string(slots.second) +
                        " is up to date, and a full detection finds other contacts");
  }
}

void Play::compare_part(std::size_t place) const {
  const Part& part = world_.parts[place];
  for (std::size_t u = 0; u < universe_count; ++u) {
    const abut_universe* its = universes_.at(u);
    abut_pose pose;
    abut_motion motion = 77;
    std::uint64_t user_data = 0;
    std::array<abut_geometry_id, 64> geometries{};
    std::size_t count = 0;
    require(abut_part_pose(its, part.ids.at(u), &pose) == ABUT_OK &&
                abut_part_motion(its, part.ids.at(u), &motion) == ABUT_OK &&
                abut_part_user_data(its, part.ids.at(u), &user_data) == ABUT_OK &&
                abut_part_geometries(its, part.ids.at(u), geometries.data(), geometries.size(), &count) == ABUT_OK,
            "a part that lives cannot be asked");
    const abut_vec3 &p = pose.position, &wanted = part.placed.pose.position;
    require(p.x == wanted.x && p.y == wanted.y && p.z == wanted.z, "a part lies elsewhere");
    require(motion == part.motion && user_data == part.user_data, "a part has another motion or user data");
    require(count == part.geometries.size(), "a part has other geometries");
    for (std::size_t i = 0; i < count; ++i) {
      require(geometries.at(i).slot == world_.geometries[part.geometries[i]].ids.at(u).slot,
              "a part has other geometries");
    }
  }
}

void Play::compare_geometry(std::size_t place) const {
  const Geometry& geometry = world_.geometries[place];
  const abut_geometry_options& wanted = geometry.options;
  for (std::size_t u = 0; u < universe_count; ++u) {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    require(abut_geometry_describe(universes_.at(u), geometry.ids.at(u), &info) == ABUT_OK,
            "a geometry that lives cannot be described");
    require(info.part.slot == world_.parts[geometry.part].ids.at(u).slot &&
                (geometry.is_resized || info.shape == geometry.shape.shape) &&
                info.kind == abut_shape_kind_of(geometry.shape.shape),
            "a geometry has another part or shape");
    require(info.tolerance == wanted.tolerance && info.user_data == wanted.user_data && info.layers == wanted.layers &&
                info.mask == wanted.mask && info.exclusion == wanted.exclusion && info.label == wanted.label &&
                info.tag == wanted.tag && info.material == wanted.material && info.flags == wanted.flags,
            "a geometry has other options");
    require(info.parking == wanted.parking, "a geometry is parked otherwise");
    if (const std::optional<Box> box = box_of(world_, geometry)) {
      const abut_vec3& p = info.pose.position;
      require(p.x == box->centre[0] && p.y == box->centre[1] && p.z == box->centre[2], "a geometry lies elsewhere");
    }
  }
}

// Everything that the model knows of parts and geometries.
void Play::compare_state() const {
  const std::vector<std::size_t> parts = world_.living_parts(), geometries = world_.living_geometries();
  for (std::size_t u = 0; u < universe_count; ++u) {
    std::array<abut_part_id, 64> part_ids{};
    std::array<abut_geometry_id, 64> ids{};
    std::size_t part_count = 0, count = 0;
    require(abut_universe_parts(universes_.at(u), part_ids.data(), part_ids.size(), &part_count) == ABUT_OK &&
                abut_universe_geometries(universes_.at(u), ids.data(), ids.size(), &count) == ABUT_OK,
            "a universe cannot be listed");
    require(part_count == parts.size() && count == geometries.size(), "a universe lists other parts or geometries");
    for (std::size_t i = 0; i < count; ++i) {
      const abut_geometry_id wanted = world_.geometries[geometries[i]].ids.at(u);
      require(ids.at(i).slot == wanted.slot && ids.at(i).generation == wanted.generation,
              "geometries are not listed by slot");
    }
    for (std::size_t i = 0; i < part_count; ++i) {
      const abut_part_id wanted = world_.parts[parts[i]].ids.at(u);
      require(part_ids.at(i).slot == wanted.slot && part_ids.at(i).generation == wanted.generation,
              "parts are not listed by slot");
    }
  }
  std::ranges::for_each(parts, [&](std::size_t part) { compare_part(part); });
  std::ranges::for_each(geometries, [&](std::size_t geometry) { compare_geometry(geometry); });
}

// A value on each contact, of which the model knows only that it stays.
void Play::mark_contacts(const Call& call) {
  for (std::size_t u = 0; u < universe_count; ++u) {
    const Found found = found_in(universes_.at(u));
    std::vector<std::uint64_t> values;
    for (std::size_t i = 0; i < found.contacts.size(); ++i) {
      values.push_back(std::uint64_t{1000} * call.bytes[1] + i + 1);
    }
    require(abut_contacts_set_user_data(universes_.at(u), values.data(), values.size()) == ABUT_OK,
            "contacts could not be marked");
    if (u > 0) {
      continue;
    }
    std::size_t next = 0;
    for (auto& [slots, pair] : world_.pairs) {
      for (abut_contact& contact : pair.contacts) {
        contact.user_data = values.at(next++);
      }
    }
  }
}

}  // namespace universe_calls

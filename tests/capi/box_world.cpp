// SPDX-License-Identifier: Apache-2.0
#include "box_world.hpp"

#include <cmath>
#include <tuple>

namespace abut_test {
namespace {

bool overlap(double centre_a, double half_a, double centre_b, double half_b) {
  return std::fabs(centre_a - centre_b) <= half_a + half_b;
}

}  // namespace

BoxWorld::BoxWorld(const abut_universe_options& options, std::uint64_t seed, int boxes)
    : random_(seed), universe_(&options) {
  require(abut_universe_set_filter(universe_, filter, this));
  for (int i = 0; i < boxes; ++i) add_box();
}

std::uint32_t BoxWorld::filter(void* context, const abut_universe*, abut_geometry_id a, abut_geometry_id b) {
  return static_cast<const BoxWorld*>(context)->is_kept(a.slot, b.slot) ? 1 : 0;
}

double BoxWorld::number(double low, double high) {
  return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
}

abut_geometry_id BoxWorld::random_geometry() { return random_box().id; }

BoxWorld::Box& BoxWorld::random_box() {
  return std::next(boxes_.begin(), static_cast<std::ptrdiff_t>(below(static_cast<std::uint32_t>(boxes_.size()))))
      ->second;
}

void BoxWorld::edit() {
  for (int i = 0; i < 8; ++i) {
    const std::uint32_t what = below(20);
    if (what <= 2 && boxes_.size() < 60) {
      add_box();
    } else if (what <= 4 && boxes_.size() > 30) {
      destroy();
    } else if (what <= 6) {
      park();
    } else if (what == 7) {
      reshape();
    } else if (what == 8) {
      change_options();
    } else if (what == 9) {
      change_motion();
    } else if (what == 10 && below(3) == 0) {
      change_rule();
    } else if (what == 11 && below(4) == 0) {
      change_filter();
    } else {
      move_part();
    }
  }
}

void BoxWorld::move_some() {
  for (int i = 0; i < 8; ++i) move_part();
}

void BoxWorld::add_box() {
  Box box;
  const bool is_alone = parts_.empty() || below(4) != 0;
  if (is_alone) {
    Part part;
    part.position = {number(-2, 2), number(-2, 2), number(-2, 2)};
    part.motion = below(4) == 0 ? ABUT_MOTION_STATIC : ABUT_MOTION_DYNAMIC;
    part.id = universe_.add_part({part.position, no_rotation}, part.motion);
    parts_[part.id.slot] = part;
    box.part = part.id.slot;
  } else {
    box.part =
        std::next(parts_.begin(), static_cast<std::ptrdiff_t>(below(static_cast<std::uint32_t>(parts_.size()))))->first;
  }
  box.half = {number(0.1, 0.6), number(0.1, 0.6), number(0.1, 0.6)};
  box.options = default_geometry_options();
  box.options.label = below(3);
  if (!is_alone) box.options.pose.position = {number(-1, 1), number(-1, 1), number(-1, 1)};
  box.id = universe_.add_geometry(parts_.at(box.part).id, make_box(box.half.x, box.half.y, box.half.z), box.options);
  boxes_[box.id.slot] = box;
}

void BoxWorld::move_part() {
  Part& part = parts_.at(random_box().part);
  const double far = below(10) == 0 ? 3.0 : 0.3;
  part.position.x = std::clamp(part.position.x + number(-far, far), -2.0, 2.0);
  part.position.y = std::clamp(part.position.y + number(-far, far), -2.0, 2.0);
  part.position.z = std::clamp(part.position.z + number(-far, far), -2.0, 2.0);
  universe_.move(part.id, {part.position, no_rotation});
}

// One geometry, or the part of it with all that is on it.
void BoxWorld::destroy() {
  const Box box = random_box();
  if (below(2) == 0) {
    require(abut_geometry_destroy(universe_, box.id));
    boxes_.erase(box.id.slot);
    return;
  }
  require(abut_part_destroy(universe_, parts_.at(box.part).id));
  std::erase_if(boxes_, [&](const auto& each) { return each.second.part == box.part; });
  parts_.erase(box.part);
}

// Once between two detections: what comes and goes in between is not the subject of the model.
void BoxWorld::park() {
  Box& box = random_box();
  if (box.has_changed_parking) return;
  box.has_changed_parking = true;
  box.options.parking = box.options.parking != ABUT_PARKING_NONE ? ABUT_PARKING_NONE : 1 + below(2);
  universe_.park(box.id, box.options.parking);
}

void BoxWorld::reshape() {
  Box& box = random_box();
  box.is_reshaped = true;
  box.half.x = number(0.1, 0.6);
  require(abut_geometry_set_shape(universe_, box.id, make_box(box.half.x, box.half.y, box.half.z)));
}

void BoxWorld::change_options() {
  Box& box = random_box();
  box.options.layers = 1 + below(3);
  box.options.mask = below(3) == 0 ? 1 : ~std::uint64_t{0};
  box.options.exclusion = below(3) == 0 ? 1 + below(3) : 0;
  box.options.label = below(3);
  require(abut_geometry_set_options(universe_, box.id, &box.options));
}

void BoxWorld::change_motion() {
  Part& part = parts_.at(random_box().part);
  part.motion = below(2) == 0 ? ABUT_MOTION_DYNAMIC : ABUT_MOTION_ANIMATED;
  require(abut_part_set_motion(universe_, part.id, part.motion));
}

void BoxWorld::change_rule() {
  const std::uint32_t a = below(3), b = below(3);
  const abut_rule rule = below(3);
  rules_.at(a).at(b) = rules_.at(b).at(a) = rule;
  const abut_collidable label_a{ABUT_COLLIDABLE_LABEL, a, 0}, label_b{ABUT_COLLIDABLE_LABEL, b, 0};
  require(abut_rule_set(universe_, &label_a, &label_b, rule));
}

void BoxWorld::change_filter() {
  banned_ = below(6);
  require(abut_universe_refilter(universe_));
}

bool BoxWorld::meet(const Box& a, const Box& b) const {
  const Part &part_a = parts_.at(a.part), &part_b = parts_.at(b.part);
  const auto &of_a = a.options, &of_b = b.options;
  if (a.part == b.part || (part_a.motion != ABUT_MOTION_DYNAMIC && part_b.motion != ABUT_MOTION_DYNAMIC)) return false;
  if (of_a.parking != ABUT_PARKING_NONE || of_b.parking != ABUT_PARKING_NONE) return false;
  if ((of_a.exclusion & of_b.exclusion) != 0 || (of_a.layers & of_b.mask) == 0 || (of_b.layers & of_a.mask) == 0)
    return false;
  if (rules_.at(of_a.label).at(of_b.label) == ABUT_RULE_DISABLE || !is_kept(a.id.slot, b.id.slot)) return false;
  const abut_vec3 &p = part_a.position, &q = part_b.position, &u = of_a.pose.position, &v = of_b.pose.position;
  return overlap(p.x + u.x, a.half.x, q.x + v.x, b.half.x) && overlap(p.y + u.y, a.half.y, q.y + v.y, b.half.y) &&
         overlap(p.z + u.z, a.half.z, q.z + v.z, b.half.z);
}

std::vector<Touch> BoxWorld::touching() const {
  std::vector<Touch> found;
  for (auto a = boxes_.begin(); a != boxes_.end(); ++a) {
    for (auto b = std::next(a); b != boxes_.end(); ++b) {
      if (meet(a->second, b->second)) found.push_back({a->second.id, b->second.id});
    }
  }
  return found;
}

std::vector<Change> BoxWorld::foretell() {
  const auto is_reshaped = [&](const Touch& touch) {
    const auto changed = [&](abut_geometry_id id) {
      const auto box = boxes_.find(id.slot);
      return box != boxes_.end() && box->second.id == id && box->second.is_reshaped;
    };
    return changed(touch.a) || changed(touch.b);
  };
  const auto has = [](const std::vector<Touch>& list, const Touch& touch) {
    return std::find(list.begin(), list.end(), touch) != list.end();
  };
  const std::vector<Touch> present = touching();
  std::vector<Change> changes;
  for (const Touch& touch : before_) {
    if (!has(present, touch) || is_reshaped(touch)) changes.push_back({touch, ABUT_EVENT_END});
  }
  for (const Touch& touch : present) {
    const bool is_new = !has(before_, touch) || is_reshaped(touch);
    changes.push_back({touch, is_new ? ABUT_EVENT_BEGIN : ABUT_EVENT_PERSIST});
  }
  std::sort(changes.begin(), changes.end(), [](const Change& x, const Change& y) {
    const auto key = [](const Change& change) {
      return std::tuple(change.touch.a.slot, change.touch.b.slot, change.kind != ABUT_EVENT_END);
    };
    return key(x) < key(y);
  });
  before_ = present;
  for (auto& [slot, box] : boxes_) box.is_reshaped = box.has_changed_parking = false;
  return changes;
}

std::set<Touch> touches_of(const std::vector<abut_contact>& contacts) {
  std::set<Touch> found;
  for (const abut_contact& contact : contacts) found.insert({contact.geometry_a, contact.geometry_b});
  return found;
}

std::vector<Change> changes_of(const std::vector<abut_event>& events) {
  std::vector<Change> found;
  for (const abut_event& event : events) {
    if ((event.flags & ABUT_EVENT_CONTACT) == 0) found.push_back({{event.geometry_a, event.geometry_b}, event.kind});
  }
  return found;
}

}  // namespace abut_test

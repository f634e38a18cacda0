// SPDX-License-Identifier: Apache-2.0
#include "encounter.hpp"

#include <algorithm>

#include "digits.hpp"

namespace cli {
namespace {

abut_policy policy_of(const World& world, std::size_t a, std::size_t b) {
  abut_policy policy;
  abut_policy_init(&policy, sizeof policy);
  check(abut_policy_get(world.universe(), world.tag_of(a), world.tag_of(b), &policy), "cannot ask for a policy");
  return policy;
}

// Up to this distance two geometries touch.
double margin_of(const World& world, const abut_policy& policy, std::size_t a, std::size_t b) {
  const auto& geometries = world.scene().geometries;
  const double sum = geometries[a].options.tolerance + geometries[b].options.tolerance;
  const double tolerance = policy.tolerance < 0.0 ? sum : policy.tolerance;
  return world.scene().universe.tolerance_mode == ABUT_TOLERANCE_MARGIN ? tolerance : -tolerance;
}

// The distance that two geometries had if nothing had holes; none where nothing has.
std::optional<abut_distance> distance_without_holes(const World& world, const Placed& a, const Placed& b) {
  const ShapeOwner solid_a = world.scene().shapes.without_holes(a.shape);
  const ShapeOwner solid_b = world.scene().shapes.without_holes(b.shape);
  if (solid_a == nullptr && solid_b == nullptr) {
    return std::nullopt;
  }
  return distance_between(solid_a ? solid_a.get() : a.shape, a.pose, solid_b ? solid_b.get() : b.shape, b.pose);
}

std::size_t count_in(const std::map<NumberPair, std::size_t>& counts, std::size_t a, std::size_t b) {
  const auto found = counts.find(std::minmax(a, b));
  return found == counts.end() ? 0 : found->second;
}

bool have_contacts(const Placed& a, const Placed& b, double margin) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.margin = margin;
  std::size_t count = 0;
  check(abut_pair_contacts(a.shape, &a.pose, b.shape, &b.pose, &options, nullptr, 0, &count), "contacts of a pair");
  return count > 0;
}

GateAnswer answer_of_distance(const World& world, const Encounter& its, const abut_policy& policy) {
  if (!its.distance) {
    return {"distance", false, "they have none"};
  }
  const double margin = margin_of(world, policy, its.a.index, its.b.index);
  const bool is_near = its.distance->distance <= margin;
  const std::string says = digits(its.distance->distance) + ", within [" + digits(its.distance->lower) + ", " +
                           digits(its.distance->upper) + "]; they touch up to " + digits(margin);
  const auto solid = distance_without_holes(world, its.a, its.b);
  if (solid && solid->distance <= margin && !have_contacts(its.a, its.b, margin)) {
    return {"holes", false, "without holes their distance would be " + digits(solid->distance)};
  }
  return {"distance", is_near, says};
}

}  // namespace

std::optional<abut_distance> distance_between(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b,
                                              const abut_pose& pose_b) {
  abut_distance distance;
  const abut_status status = abut_pair_distance(a, &pose_a, b, &pose_b, nullptr, &distance);
  if (status == ABUT_UNSUPPORTED) {
    return std::nullopt;
  }
  check(status, "cannot find a distance");
  return distance;
}

Encounters::Encounters(const World& world) : world_(&world), gates_(world), near_(near_pairs(world)) {
  for (const abut_contact& contact : contacts_of(world.universe())) {
    ++contacts_[std::minmax(world.number_of(contact.geometry_a), world.number_of(contact.geometry_b))];
  }
  for (const abut_element_contact& contact : world.element_contacts()) {
    ++elements_[std::minmax(world.number_of(contact.geometry_a), world.number_of(contact.geometry_b))];
  }
}

GateAnswer Encounters::answer_of_boxes(std::size_t a, std::size_t b) const {
  const bool overlap = (world_->why_apart(a, b) & ABUT_APART_BOXES) == 0;
  const char* what = overlap ? "overlap: there are events without contacts" : "are apart";
  return {"boxes", overlap, std::string("a policy asks about their boxes only, which ") + what};
}

Encounter Encounters::between(std::size_t a, std::size_t b) const {
  Encounter its{placed(*world_, a), placed(*world_, b)};
  its.answers = gates_.answers(a, b);
  its.distance = distance_between(its.a.shape, its.a.pose, its.b.shape, its.b.pose);
  const abut_policy policy = policy_of(*world_, a, b);
  const bool boxes_only = policy.detail == ABUT_DETAIL_BOX;
  its.answers.push_back(boxes_only ? answer_of_boxes(a, b) : answer_of_distance(*world_, its, policy));
  its.contacts = count_in(contacts_, a, b);
  its.elements = count_in(elements_, a, b);
  const bool has_any = its.contacts + its.elements > 0;
  GateAnswer& last = its.answers.back();
  if (has_any && !last.is_open) {
    last.is_open = true;
    last.says += "; they touch on the way of a step, since one of them is fast or speculative";
  }
  const auto closed = std::ranges::find(its.answers, false, &GateAnswer::is_open);
  const bool has_no_contacts = boxes_only || policy.detail == ABUT_DETAIL_TOUCH;
  its.touches = has_any || (has_no_contacts && closed == its.answers.end());
  if (!its.touches && closed == its.answers.end() && (world_->why_apart(a, b) & ABUT_APART_SIDE) != 0) {
    its.answers.push_back(
        {"side", false, "one is a surface of one side; the other overlaps it from the back, where it stops nothing"});
    its.stopped_by = "side";
  } else if (!its.touches && closed == its.answers.end() && policy.detail == ABUT_DETAIL_ELEMENTS) {
    its.answers.push_back(
        {"elements", false, "a policy asks about vertices, edges and faces, and its method finds none"});
    its.stopped_by = "elements";
  } else if (!its.touches && closed == its.answers.end()) {
    const std::string rate = "; a policy finds them anew once in " + std::to_string(policy.period) + " steps";
    its.answers.push_back(
        {"detection", false, "the universe has no contact of theirs" + (policy.period > 1 ? rate : "")});
    its.stopped_by = "detection";
  } else if (!its.touches) {
    its.stopped_by = closed->name;
  }
  return its;
}

}  // namespace cli

// SPDX-License-Identifier: Apache-2.0
#include "surface_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace oracle {

namespace {

double of(Quad value) { return static_cast<double>(value); }

Part point_part(const Vec& point) {
  Part part;
  part.hull.points = {point};
  part.hull.centre = point;
  part.low = part.high = {of(point.x), of(point.y), of(point.z)};
  return part;
}

// The distance of a point to a convex part without its radius; negative inside.
Quad to_part(const Part& part, const Part& point) { return core_distance(part.hull, point.hull).distance; }

// How far a point is from the surface of a side: outside of it, or inside of a convex shape. The part that holds it.
struct OffSurface {
  Quad outside = 0, inside = 0;
};
OffSurface off_surface(const Side& side, const Vec& point) {
  const Part at = point_part(point);
  std::optional<Quad> nearest;
  for (const Part& part : side.parts) {
    if (nearest && quad(gap_of_boxes(part, at, {})) > *nearest) continue;
    const Quad distance = to_part(part, at);
    if (!nearest || distance < *nearest) nearest = distance;
  }
  const Quad distance = nearest.value_or(0) - side.radius;
  return {larger(distance, 0), side.is_surface ? 0 : larger(-distance, 0)};
}

class Judge {
 public:
  Judge(const Side& a, const Side& b, const Meeting& meeting, std::span<const Touch> contacts, double margin,
        const Doubt& doubt, const Holds& holds)
      : a_(a), b_(b), meeting_(meeting), contacts_(contacts), margin_(margin), doubt_(doubt), holds_(holds) {}

  [[nodiscard]] std::vector<Fault> verdict() {
    judge_whole();
    for (const Touch& contact : contacts_) judge_contact(contact);
    return std::move(faults_);
  }

 private:
  // Not a number is more than anything.
  void expect_at_most(const char* fact, double off, double most) {
    if (!(off <= most)) faults_.push_back({fact, off});
  }

  void judge_whole() {
    const double truth = of(meeting_.distance), least = of(least_depth(meeting_));
    const bool is_held = holds_ && holds_({});
    double deepest = std::numeric_limits<double>::infinity();
    for (const Touch& contact : contacts_) deepest = std::min(deepest, contact.distance);
    if (contacts_.empty() && is_held) {
      faults_.push_back({"a contact of what is inside", std::abs(truth)});
      return;
    }
    if (contacts_.empty()) {
      expect_at_most("a contact where shapes overlap", least, doubt_.distance);
      if (!stops_from_one_side()) {
        expect_at_most("a contact within the margin", margin_ - truth, doubt_.distance);
      }
      return;
    }
    if (!is_held) {
      expect_at_most("no contact of shapes that are apart", truth - margin_, doubt_.distance);
    }
    if (truth > 0 && !is_held) {
      expect_at_most("no contact nearer than the nearest parts", truth - deepest, doubt_.distance);
      if (!stops_from_one_side()) {
        expect_at_most("a contact as near as the nearest parts", deepest - truth, doubt_.distance);
      }
      return;
    }
    if (!is_met_from_fronts()) return;
    expect_at_most("a contact as deep as each two parts", deepest + least, doubt_.distance);
    if (holds_ || !(deepest < -doubt_.distance)) return;
    std::vector<Vec> hints;
    for (const Touch& contact : contacts_) hints.push_back(contact.normal);
    const WayOut way = shortest_way_out(a_, b_, meeting_, hints);
    // What leans by a thousandth is longer by half a millionth.
    if (way.is_known) {
      const double depth = of(way.depth);
      expect_at_most("no contact deeper than a way out", -deepest - (1 + 1e-6) * depth, doubt_.distance);
    }
  }

  [[nodiscard]] bool is_met_from_fronts() const { return std::ranges::all_of(meeting_.met, &PartsMet::is_allowed); }
  [[nodiscard]] bool stops_from_one_side() const { return a_.is_one_sided || b_.is_one_sided; }

  void judge_contact(const Touch& contact) {
    const Vec between = contact.point_b - contact.point_a;
    const Quad along = dot(between, contact.normal);
    const double rounding = doubt_.point, both = doubt_.distance + doubt_.point;
    expect_at_most("a unit normal", std::abs(of(length(contact.normal)) - 1), 4e-15);
    expect_at_most("points that give the distance", std::abs(of(along) - contact.distance), rounding);
    expect_at_most("points across each other", of(length(between - contact.normal * along)), both);
    expect_at_most("a contact within the margin", contact.distance - margin_, doubt_.distance);
    const bool is_deepest = is_deepest_of_its_normal(contact);
    judge_point(a_, contact.point_a, is_deepest, "point_a on its surface");
    judge_point(b_, contact.point_b, is_deepest, "point_b on its surface");
    if (is_deepest) judge_normal(contact);
  }

  // The corners of one face share the normal of the deepest one of them.
  [[nodiscard]] bool is_deepest_of_its_normal(const Touch& contact) const {
    return std::ranges::none_of(contacts_, [&](const Touch& other) {
      const Vec turn = other.normal - contact.normal;
      return other.distance < contact.distance && dot(turn, turn) < quad(1e-24);
    });
  }

  // Points of a shape with a radius beside the deepest one may lie below its surface, which curves away from the plane.
  void judge_point(const Side& side, const Vec& point, bool is_deepest, const char* fact) {
    const OffSurface off = off_surface(side, point);
    expect_at_most(fact, of(off.outside), doubt_.distance + doubt_.point);
    if (is_deepest || !(side.radius > 0)) expect_at_most(fact, of(off.inside), doubt_.distance + doubt_.point);
  }

  void judge_normal(const Touch& contact) {
    const Quad reach = quad(doubt_.distance + doubt_.point);
    expect_to_front(a_, contact.point_a, contact.normal, reach);
    expect_to_front(b_, contact.point_b, -contact.normal, reach);
    if (!is_met_from_fronts()) return;
    const Quad off_a = off_cone(a_, contact.point_a, contact.normal, reach);
    const Quad off_b = b_.is_surface ? off_cone(b_, contact.point_b, -contact.normal, reach) : 0;
    const Quad face_a = off_face(a_, contact.point_a, contact.normal, reach);
    const Quad face_b = b_.is_surface ? off_face(b_, contact.point_b, contact.normal, reach) : 2;
    // One of two surfaces lends the normal of its face.
    const double off = of(b_.is_surface ? smaller(larger(off_a, off_b), smaller(face_a, face_b)) : off_a);
    if (off <= doubt_.sine) return;
    // What leans by a little is the normal of a face that went wrong, and a point beside the surface is no excuse.
    const bool is_way_out = of(face_a) > 2e-3 && of(face_a) < 1.5 && contact.distance < 0 && leads_out(contact);
    if (!is_way_out) faults_.push_back({"a normal of the surface", off, true});
  }

  // Whether the move along the normal ends the overlap of the whole, but for rounding.
  [[nodiscard]] bool leads_out(const Touch& contact) const {
    const Vec move = contact.normal * quad(-contact.distance);
    if (!(distance_after(a_, b_, move, 1, false) > quad(-doubt_.distance - doubt_.point))) return false;
    // At the end of the way points lie on the surface; a little further they are in or out.
    return !holds_ || !holds_(move + contact.normal * (quad(1e-9) * (a_.size + b_.size)));
  }

  void expect_to_front(const Side& side, const Vec& point, const Vec& normal, Quad reach) {
    if (!side.is_one_sided) return;
    const Part at = point_part(point);
    Quad front = -2;
    for (const Part& part : side.parts) {
      if (quad(gap_of_boxes(part, at, {})) > reach || to_part(part, at) > reach) continue;
      front = larger(front, dot(normal, part.normal));
    }
    if (!(of(-front) <= 1e-9)) faults_.push_back({"a normal to the front", of(-front), true});
  }

  [[nodiscard]] static Quad off_face(const Side& side, const Vec& point, const Vec& normal, Quad reach) {
    Quad least = 2;
    const Part at = point_part(point);
    for (const Part& part : side.parts) {
      if (quad(gap_of_boxes(part, at, {})) > reach || to_part(part, at) > reach) continue;
      if (dot(part.normal, part.normal) > 0) least = smaller(least, length(cross(normal, part.normal)));
    }
    return least;
  }

  const Side& a_;
  const Side& b_;
  const Meeting& meeting_;
  std::span<const Touch> contacts_;
  double margin_;
  Doubt doubt_;
  const Holds& holds_;
  std::vector<Fault> faults_;
};

}  // namespace

Quad off_cone(const Side& side, const Vec& point, const Vec& normal, Quad reach) {
  if (!side.is_surface) return 0;
  const Part at = point_part(point);
  Quad off_face = 2, rise = 0;
  bool is_held = false;
  for (const Part& part : side.parts) {
    if (quad(gap_of_boxes(part, at, {})) > reach || to_part(part, at) > reach) continue;
    is_held = true;
    if (dot(part.normal, part.normal) > 0) off_face = smaller(off_face, length(cross(normal, part.normal)));
    for (const Vec& corner : part.hull.points) {
      const Vec way = corner - point;
      const Quad far = length(way);
      if (far > reach) rise = larger(rise, (dot(normal, way) - reach) / far);
    }
  }
  return is_held ? smaller(off_face, rise) : 2;
}

std::vector<Fault> judge_surface_contacts(const Side& a, const Side& b, const Meeting& meeting,
                                          std::span<const Touch> contacts, double margin, const Doubt& doubt,
                                          const Holds& holds) {
  return Judge(a, b, meeting, contacts, margin, doubt, holds).verdict();
}

}  // namespace oracle

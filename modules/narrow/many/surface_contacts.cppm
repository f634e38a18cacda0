// SPDX-License-Identifier: Apache-2.0
// Contacts of a surface. A contact at an edge or a vertex counts only where its normal is in the cone of normals of the
// whole surface there, so that sliding shapes do not trip over seams. Elsewhere a neighbour is nearer and has its own
// contact: of this triangle only what its face touches counts, turned to the normal of the face, as far as the
// neighbours leave it any.
export module abut.narrow.many.surface_contacts;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.convex;
import abut.narrow.many.claims;
import abut.narrow.many.parting_ways;
import abut.narrow.many.parts_met;
import abut.narrow.many.triangle_contacts;
import abut.narrow.many.way_out;

export namespace abut {

// The contacts of a surface with a convex shape, or with another surface, from those of their parts.
template <Surface A, class Other>
class SurfaceContacts {
 public:
  using B = typename PartOf<Other>::type;

  SurfaceContacts(const A& a, const Other& other, const Pose& ab, const QuerySettings& settings, Manifold& out)
      : a_(a),
        other_(other),
        ab_(ab),
        settings_(settings),
        out_(out),
        first_(out.size()),
        ways_(a, other, ab, settings) {}

  // `part_of_b`: the number of b where it is a part itself.
  void add(const Triangle& triangle, const B& b, std::uint32_t part_of_b) {
    const Real touching = touching_within<B>(core_size(triangle, b, ab_), settings_);
    const Real radii = b.radius(), limit = reach_beyond(touching) + radii + edge_slack(b, ab_);
    const TriangleSeparation found = begin_separation(triangle, b, ab_, settings_, limit);
    const CoreSeparation& core = found.core;
    if (core.beyond || core.distance > limit) {
      return;
    }
    const Fronts<B> fronts(triangle, b, ab_);
    const bool is_allowed = fronts.allows(core.normal);
    if (!is_allowed && !counts_from_behind(triangle, b, ab_, core)) {
      return;
    }
    const bool is_touch = only_touches(triangle, b, core, touching);
    if (is_touch && !is_allowed) {
      return;
    }
    bool turns_a = triangle.has_area() && !(is_allowed && leads_out(a_, triangle, core.normal, touching));
    bool turns_b = false;
    if constexpr (Surface<Other>) {
      turns_b = b.has_area() && !(is_allowed && leads_out(other_, b, -ab_.rotation.undo(core.normal), touching));
    }
    if constexpr (PointCored<B>) {
      if (!core.overlap) {
        add_point(triangle, b, part_of_b, found, is_allowed, turns_a);
        return;
      }
    }
    const std::size_t first = out_.size(),
                      part = ways_.add(triangle, b, fronts, core.normal, core.distance - radii, touching);
    if (!turns_a && !turns_b) {
      const Real depth = append(triangle, b, part_of_b, completed(triangle, b, ab_, found), true);
      turns_a = !leads_out_of_a(triangle, first, touching);
      if constexpr (Surface<Other>) {
        turns_b = !leads_out_of_b(b, first, touching);
      }
      if (!turns_a && !turns_b) {
        claim(first, depth, false);
        return;
      }
      out_.resize(first);
    }
    if (is_allowed) {
      leave(triangle, part_of_b, found, touching);
    }
    Real depth = -infinity;
    if (const auto turned = turn(triangle, b, core, fronts, turns_a, turns_b)) {
      // The closest points may lie beside the face: the foot of the lowest point of the other side.
      depth = append(triangle, b, part_of_b, turned->separation, is_over_face(triangle, b, *turned));
      // What passes the plane of the triangle beside it and reaches under it is no overlap.
      if (is_allowed && (is_touch || (!core.overlap && core.distance > touching))) {
        erase_deeper(first, radii + (is_touch ? 2 * touching : 4 * core.rounding) - core.distance);
        depth = depth_from(first);
      }
      claim(first, depth, true);
    }
    turned_.push_back({first, out_.size(), part, depth, touching, depth});
  }

  // To be called after the last part. `on_the_way`: what b may meet on a way. `add_more`: adds parts that were passed
  // over; it is called where there is no contact otherwise.
  template <class OnTheWay, class AddMore>
  void finish(const OnTheWay& on_the_way, const AddMore& add_more) {
    settle_claims(on_the_way);
    if (out_.size() == first_) {
      add_more();
    }
    append_left(on_the_way);
  }

 private:
  // Contacts under the normal of a face, which may belong to a neighbour.
  struct Group {
    std::size_t first, last;
    std::size_t part;  // which of those that were met
    Real depth;        // of the deepest of them
    Real noise;        // of depths
    Real claimed;      // how much of the depth the claims of others leave
  };
  // The deepest contact that was left to a neighbour across an edge.
  struct Left {
    std::uint32_t part_of_a, part_of_b;
    Vec3 normal;  // of part a
    TriangleSeparation found;
    Real noise;  // of depths
  };

  // How far apart what is met may be. What only touches offers ways, on whichever side of the margin rounding puts it.
  [[nodiscard]] Real reach_beyond(Real touching) const {
    const bool may_touch = !Surface<Other> && !PointCored<B> && settings_.margin >= 0;
    return may_touch ? std::max(settings_.margin, touching) : settings_.margin;
  }
  // Whether the deepest contact from `first` on leads out of a side, whatever lies beside its triangles.
  [[nodiscard]] bool leads_out_of_a(const Triangle& triangle, std::size_t first, Real noise) const {
    const ContactPoint* deepest = deepest_from(first);
    const auto size = [&] {
      if constexpr (Surface<Other>) {
        return infinity;  // the triangle alone tells
      } else {
        return other_.extent() + other_.radius();
      }
    };
    return deepest == nullptr || leads_out_of_all(a_, triangle, deepest->point_a, deepest->normal, noise, size());
  }
  [[nodiscard]] bool leads_out_of_b(const B& b, std::size_t first, Real noise) const {
    const ContactPoint* deepest = deepest_from(first);
    return deepest == nullptr || leads_out_of_all(other_, b, ab_.undo(deepest->point_b),
                                                  -ab_.rotation.undo(deepest->normal), noise, infinity);
  }
  [[nodiscard]] const ContactPoint* deepest_from(std::size_t first) const [[clang::lifetimebound]] {
    const std::span<const ContactPoint> found = std::span(out_).subspan(first);
    return found.empty() ? nullptr : &*std::ranges::min_element(found, {}, &ContactPoint::distance);
  }

  // A point beside a face is nearer to a neighbour, which tells its contact. Over the face the nearest point has the
  // normal of the face, but for rounding.
  void add_point(const Triangle& triangle, const B& b, std::uint32_t part_of_b, const TriangleSeparation& found,
                 bool is_allowed, bool turns) {
    const CoreSeparation& core = found.core;
    if (!turns) {
      const std::size_t first = out_.size();
      append(triangle, b, part_of_b, core, true);
      if (leads_out_of_a(triangle, first, noise_of(core_size(triangle, b, ab_)))) {
        return;
      }
      out_.resize(first);
    }
    if (is_allowed) {
      leave(triangle, part_of_b, found, noise_of(core_size(triangle, b, ab_)));
    }
    const Vec3& normal = triangle.normal();
    const bool is_in_front = triangle.is_one_sided() || dot(normal, core.normal) >= 0;
    const CoreSeparation over = along_face(triangle, b, ab_, core, is_in_front ? normal : -normal);
    if (is_over(triangle, over.point_a)) {
      append(triangle, b, part_of_b, over, true);
    }
  }

  // Whether the core lies beyond the plane that parts it from the triangle. What is flat there may lie on either side:
  // a segment through an edge. Of two triangles one has to be wide, whichever comes first.
  [[nodiscard]] bool only_touches(const Triangle& triangle, const B& b, const CoreSeparation& core, Real noise) const {
    const auto is_wide = [&](const auto& side, const Pose& pose) {
      const auto lowest = [&](const Vec3& direction) { return lowest_along(side, pose, direction) + side.radius(); };
      return -lowest(-core.normal) - lowest(core.normal) > 2 * noise;
    };
    return std::fabs(core.distance) <= noise &&
           (is_wide(b, ab_) || (Surface<Other> && is_wide(triangle, Pose::identity())));
  }

  // Where two are equally deep, the order in which they came has no say.
  void leave(const Triangle& triangle, std::uint32_t part_of_b, const TriangleSeparation& found, Real noise) {
    const auto key = [](Real distance, const Vec3& n, std::uint32_t part) {
      return std::tuple(distance, n.x, n.y, n.z, part);
    };
    if (!left_ || key(found.core.distance, triangle.normal(), part_of_b) <
                      key(left_->found.core.distance, left_->normal, left_->part_of_b)) {
      left_ = Left{triangle.index(), part_of_b, triangle.normal(), found, noise};
    }
  }

  // A separation along the normal of a face, and of which side.
  struct Turned {
    CoreSeparation separation;
    bool is_of_b;
  };

  // The normals of faces may stand in for the normal that was found; the one that parts them sooner does.
  [[nodiscard]] std::optional<Turned> turn(const Triangle& triangle, const B& b, const CoreSeparation& core,
                                           const Fronts<B>& fronts, bool turns_a, bool turns_b) const {
    struct Way {
      Vec3 normal;
      Real distance;
      bool is_of_b;
    };
    Way best{{0, 0, 0}, -infinity, false};
    // Cores that are apart are on the side that their closest points tell.
    const bool is_apart = !core.overlap && fronts.allows(core.normal);
    const auto consider = [&](const Vec3& normal, bool is_of_b, const auto& distance_along) {
      for (const Vec3& direction : {normal, -normal}) {
        if ((!is_apart || dot(core.normal, direction) >= 0) && fronts.allows(direction)) {
          const Real distance = distance_along(direction);
          best = distance > best.distance ? Way{direction, distance, is_of_b} : best;
        }
      }
    };
    if (turns_a) {
      consider(triangle.normal(), false, [&](const Vec3& direction) {
        return dot(direction, placed_support(b, place(b, ab_), -direction).point - triangle.corners()[0]);
      });
    }
    if constexpr (Surface<Other>) {
      if (turns_b) {
        const Vec3 corner_of_b = ab_ * b.corners()[0];
        consider(-(ab_.rotation * b.normal()), true, [&](const Vec3& direction) {
          return dot(direction, corner_of_b - triangle.support(direction).point);
        });
      }
    }
    if (!(best.distance > -infinity)) {
      return std::nullopt;
    }
    if constexpr (Surface<Other>) {
      if (best.is_of_b) {
        return Turned{along_other_face(triangle, b, ab_, core, best.normal), true};
      }
    }
    return Turned{along_face(triangle, b, ab_, core, best.normal), false};
  }

  [[nodiscard]] bool is_over_face(const Triangle& triangle, const B& b, const Turned& turned) const {
    if constexpr (Surface<Other>) {
      if (turned.is_of_b) {
        return is_over(b, ab_.undo(turned.separation.point_b));
      }
    }
    return is_over(triangle, turned.separation.point_a);
  }

  // Named after the parts: seen from outside, the feature of a surface is its triangle; the number of the contact still
  // tells the corners and edges of the triangle apart. After a turn the closest points may lie beside the triangle,
  // over a neighbour that has them too. Returns the depth of the deepest of them.
  Real append(const Triangle& triangle, const B& b, std::uint32_t part_of_b, const CoreSeparation& core,
              bool closest_count) {
    const std::size_t first = out_.size();
    const Real least = contacts_under(triangle, b, ab_, core, settings_.margin, closest_count, out_);
    name_parts(triangle, part_of_b, first);
    return -least;
  }
  void name_parts(const Triangle& triangle, std::uint32_t part_of_b, std::size_t first) {
    for (ContactPoint& contact : std::span(out_).subspan(first)) {
      contact.id = contact_id_of_part(contact.id, triangle.index());
      contact.feature_a = {FeatureKind::face, triangle.index()};
      if constexpr (Surface<Other>) {
        contact.id = contact_id_of_part(contact.id, part_of_b);
        contact.feature_b = {FeatureKind::face, part_of_b};
      }
    }
  }

  [[nodiscard]] Real depth_from(std::size_t first) const {
    Real least = infinity;
    for (const ContactPoint& contact : std::span(out_).subspan(first)) {
      least = std::min(least, contact.distance);
    }
    return -least;
  }

  void claim(std::size_t first, Real depth, bool is_turned) {
    if (depth > 0) {
      claims_.add(out_[first].normal, depth, is_turned);
      depth_ = is_turned ? depth_ : std::max(depth_, depth);
    }
  }

  void erase_deeper(std::size_t first, Real depth) {
    const auto begin = out_.begin() + static_cast<std::ptrdiff_t>(first);
    out_.erase(
        std::remove_if(begin, out_.end(), [&](const ContactPoint& contact) { return contact.distance < -depth; }),
        out_.end());
  }

  // Takes out what turned contacts claim too much.
  template <class OnTheWay>
  void settle_claims(const OnTheWay& on_the_way) {
    if (turned_.empty()) {
      return;
    }
    claims_.settle([&](const Vec3& direction) { return ways_.lowest_along(direction); });
    Real most = 0;  // what is still claimed
    for (Group& group : turned_.span()) {
      if (group.first < group.last) {
        const auto overlaps_along = [&](const Columns& directions, Lanes lowest) {
          return ways_.overlaps_along(group.part, directions, lowest);
        };
        group.claimed = std::min(
            group.depth, claims_.allowed_depth(out_[group.first].normal, group.depth, group.noise, overlaps_along));
        most = std::max(most, group.claimed);
      }
    }
    std::size_t kept = first_, next = first_;
    bool is_cut = false;  // whether the way out of the whole is shorter than a contact claims
    const PartingWay whole = way_out_of_whole(most, on_the_way);
    const auto keep = [&](std::size_t last, Real depth) {
      for (; next < last; ++next) {
        if (out_[next].distance >= -depth) {
          if (kept < next) {
            out_[kept] = out_[next];
          }
          ++kept;
        }
      }
    };
    for (const Group& group : turned_.span()) {
      const Real allowed = std::min(group.claimed, (1 + claim_blur) * whole.depth + group.noise);
      if (group.first < group.last && allowed < group.depth) {
        is_cut = is_cut || allowed < group.claimed;
        keep(group.first, infinity);
        keep(group.last, allowed);
      }
    }
    if (next > first_) {
      keep(out_.size(), infinity);
      out_.resize(kept);
    }
    if (is_cut) {
      append_way(whole, on_the_way);
    }
  }

  // The way that parts the whole may lead along no face that is met, and out of no triangle of its own. Its depth is
  // that of the last touch on it. Whether a contact was added: one that is deeper than all others.
  template <class OnTheWay>
  bool append_way(const PartingWay& whole, const OnTheWay& on_the_way) {
    const auto last = ways_.last_touch_deeper_than(std::max(depth_from(first_), Real{0}), whole, on_the_way);
    if (!last) {
      return false;
    }
    const std::size_t first = out_.size();
    const Vec3 &way = whole.direction, &point = last->touch.point;
    const auto& b = part_of(other_, last->part.number_of_b);
    const Feature feature_a{FeatureKind::face, 0}, feature_b = supporting_feature(b, ab_.rotation.undo(-way));
    // Other contacts may have the same features.
    out_.push_back({point + last->touch.depth * way, point, way, -last->touch.depth, feature_a, feature_b,
                    mixed(~contact_id(feature_a, feature_b))});
    name_parts(a_.part(last->part.number), last->part.number_of_b, first);
    return true;
  }

  // The shortest way out of all parts that b meets; without end where what turned contacts claim is no deeper than the
  // others. The ways of the claims themselves are no shorter, whatever rounding tells.
  template <class OnTheWay>
  [[nodiscard]] PartingWay way_out_of_whole(Real claimed, const OnTheWay& on_the_way) {
    if (claimed <= (1 + claim_blur) * depth_) {
      return {infinity, {0, 0, 0}};
    }
    return ways_.shortest(claimed / (1 + claim_blur), on_the_way);
  }
  // No way out of all is shorter than that of a triangle. Where all contacts are less deep than one that was left to
  // neighbours, the shortest way out of all tells the depth. What only touches has none. Where no contact touches, nor
  // is as near, the deepest one left counts after all. That has a number of its own: the same features may have met
  // under the normal of the face.
  template <class OnTheWay>
  void append_left(const OnTheWay& on_the_way) {
    if (!left_) {
      return;
    }
    const auto& b = part_of(other_, left_->part_of_b);
    const CoreSeparation& core = left_->found.core;
    const Real gap = core.distance - b.radius(), noise = left_->noise;
    if (core.overlap && std::max(depth_from(first_), Real{0}) < -gap - noise) {
      const PartingWay way = ways_.shortest(infinity, on_the_way);
      if (way.depth < infinity && append_way(way, on_the_way)) {
        return;
      }
    }
    if (-depth_from(first_) <= std::max(gap, Real{0}) + noise) {
      return;
    }
    const Triangle triangle = a_.part(left_->part_of_a);
    const std::size_t first = out_.size();
    append(triangle, b, left_->part_of_b, completed(triangle, b, ab_, left_->found), true);
    const auto found = std::span(out_).subspan(first);
    if (!found.empty()) {
      ContactPoint deepest = *std::ranges::min_element(found, {}, &ContactPoint::distance);
      deepest.id = mixed(~deepest.id);
      if (-deepest.distance > noise) {
        take_normal_of_face(triangle, b, deepest);
      }
      out_.resize(first);
      out_.push_back(deepest);
    }
  }

  // A way out that belongs to a neighbour is none of the surface; the one along the face is, where that is below.
  void take_normal_of_face(const Triangle& triangle, const B& b, ContactPoint& contact) const {
    const Vec3 normal = dot(contact.normal, triangle.normal()) < 0 ? -triangle.normal() : triangle.normal();
    const Real distance = dot(contact.point_b - contact.point_a, normal);
    const Vec3 point_a = contact.point_b - distance * normal;
    if (triangle.has_area() && is_over(triangle, point_a) && Fronts<B>(triangle, b, ab_).allows(normal)) {
      contact.normal = normal;
      contact.distance = distance;
      contact.point_a = point_a;
    }
  }

  const A& a_;
  const Other& other_;
  const Pose& ab_;
  const QuerySettings& settings_;
  Manifold& out_;
  std::size_t first_;
  Claims claims_;
  Real depth_ = 0;  // of the deepest contact that was not turned: all parts together are no less deep
  PartingWays<A, Other> ways_;
  SmallVector<Group, 96> turned_;
  std::optional<Left> left_;
};

}  // namespace abut

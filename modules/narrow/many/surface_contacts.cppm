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
import abut.narrow.many.parts_met;
import abut.narrow.many.triangle_contacts;
import abut.narrow.many.way_out;

export namespace abut {

// What a side is made of: its parts, or itself.
template <class S>
struct PartOf {
  using type = S;
};
template <Surface S>
struct PartOf<S> {
  using type = typename S::Part;
};

// The contacts of a surface with a convex shape, or with another surface, from those of their parts.
template <Surface A, class Other>
class SurfaceContacts {
 public:
  using B = typename PartOf<Other>::type;

  SurfaceContacts(const A& a, const Other& other, const Pose& ab, const QuerySettings& settings, Manifold& out)
      : a_(a), other_(other), ab_(ab), settings_(settings), out_(out), first_(out.size()) {}

  // `part_of_b`: the number of b where it is a part itself.
  void add(const Triangle& triangle, const B& b, std::uint32_t part_of_b) {
    const Real radii = b.radius();
    const TriangleSeparation found = begin_separation(triangle, b, ab_, settings_, settings_.margin + radii);
    const CoreSeparation& core = found.core;
    if (core.beyond || core.distance - radii > settings_.margin) {
      return;
    }
    const Fronts<B> fronts(triangle, b, ab_);
    const bool is_allowed = fronts.allows(core.normal);
    // Of a core that is beside or behind a triangle, only what its rounding has sunk in from the front counts.
    if (!is_allowed && !core.overlap &&
        !(core.distance < radii && dot(triangle.normal(), placed_centre(b, ab_) - triangle.corners()[0]) >= 0)) {
      return;
    }
    const Real noise = noise_of(core_size(triangle, b, ab_));
    bool turns_a = triangle.has_area() && !(is_allowed && leads_out(a_, triangle, core.normal, noise));
    bool turns_b = false;
    if constexpr (Surface<Other>) {
      turns_b = b.has_area() && !(is_allowed && leads_out(other_, b, -ab_.rotation.undo(core.normal), noise));
    }
    if constexpr (PointCored<B>) {
      if (!core.overlap) {
        add_point(triangle, b, part_of_b, found, is_allowed, turns_a);
        return;
      }
    }
    const std::size_t first = out_.size(), part = met_.add(triangle, b, ab_, fronts, core.distance - radii);
    if (!turns_a && !turns_b) {
      append(triangle, b, part_of_b, completed(triangle, b, ab_, found), true);
      turns_a = !leads_out_of_a(triangle, first, noise);
      if constexpr (Surface<Other>) {
        turns_b = !turns_a && !leads_out_of_b(b, first, noise);
      }
      if (!turns_a && !turns_b) {
        claim(first, false);
        return;
      }
      out_.resize(first);
    }
    if (is_allowed) {
      leave(triangle, part_of_b, found);
    }
    if (const auto turned = turn(triangle, b, core, fronts, turns_a, turns_b)) {
      // The closest points may lie beside the face: the foot of the lowest point of the other side.
      append(triangle, b, part_of_b, turned->separation, is_over_face(triangle, b, *turned));
      // What passes the plane of the triangle beside it and reaches under it is no overlap.
      if (is_allowed && !core.overlap) {
        erase_deeper(first, radii + 4 * core.rounding - core.distance);
      }
      claim(first, true);
    }
    turned_.push_back({first, out_.size(), part, depth_from(first), noise});
    met_.add_way(core.normal);
  }

  // To be called after the last part. `add_more`: adds parts that were passed over; it is called where there is no
  // contact otherwise.
  template <class AddMore>
  void finish(const AddMore& add_more) {
    settle_claims();
    if (out_.size() == first_) {
      add_more();
    }
    append_left();
  }
  void finish() {
    finish([] {});
  }

 private:
  // Contacts under the normal of a face, which may belong to a neighbour.
  struct Group {
    std::size_t first, last;
    std::size_t part;  // which of those that were met
    Real depth;        // of the deepest of them
    Real noise;        // of depths
  };
  // The deepest contact that was left to a neighbour across an edge.
  struct Left {
    std::uint32_t part_of_a, part_of_b;
    Vec3 normal;  // of part a
    TriangleSeparation found;
  };

  [[nodiscard]] decltype(auto) part_of_other(std::uint32_t index) const {
    if constexpr (Surface<Other>) {
      return other_.part(index);
    } else {
      return (other_);
    }
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
      leave(triangle, part_of_b, found);
    }
    const Vec3& normal = triangle.normal();
    const bool is_in_front = triangle.is_one_sided() || dot(normal, core.normal) >= 0;
    const CoreSeparation over = along_face(triangle, b, ab_, core, is_in_front ? normal : -normal);
    if (is_over(triangle, over.point_a)) {
      append(triangle, b, part_of_b, over, true);
    }
  }

  // Where two are equally deep, the order in which they came has no say.
  void leave(const Triangle& triangle, std::uint32_t part_of_b, const TriangleSeparation& found) {
    const auto key = [](Real distance, const Vec3& n, std::uint32_t part) {
      return std::tuple(distance, n.x, n.y, n.z, part);
    };
    if (!left_ || key(found.core.distance, triangle.normal(), part_of_b) <
                      key(left_->found.core.distance, left_->normal, left_->part_of_b)) {
      left_ = Left{triangle.index(), part_of_b, triangle.normal(), found};
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
        if ((!is_apart || dot(core.normal, direction) >= 0) && fronts.nearly_allows(direction)) {
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
  // over a neighbour that has them too.
  void append(const Triangle& triangle, const B& b, std::uint32_t part_of_b, const CoreSeparation& core,
              bool closest_count) {
    const std::size_t first = out_.size();
    contacts_under(triangle, b, ab_, core, settings_.margin, closest_count, out_);
    if (out_.size() > first) {
      met_.add_way(core.normal);
    }
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

  void claim(std::size_t first, bool is_turned) {
    const Real depth = depth_from(first);
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
  void settle_claims() {
    if (turned_.empty()) {
      return;
    }
    claims_.settle([&](const Vec3& direction) { return lowest_along(direction); });
    std::size_t kept = first_, next = first_;
    const Real whole = depth_of_whole();
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
      if (group.first == group.last) {
        continue;
      }
      const Vec3 normal = out_[group.first].normal;
      const Real claimed = claims_.allowed_depth(
          normal, group.depth, group.noise,
          [&](const Columns& directions, Lanes lowest) { return met_.overlaps_along(group.part, directions, lowest); });
      const Real allowed = std::min(claimed, (1 + claim_blur) * whole + group.noise);
      if (allowed < group.depth) {
        keep(group.first, infinity);
        keep(group.last, allowed);
      }
    }
    if (next > first_) {
      keep(out_.size(), infinity);
      out_.resize(kept);
    }
  }

  // How far b has to move to be parted from all parts that it meets; without end where no turned contact is deeper than
  // the others.
  [[nodiscard]] Real depth_of_whole() const {
    const Group* deepest = nullptr;
    for (const Group& group : turned_.span()) {
      if (group.depth > (deepest ? deepest->depth : 0)) {
        deepest = &group;
      }
    }
    if (!deepest || deepest->depth <= (1 + claim_blur) * depth_) {
      return infinity;
    }
    return met_.depth(
        claims_.sum_of_normals(), deepest->part, deepest->depth,
        [&](const Vec3& direction) { return lowest_along(direction); }, inner());
  }

  // Where b begins along a direction, unless it is made of parts: each knows its own.
  [[nodiscard]] Real lowest_along(const Vec3& direction) const {
    if constexpr (Surface<Other>) {
      return 0;
    } else {
      return dot(direction, placed_support(other_, place(other_, ab_), -direction).point) - other_.radius();
    }
  }

  // A point of b, which begins no later.
  [[nodiscard]] Vec3 inner() const {
    if constexpr (Surface<Other>) {
      return {0, 0, 0};
    } else {
      return placed_centre(other_, ab_);
    }
  }

  // Where no neighbour reports a contact, the deepest one left to them counts after all. It has a number of its own:
  // the same features may have met under the normal of the face.
  void append_left() {
    if (!left_ || out_.size() > first_) {
      return;
    }
    const Triangle triangle = a_.part(left_->part_of_a);
    const auto& b = part_of_other(left_->part_of_b);
    const std::size_t first = out_.size();
    append(triangle, b, left_->part_of_b, completed(triangle, b, ab_, left_->found), true);
    const auto found = std::span(out_).subspan(first);
    if (!found.empty()) {
      ContactPoint deepest = *std::ranges::min_element(found, {}, &ContactPoint::distance);
      deepest.id = mixed(~deepest.id);
      take_normal_of_face(triangle, b, deepest);
      out_.resize(first);
      out_.push_back(deepest);
    }
  }

  // A way out that belongs to a neighbour is none of the surface; the one along the face is, where that is below.
  void take_normal_of_face(const Triangle& triangle, const B& b, ContactPoint& contact) const {
    const Vec3 normal = dot(contact.normal, triangle.normal()) < 0 ? -triangle.normal() : triangle.normal();
    const Real distance = dot(contact.point_b - contact.point_a, normal);
    const Vec3 point_a = contact.point_b - distance * normal;
    if (triangle.has_area() && is_over(triangle, point_a) && Fronts<B>(triangle, b, ab_).nearly_allows(normal)) {
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
  PartsMet<B> met_;
  SmallVector<Group, 32> turned_;
  std::optional<Left> left_;
};

}  // namespace abut

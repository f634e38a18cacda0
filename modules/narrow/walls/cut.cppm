// SPDX-License-Identifier: Apache-2.0
// Contacts of a composite with holes: what is left of those with its solids, and those with walls and rims.
export module abut.narrow.walls.cut;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.walls.rim_point;

export namespace abut {

// Half the longest side of a child of a composite; 0 where it has no bounds.
template <class Composite>
[[nodiscard]] Real half_size_of(const Composite& composite, std::uint32_t child) {
  const Aabb box =
      std::visit([](const auto& shape) { return shape.aabb(Pose::identity()); }, *composite.children()[child].shape);
  return box.is_bounded() ? 0.5 * largest_magnitude(box.high - box.low) : 0;
}
// Of a place on a child that is found in several steps. `size`: of the numbers that tell where it is otherwise.
template <class Composite>
[[nodiscard]] Real noise_at(const Composite& composite, std::uint32_t child, Real size) {
  const Real of_child = largest_magnitude(composite.children()[child].pose.position) + half_size_of(composite, child);
  return 4 * noise_of(size + of_child);
}

// A solid child, a hole that cuts it, and a place near the rim of both.
struct RimSeed {
  std::uint32_t solid, hole;
  std::uint32_t number;  // among those of the same two
  Vec3 place;
};

// A composite against another shape, which is neither a composite nor made of scattered parts. Both are placed in one
// frame. The other shape knows its box, its distances to a point of its own frame and to a child, and its contacts with
// a hole. It also tells whether it is a sheet. A triangle or less tells whether it comes through a wall of a hole from
// inside.
template <class Composite, class Other>
class Carver {
 public:
  Carver(const Composite& composite, const Pose& pose, const Other& other, const Pose& other_pose)
      : composite_(composite), other_(other), pose_(pose), other_pose_(other_pose) {
    const Aabb box = other_.aabb(other_pose);
    centre_ = box.is_bounded() ? box.centre() : other_pose.position;
    reach_ = box.is_bounded() ? largest_magnitude(box.high - box.low) : 0;
    size_ = largest_magnitude(centre_) + largest_magnitude(pose.position) + reach_;
  }

  // Takes out the contacts with solids where there is a hole, and adds those with walls and rims. Normals lead from the
  // composite to the other shape.
  void carve(const QuerySettings& settings, Manifold& contacts, Manifold& added) {
    is_alone_ = true;
    carve_walls(settings, contacts, added);
    add_rims(settings, added);
  }

  // The same without those with rims, which the places where holes took contacts lead to. A part of a shape leaves them
  // to the whole.
  void carve_walls(const QuerySettings& settings, Manifold& contacts, Manifold& added) {
    for (const auto& hole : composite_.holes()) {
      add_walls(hole, settings, contacts, added);
    }
    std::erase_if(contacts, [&](const ContactPoint& contact) { return cut_of(contact) != Cut::none; });
  }
  [[nodiscard]] std::span<const RimSeed> seeds() const [[clang::lifetimebound]] { return seeds_; }
  // Places of one hole and solid that are near each other lead to the same rims.
  void add_rims_from(std::span<const RimSeed> seeds, const QuerySettings& settings, Manifold& added) {
    for (const RimSeed& seed : seeds) {
      const Real apart = half_size_of(seed.hole) / 2;
      const auto is_known = [&](const RimSeed& other) {
        return other.solid == seed.solid && other.hole == seed.hole && norm(other.place - seed.place) < apart;
      };
      if (std::ranges::none_of(seeds_, is_known)) {
        add_seed(seed.solid, seed.hole, seed.place);
      }
    }
    add_rims(settings, added);
  }

 private:
  using Hole = typename Composite::Hole;

  [[nodiscard]] Pose child_pose(std::uint32_t child) const { return pose_ * composite_.children()[child].pose; }
  [[nodiscard]] const auto& child(std::uint32_t number) const [[clang::lifetimebound]] {
    return *composite_.children()[number].shape;
  }
  [[nodiscard]] bool holds(std::uint32_t hole, const Vec3& point, Real inset) const {
    return child(hole).cavity_holds(child_pose(hole).undo(point), inset);
  }
  // The signed distance. Some shapes have no answer for a point.
  [[nodiscard]] std::optional<Distance> distance_to_child(std::uint32_t number, const Vec3& point) const {
    const Pose placed = child_pose(number);
    std::optional<Distance> found = child(number).distance_to(placed.undo(point));
    if (found) {
      move_by(*found, placed);
    }
    return found;
  }
  [[nodiscard]] Real half_size_of(std::uint32_t number) const { return abut::half_size_of(composite_, number); }
  // Children may be much larger than the other shape.
  [[nodiscard]] Real noise_at(std::uint32_t number) const { return abut::noise_at(composite_, number, size_); }
  [[nodiscard]] Real noise_at(const RimSeed& seed) const { return std::max(noise_at(seed.solid), noise_at(seed.hole)); }
  [[nodiscard]] bool is_in_solid(std::uint32_t solid, const Vec3& point, Real inset) const {
    const auto found = distance_to_child(solid, point);
    return found && found->distance <= -inset;
  }
  // Whether a point lies in a hole of a solid, other than the hole `but`.
  [[nodiscard]] bool is_in_hole_of(std::uint32_t solid, const Vec3& point, std::uint32_t but) const {
    return std::ranges::any_of(composite_.holes(), [&](const Hole& hole) {
      return hole.child != but && hole.begin <= solid && solid < hole.end &&
             holds(hole.child, point, noise_at(hole.child));
    });
  }
  // How far the other shape is from a child by itself: from a solid, whatever holes take of it, or from the walls of a
  // hole that it lies in. Some children have no answer.
  [[nodiscard]] std::optional<Real> gap_to(std::uint32_t number) {
    for (const auto& [known, gap] : gaps_) {
      if (known == number) {
        return gap;
      }
    }
    Distance found{};
    const Outcome outcome = other_.distance_from(child(number), child_pose(number), other_pose_, {}, found);
    return gaps_.emplace_back(number, outcome == Outcome::ok ? std::optional(found.distance) : std::nullopt).second;
  }
  // Whether the other shape lies in a hole of a solid, other than the hole `but`.
  [[nodiscard]] bool lies_in_hole_of(std::uint32_t solid, std::uint32_t but) {
    return std::ranges::any_of(composite_.holes(), [&](const Hole& hole) {
      return hole.child != but && hole.begin <= solid && solid < hole.end && gap_to(hole.child).value_or(0) > 0;
    });
  }
  // Whether a wall has material where a contact touches it: of a solid to which the other shape is as near. What lies
  // in another hole reaches beyond no wall.
  [[nodiscard]] bool has_material(const Hole& hole, const ContactPoint& contact) {
    for (std::uint32_t solid = hole.begin; solid < hole.end; ++solid) {
      if (!child(solid).is_hole() && is_in_solid(solid, contact.point_a, -noise_at(solid)) &&
          !is_in_hole_of(solid, contact.point_a, hole.child) &&
          gap_to(solid).value_or(-infinity) <= std::max(contact.distance, Real{0}) + noise_at(solid) &&
          !(contact.distance < 0 && lies_in_hole_of(solid, hole.child))) {
        return true;
      }
    }
    return false;
  }

  // Contacts with the walls of a hole that have material behind them. A wall does not count where the other shape comes
  // through the solid: it is not in the hole, or it is deeper in the wall than in the solid.
  void add_walls(const Hole& hole, const QuerySettings& settings, Manifold& solids, Manifold& walls) {
    const Pose placed = child_pose(hole.child);
    // One algorithm answers for walls, whatever algorithm was asked for.
    const QuerySettings own{.margin = settings.margin};
    Manifold found;
    const std::optional<Real> clearance = gap_to(hole.child);
    if (!clearance || other_.contacts_in(child(hole.child), placed, other_pose_, own, found) != Outcome::ok) {
      return;
    }
    const auto is_of_hole = [&](const ContactPoint& contact) {
      return hole.begin <= contact.child_a && contact.child_a < hole.end;
    };
    if (*clearance > 0) {
      std::erase_if(solids, is_of_hole);
    }
    Real deepest_wall = infinity;
    Manifold reached, beyond;
    for (ContactPoint& contact : found) {
      if (!reaches_from_inside(hole, contact)) {
        beyond.push_back(contact);
        continue;
      }
      if (has_material(hole, contact)) {
        name_wall(hole, contact);
        deepest_wall = std::min(deepest_wall, contact.distance);
        reached.push_back(contact);
      } else {
        add_seeds(hole, contact.point_b);
      }
    }
    Real deepest_solid = infinity;
    for (const ContactPoint& contact : solids) {
      if (is_of_hole(contact) && cut_of(contact) != Cut::of_surface) {
        deepest_solid = std::min(deepest_solid, contact.distance);
      }
    }
    // Contacts of a surface name some of the triangles that overlap.
    if (solids.empty()) {
      for (std::uint32_t solid = hole.begin; solid < hole.end; ++solid) {
        deepest_solid =
            child(solid).is_hole() ? deepest_solid : std::min(deepest_solid, gap_to(solid).value_or(infinity));
      }
    }
    // A touch counts, so that rounding does not decide whether the wall has material.
    const bool overlap_both = deepest_solid <= noise_at(hole.child) && deepest_wall < 0;
    if (overlap_both && deepest_wall < deepest_solid) {
      left_through_solid_.push_back(hole.child);
      return;
    }
    walls.insert(walls.end(), reached.begin(), reached.end());
    // What sticks out of the hole at both ends touches its rims alone. Moved into the cavity, it is out of the solid.
    const bool is_shorter_by_hole = reached.empty() && *clearance < 0 && deepest_solid < *clearance;
    // A flat body (point, segment, triangle) in the material leaves by the nearer wall, unless a sheet holds it.
    if (is_shorter_by_hole && is_alone_ && !beyond.empty()) {
      std::erase_if(beyond, [&](const ContactPoint& contact) { return !has_material(hole, contact); });
      if (beyond.empty()) {
        return;
      }
      for (ContactPoint& contact : beyond) {
        name_wall(hole, contact);
      }
      walls.insert(walls.end(), beyond.begin(), beyond.end());
    }
    if (overlap_both || is_shorter_by_hole) {
      std::erase_if(solids, [&](const ContactPoint& contact) { return is_of_hole(contact) && contact.distance < 0; });
    }
  }

  static void name_wall(const Hole& hole, ContactPoint& contact) {
    contact.child_a = hole.child;
    contact.id = contact_id_of_part(contact.id, hole.child);
  }

  // A sheet may lie beyond a wall without having come through it.
  [[nodiscard]] bool reaches_from_inside(const Hole& hole, const ContactPoint& contact) const {
    const Pose in_hole = relative(child_pose(hole.child), other_pose_);
    return contact.distance >= 0 ||
           other_.comes_through(child(hole.child), in_hole, contact.feature_a.index, noise_at(hole.child))
               .value_or(true);
  }

  // What a hole takes of a contact with a solid: the surface that it is on, or all, as the other shape lies in the
  // hole.
  enum class Cut : std::uint8_t { none, of_surface, of_inside };
  [[nodiscard]] Cut cut_of(const ContactPoint& contact) {
    for (const Hole& hole : composite_.holes()) {
      if (!(hole.begin <= contact.child_a && contact.child_a < hole.end)) {
        continue;
      }
      const Real noise = noise_at(hole.child);
      if (holds(hole.child, contact.point_a, noise)) {
        add_seeds(hole, contact.point_b);
        return Cut::of_surface;
      }
      const bool goes_through = std::ranges::find(left_through_solid_, hole.child) != left_through_solid_.end();
      if (!goes_through && contact.distance < 0 && holds(hole.child, contact.point_b, noise) &&
          holds(hole.child, centre_, noise)) {
        if (other_.is_sheet()) {
          add_seeds(hole, contact.point_b);  // it may go on past the rim
        }
        return Cut::of_inside;
      }
    }
    return Cut::none;
  }

  void add_seeds(const Hole& hole, const Vec3& place) {
    for (std::uint32_t solid = hole.begin; solid < hole.end; ++solid) {
      const auto is_known = [&](const RimSeed& seed) {
        return seed.solid == solid && seed.hole == hole.child && largest_magnitude(seed.place - place) == 0;
      };
      if (!child(solid).is_hole() && std::ranges::none_of(seeds_, is_known)) {
        add_seed(solid, hole.child, place);
      }
    }
  }
  void add_seed(std::uint32_t solid, std::uint32_t hole, const Vec3& place) {
    const auto is_of_both = [&](const RimSeed& seed) { return seed.solid == solid && seed.hole == hole; };
    seeds_.push_back({solid, hole, static_cast<std::uint32_t>(std::ranges::count_if(seeds_, is_of_both)), place});
  }

  // Searches start at every seed and at places around it, as far away as the hole is wide. The deepest result is
  // followed along the rim to where the rim is deepest.
  void add_rims(const QuerySettings& settings, Manifold& contacts) {
    constexpr std::array<Vec3, 7> around{
        {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    const std::size_t first = contacts.size();
    for (const RimSeed& seed : seeds_) {
      const Aabb box = std::visit([](const auto& shape) { return shape.aabb(Pose::identity()); }, child(seed.hole));
      const Vec3 half = 0.5 * (box.high - box.low);
      const Rotation turned = child_pose(seed.hole).rotation;
      const auto follow = [&](const RimContact& start) {
        const auto rim_near = [&](const Vec3& place) { return rim_point(seed, place); };
        const auto to_other = [&](const Vec3& place) { return distance_to_other(place); };
        return nearest_on_rim(start, std::min(reach_, 2 * half_size_of(seed.hole)), noise_at(seed), rim_near, to_other);
      };
      std::array<std::optional<RimContact>, around.size()> found;
      std::optional<RimContact> best;
      for (std::size_t i = 0; i < around.size(); ++i) {
        found[i] = rim_contact_near(
            seed, seed.place + turned * Vec3{around[i].x * half.x, around[i].y * half.y, around[i].z * half.z});
        // The rim may pierce a sheet in many places.
        if (found[i] && other_.is_sheet()) {
          found[i] = follow(*found[i]);
        }
        if (found[i] && (!best || found[i]->found.distance < best->found.distance)) {
          best = found[i];
        }
      }
      if (best) {
        add_rim(seed, follow(*best), around.size(), settings, contacts, first);
      }
      for (std::size_t i = 0; i < around.size(); ++i) {
        if (found[i]) {
          add_rim(seed, *found[i], i, settings, contacts, first);
        }
      }
    }
  }

  // The point of the rim near a place, and its distance to the other shape. Where they are apart: points of both that
  // are nearest to each other.
  [[nodiscard]] std::optional<RimContact> rim_contact_near(const RimSeed& seed, const Vec3& place) const {
    constexpr int rounds = 8;
    const Real noise = noise_at(seed);
    std::optional<RimContact> contact;
    Vec3 near = place;
    for (int round = 0; round < rounds; ++round) {
      const std::optional<RimPoint> rim = rim_point(seed, near);
      const std::optional<Distance> found = rim ? distance_to_other(rim->place) : std::nullopt;
      if (!found) {
        return std::nullopt;
      }
      contact = RimContact{*rim, *found};
      if (!(found->distance > 0) || largest_magnitude(found->point_b - near) <= noise) {
        break;
      }
      near = found->point_b;
    }
    return contact;
  }

  // `start`: which of the places around the seed led there.
  void add_rim(const RimSeed& seed, const RimContact& rim, std::size_t start, const QuerySettings& settings,
               Manifold& contacts, std::size_t first) const {
    const Vec3& place = rim.rim.place;
    constexpr Real same_share = 1e-6;  // of both sizes
    const auto is_same = [&](const ContactPoint& other) {
      return largest_magnitude(other.point_a - place) <= same_share * (size_ + half_size_of(seed.hole));
    };
    const bool is_pierced = other_.is_sheet() && rim.found.distance <= noise_at(seed);
    if (!(rim.found.distance <= settings.margin || is_pierced) || is_in_hole_of(seed.solid, place, seed.hole) ||
        std::ranges::any_of(std::span(contacts).subspan(first), is_same)) {
      return;
    }
    constexpr std::uint32_t starts = 8;
    const Feature edge{FeatureKind::edge, starts * seed.number + static_cast<std::uint32_t>(start)},
        whole{FeatureKind::whole, 0};
    ContactPoint contact{place, rim.found.point_b,      rim.found.normal, rim.found.distance, edge,
                         whole, contact_id(edge, whole)};
    if (is_pierced) {
      leave_material(seed, contact);
    }
    contact.child_a = seed.hole;
    contact.id = contact_id_of_part(contact_id_of_part(contact.id, seed.hole), seed.solid);
    contacts.push_back(contact);
  }

  // A sheet has no inside, so a rim that pierces it is no depth in it. Where the material is tells the side.
  void leave_material(const RimSeed& seed, ContactPoint& contact) const {
    const auto of_solid = distance_to_child(seed.solid, contact.point_a);
    const auto of_hole = distance_to_child(seed.hole, contact.point_a);
    if (of_solid && of_hole && dot(contact.normal, of_solid->normal + of_hole->normal) < 0) {
      contact.normal = -contact.normal;
    }
    contact.point_b = contact.point_a;
    contact.distance = 0;
  }

  [[nodiscard]] std::optional<RimPoint> rim_point(const RimSeed& seed, const Vec3& place) const {
    return rim_point_near(
        place, noise_at(seed), [&](const Vec3& at) { return distance_to_child(seed.solid, at); },
        [&](const Vec3& at) { return distance_to_child(seed.hole, at); });
  }
  // From a point of the composite.
  [[nodiscard]] std::optional<Distance> distance_to_other(const Vec3& point) const {
    std::optional<Distance> found = other_.distance_to(other_pose_.undo(point));
    if (found) {
      move_by(*found, other_pose_, true);
    }
    return found;
  }

  Composite composite_;
  Other other_;
  Pose pose_, other_pose_;
  Vec3 centre_{0, 0, 0};  // of the other shape
  Real reach_, size_;
  bool is_alone_ = false;  // no triangle of a surface
  std::vector<RimSeed> seeds_;
  std::vector<std::uint32_t> left_through_solid_;                    // holes out of whose walls the way is longer
  std::vector<std::pair<std::uint32_t, std::optional<Real>>> gaps_;  // to children, as they are asked for
};

// Whether a contact lies in a hole of the composite. Its normal leads from the composite to the other shape. What lies
// in a hole overlaps nothing.
template <class Composite>
[[nodiscard]] bool is_in_hole(const Composite& composite, const Pose& pose, const ContactPoint& contact) {
  const Real size = largest_magnitude(contact.point_a) + largest_magnitude(pose.position);
  return std::ranges::any_of(composite.holes(), [&](const auto& hole) {
    const auto& cavity = composite.children()[hole.child];
    const Real noise = noise_at(composite, hole.child, size);
    const auto holds = [&](const Vec3& point) {
      return cavity.shape->cavity_holds((pose * cavity.pose).undo(point), noise);
    };
    return hole.begin <= contact.child_a && contact.child_a < hole.end && hole.child != contact.child_a &&
           (holds(contact.point_a) || (contact.distance < 0 && holds(contact.point_b)));
  });
}

// Lets a point of a rim, which lies in a solid, leave through the wall of a hole. The wall is nearer than the surface.
template <class Composite>
void leave_by_nearer_wall(const Composite& composite, const Pose& pose, ContactPoint& contact) {
  if (contact.feature_b.kind != FeatureKind::edge || !(contact.distance < 0)) {
    return;
  }
  const std::uint32_t solid = contact.child_a;
  for (const auto& hole : composite.holes()) {
    const auto& cavity = composite.children()[hole.child];
    const Pose placed = pose * cavity.pose;
    std::optional<Distance> wall = cavity.shape->distance_to(placed.undo(contact.point_b));
    if (hole.begin <= solid && solid < hole.end && wall && wall->distance > contact.distance) {
      move_by(*wall, placed);
      contact.point_a = wall->point_a;
      contact.normal = wall->normal;
      contact.distance = wall->distance;
      contact.child_a = hole.child;
    }
  }
}

}  // namespace abut

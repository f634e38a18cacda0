// SPDX-License-Identifier: Apache-2.0
// Composites against anything: child by child, each pair of children by the table.
module abut.pairs.registry;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.walls.cut;
import abut.narrow.parts.nearest_of_parts;
import abut.pairs.composites.children;
import abut.pairs.composites.seams;
import abut.pairs.surfaces.surface_group;
import abut.pairs.rows.dispatch;

namespace abut {
namespace {

// Some children may have no answer, as two planes; no answer at all is one of the whole. Where an algorithm was asked
// for that does not know all pairs, those that it leaves out might be the nearest: then the whole has no answer either.
class Outcomes {
 public:
  explicit Outcomes(Algorithm algorithm) : are_all_needed_(algorithm != Algorithm::automatic) {}
  void add(Outcome outcome) {
    if (outcome == Outcome::ok) {
      any_ok_ = true;
    } else {
      last_ = outcome;
    }
  }
  [[nodiscard]] Outcome outcome() const {
    return any_ok_ && !are_all_needed_ ? Outcome::ok : last_.value_or(Outcome::ok);
  }

 private:
  bool are_all_needed_;
  bool any_ok_ = false;
  std::optional<Outcome> last_;
};

void flip(std::span<ContactPoint> contacts) {
  for (ContactPoint& contact : contacts) {
    move_by(contact, Pose::identity(), true);
  }
}

// What a composite with holes leaves of contacts that the holes of the other side added; normals point from the
// composite on.
void leave_by_holes(const AnyShape& composite, const Pose& pose, Manifold& contacts) {
  const auto leave = [&]<class S>(const S& shape) {
    if constexpr (Assembly<S>) {
      std::erase_if(contacts, [&](const ContactPoint& contact) { return is_in_hole(shape, pose, contact); });
      for (ContactPoint& contact : contacts) {
        leave_by_nearer_wall(shape, pose, contact);
      }
    }
  };
  std::visit(leave, composite);
}

// The contacts of the solids; then what the holes of either side leave of them and add to them. Either side is judged
// by all that the solids meet, so that it is the same whichever comes first; what one adds has to be left by the other.
void carve_both(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings, std::size_t first,
                Manifold& out) {
  const std::size_t count = out.size() - first;
  std::vector<bool> is_cut(count), is_cut_by_b(count);
  Manifold of_a, of_b;
  if (a.has_holes()) {
    carve(a, Pose::identity(), b, ab, settings, std::span(out).subspan(first), is_cut, of_a);
    flip(of_a);
    leave_by_holes(b, ab, of_a);
    flip(of_a);
  }
  if (b.has_holes()) {
    flip(std::span(out).subspan(first));
    carve(b, ab, a, Pose::identity(), settings, std::span(out).subspan(first), is_cut_by_b, of_b);
    flip(std::span(out).subspan(first));
    flip(of_b);
    leave_by_holes(a, Pose::identity(), of_b);
  }
  std::size_t left = first;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_cut[i] && !is_cut_by_b[i]) {
      out[left] = out[first + i];
      ++left;
    }
  }
  out.resize(left, ContactPoint{});
  out.insert(out.end(), of_a.begin(), of_a.end());
  out.insert(out.end(), of_b.begin(), of_b.end());
}

Outcome distance_of_pair(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                         const QuerySettings& settings, Distance& out) {
  return ask_in_order(a, b, pose_a, pose_b,
                      [&](const PairKernels<AnyShape>& kernels, const AnyShape& first, const AnyShape& second,
                          const Pose& first_pose, const Pose& second_pose, bool from_b) {
                        return kernels.distance(first, second, first_pose, second_pose, from_b, settings, out);
                      });
}

// The pairs of children whose boxes come within a reach.
ChildPairs pairs_of_children(const AnyShape& a, const AnyShape& b, const Pose& ab, Real reach) {
  ChildPairs pairs;
  visit_pairs_of_children(
      a, b, ab, reach,
      [&](const AnyShape& of_a, const Pose& pose_a, std::uint32_t child_a, const AnyShape& of_b, const Pose& pose_b,
          std::uint32_t child_b) { pairs.push_back({&of_a, &of_b, pose_a, pose_b, child_a, child_b}); });
  return pairs;
}

// In the frame of a. `with_nearest`: with the nearest points of every pair of children, which a contact may miss:
// surfaces push to their front only. Without an upper bound there are no such points. Many solids have contacts each,
// which tell theirs.
Outcome append_contacts_of_children(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                                    bool with_nearest, Manifold& out) {
  Outcomes outcomes(settings.algorithm);
  const std::size_t first = out.size();
  const auto take = [&](const ChildPair& pair) {
    const std::size_t begin = out.size();
    outcomes.add(contacts_of_pair(*pair.a, *pair.b, pair.pose_a, pair.pose_b, settings, out));
    Distance nearest{};
    const bool are_many = is_scattered(*pair.a) || is_scattered(*pair.b);
    if (with_nearest && !are_many &&
        distance_of_pair(*pair.a, *pair.b, pair.pose_a, pair.pose_b, settings, nearest) == Outcome::ok &&
        nearest.upper < infinity) {
      const Feature whole{FeatureKind::whole, 0};
      out.push_back(
          {nearest.point_a, nearest.point_b, nearest.normal, nearest.distance, whole, whole, contact_id(whole, whole)});
    }
    name_children(a, b, pair.child_a, pair.child_b, std::span(out).subspan(begin));
  };
  const auto take_group = [&](std::span<const ChildPair> group, bool is_surface_a) {
    const std::size_t begin = out.size();
    contacts_of_group(group, is_surface_a, settings, out);
    outcomes.add(Outcome::ok);
    for (ContactPoint& contact : std::span(out).subspan(begin)) {
      name_children(a, b, is_surface_a ? contact.child_a : group[0].child_a,
                    is_surface_a ? group[0].child_b : contact.child_b, {&contact, 1});
    }
  };
  ChildPairs pairs = pairs_of_children(a, b, ab, settings.margin);
  if (with_nearest || !may_group(settings)) {
    std::ranges::for_each(pairs.span(), take);
  } else {
    in_surface_groups(a, b, ab, pairs.span(), take, take_group);
  }
  if (!with_nearest) {
    const PlacedSide of_a{a, Pose::identity(), false}, of_b{b, ab, true};
    settle_seams(of_a, of_b, settings, first, out);
    settle_seams(of_b, of_a, settings, first, out);
  }
  if (a.has_holes() || b.has_holes()) {
    carve_both(a, b, ab, settings, first, out);
  }
  return outcomes.outcome();
}

// A surface by itself may have a way out that leads into one beside it.
void take_depth_of_groups(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                          Distance& best) {
  Distance deepest = no_distance();
  bool has_group = false;
  const auto take = [&](const ChildPair& pair) {
    Distance found{};
    if (distance_of_pair(*pair.a, *pair.b, pair.pose_a, pair.pose_b, settings, found) == Outcome::ok) {
      take_part(found, deepest);
    }
  };
  const auto take_group = [&](std::span<const ChildPair> group, bool is_surface_a) {
    Distance found{};
    if (depth_of_group(group, is_surface_a, settings, found)) {
      has_group = true;
      take_part(found, deepest);
    } else {
      std::ranges::for_each(group, take);
    }
  };
  ChildPairs pairs = pairs_of_children(a, b, ab, 0);
  in_surface_groups(a, b, ab, pairs.span(), take, take_group);
  best = has_group ? deepest : best;
}

// Convex children leave surfaces together. A child that overlaps fronts from behind alone is let through, and by itself
// tells the depth of a sheet, which may be deeper.
void take_depth_of_all(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                       Distance& best) {
  for (const bool is_surface_a : {true, false}) {
    Distance whole{};
    if (!depth_of_children(a, b, ab, is_surface_a, -best.distance, settings, whole)) {
      continue;
    }
    const ChildPairs pairs = pairs_of_children(a, b, ab, 0);
    const bool are_all = std::ranges::all_of(pairs.span(), [&](const ChildPair& pair) {
      const AnyShape& body = is_surface_a ? *pair.b : *pair.a;
      return (is_convex(body) || is_scattered(body)) && sides_of_surface(is_surface_a ? *pair.a : *pair.b);
    });
    if (are_all) {
      best = whole;
    } else {
      static_cast<void>(take_part(whole, best));
    }
  }
}

// The nearest or deepest pair of children, in the frame of a. What holes take away is still there.
Outcome distance_of_solids(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                           Distance& best) {
  best = no_distance();
  Outcomes outcomes(settings.algorithm);
  Real reach = infinity;
  visit_pairs_of_children(a, b, ab, reach,
                          [&](const AnyShape& of_a, const Pose& pose_a, std::uint32_t, const AnyShape& of_b,
                              const Pose& pose_b, std::uint32_t) {
                            Distance found{};
                            const Outcome outcome = distance_of_pair(of_a, of_b, pose_a, pose_b, settings, found);
                            outcomes.add(outcome);
                            if (outcome == Outcome::ok && take_part(found, best)) {
                              reach = found.distance;
                            }
                          });
  if (best.distance < 0 && may_group(settings)) {
    take_depth_of_groups(a, b, ab, settings, best);
    take_depth_of_all(a, b, ab, settings, best);
  }
  return outcomes.outcome();
}

// The holes that cut a child of a shape, and where they are.
template <class Visitor>
void visit_holes_of(const AnyShape& shape, const Pose& pose, std::uint32_t child, Visitor&& visit) {
  std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Assembly<S>) {
          for (const auto& hole : s.holes()) {
            if (hole.begin <= child && child < hole.end) {
              visit(*s.children()[hole.child].shape, pose * s.children()[hole.child].pose);
            }
          }
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

// A lower bound of the distance that knows holes. What a hole leaves of a solid lies around the cavity. So it is as far
// away as the walls of the cavity at least, whatever the solid is.
Real least_gap(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings) {
  Real least = infinity;
  visit_pairs_of_children(
      a, b, ab, least,
      [&](const AnyShape& of_a, const Pose& pose_a, std::uint32_t child_a, const AnyShape& of_b, const Pose& pose_b,
          std::uint32_t child_b) {
        Distance found{};
        Real lower = -infinity;
        if (distance_of_pair(of_a, of_b, pose_a, pose_b, settings, found) == Outcome::ok) {
          lower = found.lower;
        }
        const auto add_walls = [&](const AnyShape& hole, const Pose& hole_pose, const AnyShape& other,
                                   const Pose& other_pose) {
          if (lower < least && distance_of_pair(hole, other, hole_pose, other_pose, settings, found) == Outcome::ok) {
            lower = std::max(lower, found.lower);
          }
        };
        visit_holes_of(a, Pose::identity(), child_a,
                       [&](const AnyShape& hole, const Pose& pose) { add_walls(hole, pose, of_b, pose_b); });
        visit_holes_of(b, ab, child_b,
                       [&](const AnyShape& hole, const Pose& pose) { add_walls(hole, pose, of_a, pose_a); });
        least = std::min(least, lower);
      });
  return least;
}

// Of children that overlap another shape and are welded: each is overlapped no deeper than the whole, whose depth is
// that of its deepest contact.
void deepen_by_welds(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                     Distance& best) {
  Manifold contacts;
  const QuerySettings touching{.error_bound = settings.error_bound, .welds = true};
  static_cast<void>(append_contacts_of_children(a, b, ab, touching, false, contacts));
  const auto deepest = std::ranges::min_element(contacts, {}, &ContactPoint::distance);
  if (deepest != contacts.end() && deepest->distance <= best.distance) {
    best.distance = deepest->distance;
    best.lower = std::min(best.lower, deepest->distance);
    best.point_a = deepest->point_a;
    best.point_b = deepest->point_b;
    best.normal = deepest->normal;
  }
}

}  // namespace

// With holes: of all contacts however far, the one whose distance is nearest to that of the solids. Holes bring nothing
// nearer: what is deeper is a contact of a surface, which pushes out of the whole surface and not out of one triangle.
// Where solids overlap, so does the whole as long as any contact tells so. Of points that are equally near a hole may
// take some and leave others. So one algorithm chooses them, whatever algorithm was asked for.
Outcome children_distance(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                          const QuerySettings& settings, Distance& out) {
  const Pose ab = relative(pose_a, pose_b);
  Distance best{};
  Outcome outcome = distance_of_solids(a, b, ab, settings, best);
  if (outcome == Outcome::ok && (a.has_holes() || b.has_holes())) {
    const QuerySettings however_far{.error_bound = settings.error_bound, .margin = infinity};
    Manifold contacts;
    best.lower = std::max(best.lower, least_gap(a, b, ab, {}));
    outcome = append_contacts_of_children(a, b, ab, however_far, true, contacts);
    if (outcome == Outcome::ok && contacts.empty()) {
      // Nothing of the solids is left that could be met. The walls may prove more than the solids are apart.
      const Real more = std::max(best.lower - best.distance, Real{0});
      best.distance += more;
      best.point_b += more * best.normal;
      best.upper = infinity;
    } else if (outcome == Outcome::ok) {
      const ContactPoint& left = *std::ranges::min_element(contacts, {}, [&](const ContactPoint& contact) {
        const bool is_apart = best.distance < 0 && contact.distance > 0;
        return std::pair(is_apart, std::fabs(contact.distance - best.distance));
      });
      const bool is_of_solids = left.distance == best.distance;
      best = {left.distance,
              std::min(best.lower, left.distance),
              left.distance,
              left.point_a,
              left.point_b,
              left.normal,
              is_of_solids ? best.algorithm : Algorithm::hole,
              best.iterations};
    }
  }
  if (outcome == Outcome::ok && settings.welds && best.distance < 0 && !a.has_holes() && !b.has_holes()) {
    deepen_by_welds(a, b, ab, settings, best);
  }
  if (outcome == Outcome::ok) {
    move_by(best, pose_a, swapped);
    out = best;
  }
  return outcome;
}

Outcome children_contacts_in_frame(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                                   PairMemory*, Manifold& out) {
  return append_contacts_of_children(a, b, ab, settings, false, out);
}

Outcome children_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                          const QuerySettings& settings, Manifold& out) {
  const std::size_t first = out.size();
  const Outcome outcome = append_contacts_of_children(a, b, relative(pose_a, pose_b), settings, false, out);
  place_contacts(std::span(out).subspan(first), pose_a, {swapped, a.index() == b.index()});
  return outcome;
}

}  // namespace abut

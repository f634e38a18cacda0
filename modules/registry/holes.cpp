// Composites with holes: what their solids lose to the holes, the walls, and the rims where solids and holes end.
module abut.registry;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.narrowphase.hole;
import abut.narrowphase.parts;
import abut.shape;

namespace abut {

// Of a point outside, on or in a shape, in the frame of the shape.
std::optional<Distance> AnyShape::distance_to(const Vec3& point) const {
  return std::visit(
      [&]<class S>(const S& shape) -> std::optional<Distance> {
        if constexpr (Assembly<S>) {
          return std::nullopt;
        } else {
          Distance found{};
          const Pose placed{Rotation::identity(), point};
          return distance_by_route(shape, Ball(0), placed, {}, found) == Outcome::ok ? std::optional(found) : std::nullopt;
        }
      },
      *this);
}

bool AnyShape::is_hole() const {
  return std::visit([]<class S>(const S&) { return Hole<S>; }, *this);
}

bool AnyShape::cavity_holds(const Vec3& point, Real inset) const {
  return std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (Hole<S>) {
          return is_within(shape, point, inset);
        } else {
          return false;
        }
      },
      *this);
}

namespace {

// A solid child, a hole that cuts it, and a place near the rim where both end.
struct RimSeed {
  std::uint32_t solid, hole;
  Vec3 place;
};

// Everything below is in one frame, in which the composite lies at `pose` and the other shape, which is no
// composite, at `other_pose`.
template <class Composite>
class Carver {
 public:
  Carver(const Composite& composite, const Pose& pose, const AnyShape& other, const Pose& other_pose)
      : composite_(composite), other_(other), pose_(pose), other_pose_(other_pose) {
    const Aabb box = std::visit([&](const auto& shape) { return shape.aabb(other_pose); }, other_);
    centre_ = box.is_bounded() ? box.centre() : other_pose.position;
    size_ = largest_magnitude(centre_) + largest_magnitude(pose.position);
    size_ += box.is_bounded() ? largest_magnitude(box.high - box.low) : 0;
    noise_ = 256 * epsilon * size_;
  }

  // Contacts with the solids, then of what is left of them: normals from the composite to the other shape.
  void carve(const QuerySettings& settings, Manifold& contacts) {
    Manifold walls;
    for (const auto& hole : composite_.holes()) {
      add_walls(hole, settings, contacts, walls);
    }
    std::erase_if(contacts, [&](const ContactPoint& contact) { return is_cut_away(contact); });
    contacts.insert(contacts.end(), walls.begin(), walls.end());
    add_rims(settings, contacts);
  }

 private:
  using Hole = typename Composite::Hole;

  [[nodiscard]] Pose child_pose(std::uint32_t child) const { return pose_ * composite_.children()[child].pose; }
  [[nodiscard]] const AnyShape& child(std::uint32_t number) const [[clang::lifetimebound]] { return *composite_.children()[number].shape; }
  [[nodiscard]] bool holds(std::uint32_t hole, const Vec3& point, Real inset) const {
    return child(hole).cavity_holds(child_pose(hole).undo(point), inset);
  }
  // Signed; nothing where the shape has no answer for a point.
  [[nodiscard]] std::optional<Distance> distance_to_child(std::uint32_t number, const Vec3& point) const {
    const Pose placed = child_pose(number);
    std::optional<Distance> found = child(number).distance_to(placed.undo(point));
    if (found) {
      move_by(*found, placed);
    }
    return found;
  }
  [[nodiscard]] bool is_in_solid(std::uint32_t solid, const Vec3& point, Real inset) const {
    const auto found = distance_to_child(solid, point);
    return found && found->distance <= -inset;
  }
  // Of a solid: in a hole other than `but` that cuts it.
  [[nodiscard]] bool is_in_hole_of(std::uint32_t solid, const Vec3& point, std::uint32_t but) const {
    return std::ranges::any_of(composite_.holes(), [&](const Hole& hole) {
      return hole.child != but && hole.begin <= solid && solid < hole.end && holds(hole.child, point, noise_);
    });
  }
  // A solid that there is material of at a point on the wall of a hole.
  [[nodiscard]] std::optional<std::uint32_t> material_at(const Hole& hole, const Vec3& point) const {
    for (std::uint32_t solid = hole.begin; solid < hole.end; ++solid) {
      if (!child(solid).is_hole() && is_in_solid(solid, point, -noise_) && !is_in_hole_of(solid, point, hole.child)) {
        return solid;
      }
    }
    return std::nullopt;
  }

  // Contacts with the walls of a hole where there is material behind them. What the other shape does not reach
  // from inside, or reaches deeper than it lies in the solid, it reaches through the solid.
  void add_walls(const Hole& hole, const QuerySettings& settings, Manifold& solids, Manifold& walls) {
    const Pose placed = child_pose(hole.child);
    // Walls have one way, whatever way was asked for between the solids.
    const QuerySettings own{.margin = settings.margin};
    Manifold found;
    Distance whole{};
    if (ask(hole.child, placed, own, found) != Outcome::ok || ask(hole.child, placed, own, whole) != Outcome::ok) {
      return;
    }
    const auto is_of_hole = [&](const ContactPoint& contact) { return hole.begin <= contact.child_a && contact.child_a < hole.end; };
    if (whole.distance > 0) {
      std::erase_if(solids, is_of_hole);
    }
    Manifold reached;
    for (ContactPoint& contact : found) {
      if (!reaches_from_inside(contact)) {
        continue;
      }
      if (material_at(hole, contact.point_a)) {
        contact.child_a = hole.child;
        contact.id = contact_id_of_child(contact.id, hole.child);
        reached.push_back(contact);
      } else if (contact.distance < 0) {
        add_seeds(hole, contact.point_b);
      }
    }
    // Particles are judged one by one: they are the children of the other shape.
    for (const ContactPoint& wall : reached) {
      const auto is_of_child = [&](const ContactPoint& contact) { return contact.child_b == wall.child_b; };
      Real deepest_solid = infinity, deepest_wall = infinity;
      for (const ContactPoint& contact : reached) {
        deepest_wall = is_of_child(contact) ? std::min(deepest_wall, contact.distance) : deepest_wall;
      }
      for (const ContactPoint& contact : solids) {
        if (is_of_child(contact) && is_of_hole(contact) && !is_cut_away(contact)) {
          deepest_solid = std::min(deepest_solid, contact.distance);
        }
      }
      const bool overlap_both = deepest_solid < 0 && deepest_wall < 0;
      if (overlap_both && deepest_wall < deepest_solid) {
        continue;
      }
      walls.push_back(wall);
      if (overlap_both) {
        std::erase_if(solids, [&](const ContactPoint& contact) {
          return is_of_child(contact) && is_of_hole(contact) && contact.distance < 0;
        });
      }
    }
  }

  // What pokes through a wall holds the point of it that it went through; else it lies somewhere outside of the cavity.
  [[nodiscard]] bool reaches_from_inside(const ContactPoint& contact) const {
    if (contact.distance >= 0) {
      return true;
    }
    return std::visit(
        [&]<class S>(const S& shape) {
          if constexpr (Scattered<S>) {
            return contact.distance + 2 * shape.part(contact.child_b).radius() > noise_;
          } else {
            const auto found = other_.distance_to(other_pose_.undo(contact.point_a));
            return found && found->distance <= noise_;
          }
        },
        other_);
  }

  [[nodiscard]] Vec3 centre_of(const ContactPoint& contact) const {
    return std::visit(
        [&]<class S>(const S& shape) {
          if constexpr (Scattered<S>) {
            return contact.point_b + shape.part(contact.child_b).radius() * contact.normal;
          } else {
            return centre_;
          }
        },
        other_);
  }

  // A contact with a solid at a place that a hole took, or of a shape that lies in a hole.
  [[nodiscard]] bool is_cut_away(const ContactPoint& contact) {
    for (const Hole& hole : composite_.holes()) {
      if (!(hole.begin <= contact.child_a && contact.child_a < hole.end)) {
        continue;
      }
      if (holds(hole.child, contact.point_a, noise_)) {
        add_seeds(hole, contact.point_b);
        return true;
      }
      if (holds(hole.child, contact.point_b, noise_) && holds(hole.child, centre_of(contact), noise_)) {
        return true;
      }
    }
    return false;
  }

  void add_seeds(const Hole& hole, const Vec3& place) {
    for (std::uint32_t solid = hole.begin; solid < hole.end; ++solid) {
      if (!child(solid).is_hole()) {
        seeds_.push_back({solid, hole.child, place});
      }
    }
  }

  // From every seed and from places around it, as far as the hole is wide.
  void add_rims(const QuerySettings& settings, Manifold& contacts) {
    const std::size_t first = contacts.size();
    for (const RimSeed& seed : seeds_) {
      const Aabb box = std::visit([&](const auto& shape) { return shape.aabb(child_pose(seed.hole)); }, child(seed.hole));
      const Vec3 half = 0.5 * (box.high - box.low);
      constexpr std::array<std::array<Real, 3>, 7> around{{{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
      for (std::uint32_t i = 0; i < around.size(); ++i) {
        const Vec3 place = seed.place + Vec3{around[i][0] * half.x, around[i][1] * half.y, around[i][2] * half.z};
        add_rim(seed, place, i, settings, contacts, first);
      }
    }
  }

  void add_rim(const RimSeed& seed, const Vec3& place, std::uint32_t number, const QuerySettings& settings, Manifold& contacts,
               std::size_t first) {
    constexpr int rounds = 8;
    Vec3 near = place;
    std::optional<Vec3> rim;
    std::optional<Distance> found;
    for (int round = 0; round < rounds; ++round) {
      rim = rim_near(seed, near);
      if (!rim) {
        return;
      }
      found = other_.distance_to(other_pose_.undo(*rim));
      if (!found) {
        return;
      }
      move_by(*found, other_pose_, true);
      if (largest_magnitude(found->point_b - near) <= noise_) {
        break;
      }
      near = found->point_b;
    }
    if (!(found->distance <= settings.margin) || is_in_hole_of(seed.solid, *rim, seed.hole)) {
      return;
    }
    const auto is_same = [&](const ContactPoint& other) { return largest_magnitude(other.point_a - *rim) <= 1e-6 * size_; };
    if (std::ranges::any_of(std::span(contacts).subspan(first), is_same)) {
      return;
    }
    const Feature edge{FeatureKind::edge, number}, whole{FeatureKind::whole, 0};
    ContactPoint contact{*rim, found->point_b, found->normal, found->distance, edge, whole, contact_id(edge, whole)};
    contact.child_a = seed.hole;
    contact.id = contact_id_of_child(contact_id_of_child(contact.id, seed.hole), seed.solid);
    contacts.push_back(contact);
  }

  // The point of the rim near a place: on the surfaces of both by Newton steps within their tangent planes, then
  // along the rim towards the place.
  [[nodiscard]] std::optional<Vec3> rim_near(const RimSeed& seed, const Vec3& place) const {
    constexpr int steps = 48;
    Vec3 at = place;
    for (int step = 0; step < steps; ++step) {
      const auto solid = distance_to_child(seed.solid, at), hole = distance_to_child(seed.hole, at);
      if (!solid || !hole) {
        return std::nullopt;
      }
      const Vec3 &n = solid->normal, &m = hole->normal;
      const Real cosine = dot(n, m), square = 1 - cosine * cosine;
      if (!(square > 1e-12)) {
        return std::nullopt;
      }
      const Real to_solid = -solid->distance, to_wall = -hole->distance;
      const Vec3 onto = ((to_solid - cosine * to_wall) / square) * n + ((to_wall - cosine * to_solid) / square) * m;
      const Vec3 along = UnitVec3::make(cross(n, m)).value_or(UnitVec3::axis_z());
      const Vec3 move = onto + dot(place - at, along) * along;
      at += move;
      if (largest_magnitude(move) <= noise_) {
        return at;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] Outcome ask(std::uint32_t hole, const Pose& placed, const QuerySettings& settings, Manifold& found) const {
    const bool from_b = other_.index() < child(hole).index();
    const AnyShape &one = from_b ? other_ : child(hole), &two = from_b ? child(hole) : other_;
    return pair_kernels(one.index(), two.index())
        .contacts(one, two, from_b ? other_pose_ : placed, from_b ? placed : other_pose_, from_b, settings, found);
  }
  [[nodiscard]] Outcome ask(std::uint32_t hole, const Pose& placed, const QuerySettings& settings, Distance& found) const {
    const bool from_b = other_.index() < child(hole).index();
    const AnyShape &one = from_b ? other_ : child(hole), &two = from_b ? child(hole) : other_;
    return pair_kernels(one.index(), two.index())
        .distance(one, two, from_b ? other_pose_ : placed, from_b ? placed : other_pose_, from_b, settings, found);
  }

  Composite composite_;
  AnyShape other_;
  Pose pose_, other_pose_;
  Vec3 centre_{0, 0, 0};  // of the other shape
  Real size_, noise_;
  std::vector<RimSeed> seeds_;
};

}  // namespace

// `contacts` are those of the composite's solids with one shape, and become those of what the holes leave.
void carve(const AnyShape& composite, const Pose& pose, const AnyShape& other, const Pose& other_pose, const QuerySettings& settings,
           Manifold& contacts) {
  std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (Assembly<S>) {
          Carver<S>(shape, pose, other, other_pose).carve(settings, contacts);
        }
      },
      composite);
}

}  // namespace abut

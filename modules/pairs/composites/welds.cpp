// SPDX-License-Identifier: Apache-2.0
module abut.pairs.composites.welds;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.ways.continuation;
import abut.narrow.ways.least_translation;
import abut.pairs.registry;
import abut.pairs.composites.children;
import abut.pairs.composites.seam_parts;

namespace abut {
namespace {

// Of unit normals that count as the same one.
constexpr Real same_direction = 1e-9;
[[nodiscard]] bool is_same(const Vec3& one, const Vec3& other) {
  return largest_magnitude(one - other) <= same_direction;
}

[[nodiscard]] Vec3 normal_of(const Seam& seam, const ContactPoint& contact) {
  return seam.is_b ? -contact.normal : contact.normal;
}
[[nodiscard]] const Vec3& point_on(const Seam& seam, const ContactPoint& contact) {
  return seam.is_b ? contact.point_b : contact.point_a;
}

class [[gsl::Pointer]] Weld {
 public:
  Weld(std::span<Seam> seams, const BodyAtSeams& body)
      : seams_(seams), body_(body), body_size_(half_size_of(body.shape)) {
    for (const Seam& seam : seams) {
      sizes_.push_back(std::min(body_size_, half_size_of(*seam.part)));
    }
  }

  void run() {
    list_sides();
    if (has_one_normal()) {
      return;
    }
    bool are_all_outside = true;
    for (Side& side : sides_) {
      side.is_outside = is_outside(side);
      are_all_outside = are_all_outside && side.is_outside;
    }
    if (are_all_outside) {
      return;
    }
    const Vec3 way = way_out_of_sides(false).value_or(Vec3{0, 0, 0});
    for (std::size_t seam = 0; seam < seams_.size(); ++seam) {
      const auto is_within = [&](const Side& side) { return side.seam == seam && !side.is_outside; };
      if (std::ranges::any_of(sides_, is_within)) {
        settle(seam, way);
      }
    }
  }

 private:
  // The contacts of a part under one normal, which leads out of it.
  struct Side {
    std::size_t seam;
    Vec3 normal;
    Real least;  // distance
    bool is_outside = true;
  };

  void list_sides() {
    for (std::size_t seam = 0; seam < seams_.size(); ++seam) {
      for (const ContactPoint& contact : seams_[seam].contacts) {
        if (Side* known = side_of(seam, normal_of(seams_[seam], contact))) {
          known->least = std::min(known->least, contact.distance);
        } else {
          sides_.push_back({seam, normal_of(seams_[seam], contact), contact.distance});
        }
      }
    }
  }
  [[nodiscard]] Side* side_of(std::size_t seam, const Vec3& normal) {
    for (Side& side : sides_) {
      if (side.seam == seam && is_same(side.normal, normal)) {
        return &side;
      }
    }
    return nullptr;
  }

  // Most bodies on a floor. The part that reaches furthest along the only normal has its contacts outside.
  [[nodiscard]] bool has_one_normal() const {
    return std::ranges::all_of(sides_, [&](const Side& side) { return is_same(side.normal, sides_.front().normal); });
  }

  // Whether one of the contacts lies where the outside of the whole is that of the part. A region reaches over faces
  // that lean from the normal; only what lies furthest along it tells whose the normal is.
  [[nodiscard]] bool is_outside(const Side& side) const {
    const Seam& own = seams_[side.seam];
    const auto is_of_side = [&](const ContactPoint& contact) { return is_same(normal_of(own, contact), side.normal); };
    Real furthest = -infinity;
    for (const ContactPoint& contact : own.contacts) {
      furthest = is_of_side(contact) ? std::max(furthest, dot(side.normal, point_on(own, contact))) : furthest;
    }
    const Real least = furthest - same_direction * sizes_[side.seam] - noise_of(std::fabs(furthest));
    return std::ranges::any_of(own.contacts, [&](const ContactPoint& contact) {
      const Vec3& point = point_on(own, contact);
      return is_of_side(contact) && dot(side.normal, point) >= least &&
             is_outside_around(side.seam, point, side.normal);
    });
  }
  // At the point, or beside it on the face or the edge that it lies on: on the border of a face a neighbour may rise
  // beside it, or cover all of it.
  [[nodiscard]] bool is_outside_around(std::size_t own, const Vec3& point, const Vec3& normal) const {
    if (!is_passed(own, point, normal)) {
      return true;
    }
    constexpr Real diagonal = 0.70710678118654752;
    const Tangents tangents = tangents_of(normal);
    const Vec3 first = stride(own) * tangents.first, second = stride(own) * tangents.second,
               both = diagonal * (first + second), across = diagonal * (first - second);
    const Seam& seam = seams_[own];
    return std::ranges::any_of(
        std::array{first, second, both, across, -first, -second, -both, -across}, [&](const Vec3& aside) {
          const Vec3 beside = point + aside;
          return lies_on(*seam.part, seam.pose.undo(beside), sizes_[own]) && !is_passed(own, beside, normal);
        });
  }
  // Further than what counts as a crack.
  [[nodiscard]] Real stride(std::size_t own) const { return 4 * crack_share * sizes_[own]; }

  // Whether another part goes on past a point of a part.
  [[nodiscard]] bool is_passed(std::size_t own, const Vec3& point, const Vec3& normal) const {
    for (std::size_t other = 0; other < seams_.size(); ++other) {
      if (other != own && goes_on_past(seams_[other], point, normal, std::min(sizes_[own], sizes_[other]))) {
        return true;
      }
    }
    return false;
  }
  // A surface that the body touches stands for what is under it: as deep as the body is in it, and a stride more.
  [[nodiscard]] static bool goes_on_past(const Seam& other, const Vec3& point, const Vec3& normal, Real size) {
    const Vec3 direction = other.pose.rotation.undo(normal);
    if (goes_on_at(*other.part, other.pose.undo(point), direction, size)) {
      return true;
    }
    return is_surface(*other.part) && std::ranges::any_of(other.contacts, [&](const ContactPoint& contact) {
             const Vec3 up = normal_of(other, contact);
             const Real under = dot(point_on(other, contact) - point, up);
             return under > 0 && under <= 8 * crack_share * size - contact.distance &&
                    goes_on_at(*other.part, other.pose.undo(point + under * up), direction, size);
           });
  }

  // The shortest move that leaves what is outside, or along their normals all parts.
  [[nodiscard]] std::optional<Vec3> way_out_of_sides(bool of_all) const {
    constexpr std::size_t most_planes = 8;
    SmallVector<HalfSpaceToLeave, most_planes> planes;
    for (const Side& side : sides_) {
      if ((of_all || side.is_outside) && side.least < 0) {
        add_plane({side.normal, -side.least}, planes);
      }
    }
    return planes.empty() ? Vec3{0, 0, 0} : least_translation(planes.span());
  }

  void settle(std::size_t own, const Vec3& way) {
    if (is_apart(own, contacts_after(own, way))) {
      replace(own, way, nullptr);
      return;
    }
    const std::optional<Way> out = way_out(own, way);
    const std::optional<Vec3> along_all = way_out_of_sides(true);
    const bool is_longer = out && along_all && norm(*along_all) < (1 - same_direction) * norm(out->move);
    if (out && !is_longer && side_of(own, out->normal) == nullptr) {
      replace(own, out->move, &out->normal);
    }
  }

  // Contacts of the body with a part, where the body has moved; they are far enough to reach back.
  [[nodiscard]] Manifold contacts_after(std::size_t own, const Vec3& move) const {
    const Seam& seam = seams_[own];
    const Pose there{body_.pose.rotation, body_.pose.position + move};
    const QuerySettings settings{.margin = std::max(seam.margin, Real{0}) + norm(move), .welds = true};
    Manifold found;
    static_cast<void>(seam.is_b ? contacts_of_pair(body_.shape, *seam.part, there, seam.pose, settings, found)
                                : contacts_of_pair(*seam.part, body_.shape, seam.pose, there, settings, found));
    return found;
  }
  [[nodiscard]] bool is_apart(std::size_t own, const Manifold& contacts) const {
    const Real noise = 1e-9 * sizes_[own] + noise_of(largest_magnitude(body_.pose.position));
    return std::ranges::all_of(contacts, [&](const ContactPoint& contact) { return contact.distance >= -noise; });
  }
  [[nodiscard]] bool is_apart_after(const Vec3& move) const {
    for (std::size_t seam = 0; seam < seams_.size(); ++seam) {
      if (!is_apart(seam, contacts_after(seam, move))) {
        return false;
      }
    }
    return true;
  }

  // What is outside stays. Under each other normal of the outside comes what the body is next to after a move. A body
  // that leans is next to no face; then what it has under the face comes.
  void replace(std::size_t own, const Vec3& move, const Vec3* more) {
    Seam& seam = seams_[own];
    const Manifold before = seam.contacts;
    std::erase_if(seam.contacts, [&](const ContactPoint& contact) {
      const Side* const side = side_of(own, normal_of(seam, contact));
      return side != nullptr && !side->is_outside;
    });
    std::vector<Vec3> normals;
    const auto list = [&](const Vec3& normal) {
      const auto is_known = [&](const Vec3& known) { return is_same(known, normal); };
      if (side_of(own, normal) == nullptr && std::ranges::none_of(normals, is_known)) {
        normals.push_back(normal);
      }
    };
    if (more != nullptr) {
      list(*more);
    }
    for (const Side& side : sides_) {
      if (side.is_outside) {
        list(side.normal);
      }
    }
    // What is nearest to bodies that touch is rounding.
    const auto along = UnitVec3::make(move);
    const Vec3 beyond = along ? move + stride(own) * along->vec() : move;
    const Manifold found = contacts_after(own, beyond);
    for (const Vec3& normal : normals) {
      const std::size_t count = seam.added.size();
      for (const ContactPoint& contact : found) {
        if (is_same(normal_of(seam, contact), normal)) {
          add(seam, contact, normal, beyond);
        }
      }
      if (seam.added.size() == count) {
        add_under_face(own, before, normal);
      }
    }
  }
  // As the body lies before the move.
  static void add(Seam& seam, const ContactPoint& found, const Vec3& outward, const Vec3& move) {
    ContactPoint contact = found;
    contact.normal = seam.is_b ? -outward : outward;
    contact.distance = found.distance - dot(move, outward);
    if (!(contact.distance <= seam.margin)) {
      return;
    }
    if (seam.is_b) {
      contact.point_a = contact.point_a - move;
      contact.point_b = contact.point_a + contact.distance * contact.normal;
    } else {
      contact.point_b = contact.point_b - move;
      contact.point_a = contact.point_b - contact.distance * contact.normal;
    }
    seam.added.push_back(contact);
  }
  // Contacts with the half-space under the face of a part, where they lie on the part.
  void add_under_face(std::size_t own, const Manifold& before, const Vec3& normal) const {
    Seam& seam = seams_[own];
    const Vec3 direction = seam.pose.rotation.undo(normal);
    const std::optional<AnyShape> ground = half_space_under(direction, height_of_face(seam, before, direction));
    if (!ground) {
      return;
    }
    Manifold found;
    const QuerySettings settings{.margin = seam.margin};
    static_cast<void>(seam.is_b ? contacts_of_pair(body_.shape, *ground, body_.pose, seam.pose, settings, found)
                                : contacts_of_pair(*ground, body_.shape, seam.pose, body_.pose, settings, found));
    const Feature face = face_along(*seam.part, direction);
    const std::size_t of_part = seam.part->index(), of_body = body_.shape.index();
    const bool is_part_first = seam.is_b ? of_part < of_body : of_part <= of_body;
    for (ContactPoint& contact : found) {
      if (holds_at(*seam.part, seam.pose.undo(point_on(seam, contact)), sizes_[own])) {
        (seam.is_b ? contact.feature_b : contact.feature_a) = face;
        const Feature& other = seam.is_b ? contact.feature_a : contact.feature_b;
        contact.id = !is_packed(contact.id) ? contact_id_of_part(contact.id, face.index)
                     : is_part_first        ? contact_id(face, other)
                                            : contact_id(other, face);
        add(seam, contact, normal, {0, 0, 0});
      }
    }
  }
  // Of a surface, where the contacts are that give way. In the frame of the part.
  [[nodiscard]] static Real height_of_face(const Seam& seam, const Manifold& before, const Vec3& direction) {
    if (!is_surface(*seam.part)) {
      return reach_along(*seam.part, direction);
    }
    Real height = -infinity;
    for (const ContactPoint& contact : before) {
      height = std::max(height, dot(direction, seam.pose.undo(point_on(seam, contact))));
    }
    return height;
  }

  struct Way {
    Vec3 normal, move;
    Real length;
  };
  // Of a body that overlaps a part after the way out of the rest: on along the normal that needs least of those that
  // part it from all.
  [[nodiscard]] std::optional<Way> way_out(std::size_t own, const Vec3& way) const {
    const Seam& seam = seams_[own];
    std::vector<Way> ways;
    const auto offer = [&](const Vec3& normal, Real length) {
      if (std::isfinite(length) && length > 0) {
        ways.push_back({normal, way + length * normal, length});
      }
    };
    const auto height_of_body = [&](const Vec3& normal) {
      return dot(normal, body_.pose.position + way) - reach_along(body_.shape, body_.pose.rotation.undo(-normal));
    };
    const auto offer_support = [&](const Vec3& normal) {
      const Real top = dot(normal, seam.pose.position) + reach_along(*seam.part, seam.pose.rotation.undo(normal));
      offer(normal, top - height_of_body(normal));
    };
    for (const Side& side : sides_) {
      if (side.seam == own) {
        offer(side.normal, -side.least - dot(way, side.normal));
      } else {
        offer_support(side.normal);
      }
    }
    const ContactPoint& deepest = *std::ranges::min_element(seam.contacts, {}, &ContactPoint::distance);
    const Vec3 point = point_on(seam, deepest);
    for (const Vec3& face :
         faces_of(*seam.part, seam.pose.undo(point), seam.pose.rotation.undo(normal_of(seam, deepest)), sizes_[own])) {
      const Vec3 normal = seam.pose.rotation * face;
      if (is_surface(*seam.part)) {
        offer(normal, dot(normal, point) - height_of_body(normal));
      } else {
        offer_support(normal);
      }
    }
    std::ranges::sort(ways, {},
                      [](const Way& its) { return std::tuple(its.length, its.normal.x, its.normal.y, its.normal.z); });
    for (const Way& its : ways) {
      if (is_apart_after(its.move)) {
        return its;
      }
    }
    return std::nullopt;
  }

  std::span<Seam> seams_;
  const BodyAtSeams& body_;
  Real body_size_;
  std::vector<Real> sizes_;  // of the smaller one of each part and the body
  std::vector<Side> sides_;
};

}  // namespace

void weld(std::span<Seam> seams, const BodyAtSeams& body) { Weld(seams, body).run(); }

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
module abut.pairs.composites.seams;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.registry;
import abut.pairs.composites.children;

namespace abut {
namespace {

// A contact as a surface sees it: in its frame, with the normal that leads out of it.
struct Seen {
  Vec3 point, normal;
};
Seen seen_by(const Seam& own, const Seam& other, const ContactPoint& contact) {
  const Vec3 normal = own.is_b ? -contact.normal : contact.normal;
  return {other.pose.undo(own.is_b ? contact.point_b : contact.point_a), other.pose.rotation.undo(normal)};
}

bool has_own_face(const Seam& own, const ContactPoint& contact, Real size) {
  const Seen seen = seen_by(own, own, contact);
  return has_face_at(*own.part, seen.point, seen.normal, size);
}

// The contact under the normal of the face that it lies on, as deep as the body is below that there.
std::optional<ContactPoint> turned_to_face(const Seam& own, const ContactPoint& contact, Real size) {
  const Seen seen = seen_by(own, own, contact);
  const std::vector<Vec3> faces = faces_of(*own.part, seen.point, seen.normal, size);
  if (faces.empty()) {
    return std::nullopt;
  }
  ContactPoint turned = contact;
  const Vec3 normal = own.pose.rotation * faces.front();
  turned.normal = own.is_b ? -normal : normal;
  turned.distance = dot(contact.point_b - contact.point_a, turned.normal);
  if (own.is_b) {
    turned.point_b = contact.point_a + turned.distance * turned.normal;
  } else {
    turned.point_a = contact.point_b - turned.distance * turned.normal;
  }
  return turned;
}

bool goes_on_past(const Seam& own, const Seam& other, const ContactPoint& contact, Real size) {
  const Seen seen = seen_by(own, other, contact);
  return goes_on_at(*other.part, seen.point, seen.normal, size);
}

// Whether two or more children may meet along a seam.
bool has_seams(const AnyShape& shape, bool is_welded) {
  return std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Assembly<S>) {
          return std::ranges::count_if(s.children(), [&](const auto& child) {
                   return is_part_at_seams(child.shape->index(), is_welded);
                 }) > 1;
        } else {
          return false;
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

// A child of a shape, or the shape itself.
struct [[gsl::Pointer]] PlacedChild {
  const AnyShape& shape;
  Pose pose;
};
PlacedChild child_of(const PlacedSide& side, std::uint32_t child) {
  return std::visit(
      [&]<class S>(const S& s) -> PlacedChild {
        if constexpr (Assembly<S>) {
          return {*s.children()[child].shape, side.pose * s.children()[child].pose};
        } else {
          return {side.shape, side.pose};
        }
      },
      static_cast<const AnyShape::Variant&>(side.shape));
}

}  // namespace

SurfaceSides surfaces_of(const AnyShape& a, const AnyShape& b, const ContactPoint& contact) {
  const auto is_surface_child = [](const AnyShape& shape, std::uint32_t child) {
    return std::visit(
        [&]<class S>(const S& s) {
          if constexpr (Assembly<S>) {
            return is_surface(*s.children()[child].shape);
          } else {
            return Surface<S>;
          }
        },
        static_cast<const AnyShape::Variant&>(shape));
  };
  return {is_surface_child(a, contact.child_a), is_surface_child(b, contact.child_b)};
}

void leave_out_at_seams(std::span<Seam> seams, Real size) {
  struct Place {
    std::size_t seam, contact;
  };
  std::vector<Place> order;
  for (std::size_t seam = 0; seam < seams.size(); ++seam) {
    for (std::size_t contact = 0; contact < seams[seam].contacts.size(); ++contact) {
      order.push_back({seam, contact});
    }
  }
  const auto contact_at = [&](const Place& place) -> const ContactPoint& {
    return seams[place.seam].contacts[place.contact];
  };
  std::ranges::sort(
      order, {}, [&](const Place& place) { return std::tuple(contact_at(place).distance, place.seam, place.contact); });
  // Deepest first, so that what another surface has kept so far is no less deep.
  std::vector<std::vector<ContactPoint>> kept(seams.size());
  std::vector<std::vector<Vec3>> left_out(seams.size());  // normals
  for (const Place& place : order) {
    const Seam& own = seams[place.seam];
    const ContactPoint& contact = contact_at(place);
    if (std::ranges::find(left_out[place.seam], contact.normal) != left_out[place.seam].end()) {
      continue;  // the points of a face under one normal come from the deepest of them
    }
    bool is_border = false, is_covered = false;
    for (std::size_t other = 0; other < seams.size() && !is_covered; ++other) {
      if (other != place.seam && !seams[other].contacts.empty() && goes_on_past(own, seams[other], contact, size)) {
        is_border = true;
        is_covered = !kept[other].empty();
      }
    }
    if (!is_border || has_own_face(own, contact, size)) {
      kept[place.seam].push_back(contact);
      continue;
    }
    left_out[place.seam].push_back(contact.normal);
    if (const auto turned = is_covered ? std::nullopt : turned_to_face(own, contact, size)) {
      kept[place.seam].push_back(*turned);
    }
  }
  for (std::size_t seam = 0; seam < seams.size(); ++seam) {
    seams[seam].contacts = std::move(kept[seam]);
  }
}

void settle_at_seams(std::span<Seam> seams, const BodyAtSeams& body, Real size) {
  if (std::ranges::any_of(seams, [](const Seam& seam) { return is_weldable(*seam.part); })) {
    weld(seams, body);
  } else {
    leave_out_at_seams(seams, size);
  }
}

void settle_seams(const PlacedSide& composite, const PlacedSide& other, const QuerySettings& settings,
                  std::size_t first, Manifold& out) {
  const bool is_welded = settings.welds && !composite.shape.has_holes();
  if (!has_seams(composite.shape, is_welded)) {
    return;
  }
  const bool is_b = composite.is_b;
  const auto child_of_it = [&](const ContactPoint& contact) { return is_b ? contact.child_b : contact.child_a; };
  const auto body_of = [&](const ContactPoint& contact) { return is_b ? contact.child_a : contact.child_b; };
  const std::span<ContactPoint> all = std::span(out).subspan(first);
  std::ranges::sort(all, {}, [&](const ContactPoint& contact) {
    return std::tuple(body_of(contact), child_of_it(contact), contact.distance, contact.id);
  });
  Manifold kept;
  const auto settle = [&]<class S>(const S& s) {
    if constexpr (Assembly<S>) {
      for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        std::vector<Seam> seams;
        std::vector<std::uint32_t> children;
        for (; end < all.size() && body_of(all[end]) == body_of(all[begin]); ++end) {
          const std::uint32_t number = child_of_it(all[end]);
          const auto& child = s.children()[number];
          if (!is_part_at_seams(child.shape->index(), is_welded)) {
            kept.push_back(all[end]);
            continue;
          }
          if (children.empty() || children.back() != number) {
            seams.push_back({child.shape, composite.pose * child.pose, is_b, {}, settings.margin});
            children.push_back(number);
          }
          seams.back().contacts.push_back(all[end]);
        }
        const std::uint32_t number_of_body = body_of(all[begin]);
        const PlacedChild body = child_of(other, number_of_body);
        settle_at_seams(seams, {body.shape, body.pose}, half_size_of(other.shape));
        for (std::size_t i = 0; i < seams.size(); ++i) {
          kept.insert(kept.end(), seams[i].contacts.begin(), seams[i].contacts.end());
          const std::size_t added = kept.size();
          kept.insert(kept.end(), seams[i].added.begin(), seams[i].added.end());
          const AnyShape &a = is_b ? other.shape : composite.shape, &b = is_b ? composite.shape : other.shape;
          name_children(a, b, is_b ? number_of_body : children[i], is_b ? children[i] : number_of_body,
                        std::span(kept).subspan(added));
        }
      }
    }
  };
  std::visit(settle, static_cast<const AnyShape::Variant&>(composite.shape));
  out.resize(first, ContactPoint{});
  out.insert(out.end(), kept.begin(), kept.end());
}

}  // namespace abut

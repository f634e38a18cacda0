// SPDX-License-Identifier: Apache-2.0
module abut.pairs.registry.seams;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.many.continuation;
import abut.narrow.many.nearest_face;
import abut.pairs.registry;

namespace abut {
namespace {

template <class Ask>
bool ask_surface(const AnyShape& shape, Ask&& ask) {
  return std::visit(
      [&]<class S>(const S& surface) {
        if constexpr (Surface<S>) {
          return ask(surface);
        } else {
          return false;
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

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
  return ask_surface(*own.surface,
                     [&](const auto& surface) { return has_face(surface, seen.point, seen.normal, size); });
}

// The contact under the normal of the face that it lies on, as deep as the body is below that there.
std::optional<ContactPoint> turned_to_face(const Seam& own, const ContactPoint& contact, Real size) {
  const Seen seen = seen_by(own, own, contact);
  std::optional<Vec3> face;
  static_cast<void>(ask_surface(*own.surface, [&](const auto& surface) {
    face = nearest_face_normal(surface, seen.point, seen.normal, size);
    return true;
  }));
  if (!face) {
    return std::nullopt;
  }
  ContactPoint turned = contact;
  const Vec3 normal = own.pose.rotation * *face;
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
  return ask_surface(*other.surface,
                     [&](const auto& surface) { return goes_on(surface, seen.point, seen.normal, size); });
}

// Whether two or more children are surfaces, which may meet along a seam.
bool has_surfaces(const AnyShape& shape) {
  return std::visit(
      []<class S>(const S& s) {
        if constexpr (Assembly<S>) {
          return std::ranges::count_if(s.children(), [](const auto& child) { return is_surface(*child.shape); }) > 1;
        } else {
          return false;
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
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

bool is_surface_kind(std::size_t kind) {
  static constexpr auto are_surfaces = []<class... S>(const std::variant<S...>*) {
    return std::array<bool, sizeof...(S)>{Surface<S>...};
  }(static_cast<const AnyShape::Variant*>(nullptr));
  return are_surfaces[kind];
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

void settle_seams(const AnyShape& composite, const Pose& pose, bool is_b, const AnyShape& other, std::size_t first,
                  Manifold& out) {
  if (!has_surfaces(composite)) {
    return;
  }
  const auto child_of = [&](const ContactPoint& contact) { return is_b ? contact.child_b : contact.child_a; };
  const auto body_of = [&](const ContactPoint& contact) { return is_b ? contact.child_a : contact.child_b; };
  const std::span<ContactPoint> all = std::span(out).subspan(first);
  std::ranges::sort(all, {}, [&](const ContactPoint& contact) {
    return std::tuple(body_of(contact), child_of(contact), contact.distance, contact.id);
  });
  const Aabb box =
      std::visit([](const auto& s) { return s.aabb(Pose::identity()); }, static_cast<const AnyShape::Variant&>(other));
  Manifold kept;
  const auto settle = [&]<class S>(const S& s) {
    if constexpr (Assembly<S>) {
      for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        std::vector<Seam> seams;
        for (; end < all.size() && body_of(all[end]) == body_of(all[begin]); ++end) {
          const auto& child = s.children()[child_of(all[end])];
          if (!is_surface(*child.shape)) {
            kept.push_back(all[end]);
            continue;
          }
          if (seams.empty() || child_of(all[end - 1]) != child_of(all[end])) {
            seams.push_back({child.shape, pose * child.pose, is_b, {}});
          }
          seams.back().contacts.push_back(all[end]);
        }
        leave_out_at_seams(seams, 0.5 * largest_magnitude(box.high - box.low));
        for (const Seam& seam : seams) {
          kept.insert(kept.end(), seam.contacts.begin(), seam.contacts.end());
        }
      }
    }
  };
  std::visit(settle, static_cast<const AnyShape::Variant&>(composite));
  out.resize(first, ContactPoint{});
  out.insert(out.end(), kept.begin(), kept.end());
}

}  // namespace abut

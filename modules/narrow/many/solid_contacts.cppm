// SPDX-License-Identifier: Apache-2.0
// Contacts with a solid. Those with its surface count where they lead out of it and are no deeper than the whole. Where
// none of them is as deep as the whole, the deepest one of the whole is added.
export module abut.narrow.many.solid_contacts;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.many.solid_depth;

export namespace abut {

[[nodiscard]] inline ContactPoint contact_of(const SolidDepth& depth) {
  const Distance deepest = distance_of(depth);
  const Feature face =
      depth.way.part == no_index ? Feature{FeatureKind::whole, 0} : Feature{FeatureKind::face, depth.way.part};
  const Feature whole{FeatureKind::whole, 0};
  return {deepest.point_a,
          deepest.point_b,
          deepest.normal,
          deepest.distance,
          face,
          whole,
          contact_id_of_part(contact_id(face, whole), face.index)};
}

// `first`: of the contacts with the surface. Those that are deeper than the whole go.
inline void settle_depth(const std::optional<SolidDepth>& depth, std::size_t first, Real margin, Manifold& out) {
  if (!depth) {
    return;
  }
  const Real length = depth->way.length, blur = 2 * depth->touching;
  const auto begin = out.begin() + static_cast<std::ptrdiff_t>(first);
  const auto is_deeper = [&](const ContactPoint& contact) { return contact.distance < -length - blur; };
  out.erase(std::remove_if(begin, out.end(), is_deeper), out.end());
  const auto kept = std::span(out).subspan(first);
  const bool is_wanted = -length <= margin;
  if (is_wanted &&
      std::ranges::none_of(kept, [&](const ContactPoint& contact) { return contact.distance <= blur - length; })) {
    out.push_back(contact_of(*depth));
  }
}

// Wrongly wound triangles stop from both sides; one that pushes further in does not count.
template <Enclosing A>
void keep_leading_out(const A& a, std::size_t first, Manifold& out) {
  const auto leads_in = [&](const ContactPoint& contact) {
    const std::uint32_t part = contact.feature_a.index;
    return a.is_turned(part) && dot(contact.normal, a.part(part).normal()) > 0;
  };
  out.erase(std::remove_if(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), leads_in), out.end());
}

}  // namespace abut

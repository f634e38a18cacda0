// SPDX-License-Identifier: Apache-2.0
module abut.scene.rest.focus;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.scene.state.options;

namespace abut {
namespace {

Aabb wide(const CompactAabb& box) {
  const auto corner = [](const std::array<float, 3>& its) {
    return Vec3{static_cast<Real>(its[0]), static_cast<Real>(its[1]), static_cast<Real>(its[2])};
  };
  return {corner(box.low), corner(box.high)};
}

}  // namespace

bool FocusCentres::set(const Focus& focus, std::span<const Vec3> centres, const Vec3& origin) {
  const auto local = [&](const Vec3& centre) { return centre - origin; };
  const bool is_resized = centres_.size() != centres.size();
  centres_.resize(centres.size());
  bool is_changed = std::exchange(focus_, focus) != focus || is_resized;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Vec3 before = std::exchange(centres_[i], local(centres[i]));
    is_changed = is_changed || !(before == centres_[i]);
  }
  return is_changed;
}

std::uint32_t FocusCentres::tag_of(const CompactAabb& box, std::uint32_t tag) const {
  Real least = infinity;
  for (const Vec3& centre : centres_) {
    least = std::min(least, wide(box).squared_distance(centre));
  }
  const Real distance = std::sqrt(least);
  return distance < focus_.near_distance ? focus_.near_tag : distance > focus_.far_distance ? focus_.far_tag : tag;
}

Fault check_focus(const Focus& focus) {
  for (const auto& [name, tag] : {std::pair{"near_tag", focus.near_tag}, std::pair{"far_tag", focus.far_tag}}) {
    if (tag >= tag_count) {
      return error_about(Errc::out_of_range, name, std::uint64_t{tag}, "below " + std::to_string(tag_count));
    }
  }
  if (focus.near_tag == focus.far_tag) {
    return error_about(Errc::invalid_argument, "far_tag", std::uint64_t{focus.far_tag}, "another tag than near_tag");
  }
  if (Fault fault = check_not_negative("near_distance", focus.near_distance)) {
    return fault;
  }
  if (Fault fault = check_finite("far_distance", focus.far_distance)) {
    return fault;
  }
  if (focus.far_distance < focus.near_distance) {
    return error_about(Errc::out_of_range, "far_distance", focus.far_distance,
                       "at least near_distance, " + to_text(focus.near_distance));
  }
  return std::nullopt;
}

bool FocusCentres::is_whole() const {
  return !check_focus(focus_) && std::ranges::all_of(centres_, [](const Vec3& centre) { return is_finite(centre); });
}

}  // namespace abut

// Tags that follow the focus, and what pairs make of that.
module abut.universe;
import abut.broadphase;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.universe.pairs;
import abut.universe.plan;
import abut.universe.policies;

namespace abut {

Result<void> Universe::set_focus(const std::optional<Focus>& focus, std::span<const Vec3> centres) {
  if (!focus) {
    has_focus_ = false;
    return {};
  }
  if (Fault fault = check_focus(*focus)) {
    return *fault;
  }
  const bool is_other = focus_.set(*focus, centres, options_.origin);
  is_focus_moved_ = is_focus_moved_ || is_other || !has_focus_;
  has_focus_ = true;
  return {};
}

void Universe::follow_focus(std::uint32_t at) {
  PlaceInfo& info = infos_[at];
  if (presence_[at] != Presence::shown || !focus_.concerns(info.tag)) {
    return;
  }
  const std::uint32_t tag = focus_.tag_of(boxes_[at], info.tag);
  if (tag != info.tag) {
    info.tag = geometries_.at(id_at(at)).options.tag = tag;
    note(at, happened_to_tag);
    switched_.push_back(at);
  }
}

// While the centres stay, only what moved or changed can have come nearer or gone farther.
void Universe::follow_focus() {
  if (std::exchange(is_focus_moved_, false)) {
    for (std::uint32_t at = 0; at < infos_.size(); ++at) {
      follow_focus(at);
    }
  } else {
    for (const std::uint32_t at : fresh_) {
      follow_focus(at);
    }
  }
  if (switched_.empty()) {
    return;
  }
  for (Pair& pair : pairs_.all()) {
    if (((happened_[pair.low] | happened_[pair.high]) & happened_to_tag) != 0) {
      pair.policy = static_cast<std::uint16_t>(policies_.number_of(infos_[pair.low].tag, infos_[pair.high].tag));
      // At once, whatever the period: what the other policy has found may be less than this one asks for.
      pair.is_stale = pair.is_new = true;
    }
  }
  for (const std::uint32_t at : switched_) {
    happened_[at] &= static_cast<std::uint8_t>(~happened_to_tag);
  }
  switched_.clear();
}

Plan::FocusCounts Universe::count_focus() const {
  Plan::FocusCounts counts{focus_.focus(), focus_.size(), 0, 0};
  geometries_.for_each([&](GeometryId, const Geometry& geometry) {
    counts.near += geometry.options.tag == counts.focus.near_tag ? 1 : 0;
    counts.far += geometry.options.tag == counts.focus.far_tag ? 1 : 0;
  });
  return counts;
}

}  // namespace abut

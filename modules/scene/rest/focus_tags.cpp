// SPDX-License-Identifier: Apache-2.0
module abut.scene.rest.focus_tags;
import abut.core.standard;
import abut.scene.state.places;
import abut.scene.state.space;

namespace abut {

void FocusTags::follow(std::uint32_t at, const Space& space, Places& places) {
  PlaceInfo& info = places.infos[at];
  if (!space.is_shown(at) || !centres_.concerns(info.tag)) {
    return;
  }
  const std::uint32_t tag = centres_.tag_of(places.boxes[at], info.tag);
  if (tag != info.tag) {
    info.tag = static_cast<std::uint8_t>(tag);
    places.note(at, happened_to_tag);
    switched_.push_back(at);
  }
}

void FocusTags::follow(std::span<const std::uint32_t> fresh, const Space& space, Places& places) {
  if (std::exchange(has_moved_, false)) {
    for (std::uint32_t at = 0; at < places.infos.size(); ++at) {
      follow(at, space, places);
    }
  } else {
    for (const std::uint32_t at : fresh) {
      follow(at, space, places);
    }
  }
}

void FocusTags::forget_switched(Places& places) {
  for (const std::uint32_t at : switched_) {
    places.happened[at] &= static_cast<std::uint8_t>(~happened_to_tag);
  }
  switched_.clear();
}

}  // namespace abut

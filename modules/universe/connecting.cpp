// Islands of a universe.
module abut.universe;
import abut.core;
import abut.core.standard;
import abut.universe.pairs;

namespace abut {

void Universe::follow_islands(bool are_followed) {
  follows_islands_ = are_followed;
  if (!are_followed) {
    islands_.clear();
  }
}

// After the contacts are known.
void Universe::connect_islands() {
  island_links_.start(parts_.slot_count());
  for (const Pair& pair : pairs_.all()) {
    const PlaceInfo &low = infos_[pair.low], &high = infos_[pair.high];
    if (low.is_moving && high.is_moving && bears(pair)) {
      island_links_.join(low.part, high.part);
    }
  }
}

void Universe::number_islands() {
  dynamic_parts_.clear();
  parts_.for_each([&](PartId id, const Part& part) {
    if (part.motion == MotionKind::dynamic) {
      dynamic_parts_.push_back(id);
    }
  });
  islands_.number(dynamic_parts_, island_links_);
}

}  // namespace abut

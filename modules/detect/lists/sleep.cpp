// SPDX-License-Identifier: Apache-2.0
module abut.detect.lists.sleep;
import abut.core.standard;
import abut.detect.lists.islands;
import abut.detect.pairs;
import abut.math;
import abut.scene;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.rest.sleep;

namespace abut {

void connect_islands(std::span<const Pair> pairs, std::span<const PlaceInfo> infos, std::uint32_t slot_count,
                     IslandLinks& links) {
  links.start(slot_count);
  for (const Pair& pair : pairs) {
    const PlaceInfo &low = infos[pair.low], &high = infos[pair.high];
    if (low.is_dynamic && high.is_dynamic && bears(pair)) {
      links.join(low.part.slot, high.part.slot);
    }
  }
}

// Of pairs that are lost, a side whose geometry is gone has been disturbed when that went.
void update_sleep(Real dt, const Scene::Parts& parts, std::span<const PlaceInfo> infos, IslandLinks& links,
                  PairStore& pairs, SleepTable& sleep) {
  if (dt > 0) {
    sleep.measure(dt, [&](PartId part) -> const Placement& { return parts.at(part).placement; });
  }
  const auto unsettle = [&](std::uint32_t place, std::uint32_t generation) {
    if (infos[place].generation == generation) {
      sleep.unsettle(infos[place].part.slot);
    }
  };
  const auto unsettle_both = [&](const Pair& pair) {
    unsettle(pair.low, pair.generation_low);
    unsettle(pair.high, pair.generation_high);
  };
  for (const Pair& pair : pairs.lost()) {
    if (pair.is_bearing) {
      unsettle_both(pair);
    }
  }
  for (Pair& pair : pairs.all()) {
    const bool is_bearing = bears(pair);
    if (is_bearing != pair.is_bearing) {
      pair.is_bearing = is_bearing;
      unsettle_both(pair);
    }
    if (is_bearing) {
      const PlaceInfo &low = infos[pair.low], &high = infos[pair.high];
      sleep.touch({low.part.slot, low.is_dynamic}, {high.part.slot, high.is_dynamic});
    }
  }
  sleep.settle(dt > 0, links.lowest_slots());
}

bool is_asleep(const Pair& pair, std::span<const PlaceInfo> infos, const SleepTable& sleep) {
  if (sleep.asleep_count() == 0 || !pair.is_touching) {
    return false;
  }
  const PlaceInfo &low = infos[pair.low], &high = infos[pair.high];
  return (!low.is_dynamic || sleep.is_asleep(low.part.slot)) && (!high.is_dynamic || sleep.is_asleep(high.part.slot));
}

}  // namespace abut

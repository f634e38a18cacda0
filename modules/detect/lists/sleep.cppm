// SPDX-License-Identifier: Apache-2.0
// The stages after the contacts that look at which parts hang together: islands, and sleep.
export module abut.detect.lists.sleep;
import abut.core.standard;
import abut.detect.lists.islands;
import abut.detect.pairs;
import abut.math;
import abut.scene;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.rest.sleep;

export namespace abut {

// Joins dynamic parts that bear each other. Slots are those of parts, up to `slot_count`.
void connect_islands(std::span<const Pair> pairs, std::span<const PlaceInfo> infos, std::uint32_t slot_count,
                     IslandLinks& links);

// Measures parts where time has passed, tells the table what touches and what began or ended to, and lets it decide.
// Writes is_bearing of the pairs.
void update_sleep(Real dt, const Scene::Parts& parts, std::span<const PlaceInfo> infos, IslandLinks& links,
                  PairStore& pairs, SleepTable& sleep);

// The pair touches, but none of its dynamic parts is awake.
[[nodiscard]] bool is_asleep(const Pair& pair, std::span<const PlaceInfo> infos, const SleepTable& sleep);

}  // namespace abut

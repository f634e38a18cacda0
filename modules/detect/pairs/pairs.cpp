// SPDX-License-Identifier: Apache-2.0
module abut.detect.pairs;
import abut.broadphase;
import abut.core.standard;
import abut.core.workers;
import abut.pairs.two_shapes.runs;
import abut.scene.state.options;
import abut.scene.state.places;

namespace abut {
namespace {

// Fewer pairs are merged faster than a thread is called.
constexpr std::size_t least_of_task = 2048;

bool is_before(const Pair& a, const ProxyPair& b) { return a.low < b.low || (a.low == b.low && a.high < b.high); }

}  // namespace

void PairStore::merge_part(std::span<const ProxyPair> near, std::span<const Pair> before,
                           std::span<const PlaceInfo> infos, bool are_slots_reused, std::span<Pair> out,
                           Part& part) const {
  part.lost.clear();
  part.free_memories.clear();
  std::size_t at = 0;
  const auto lose = [&](const Pair& pair) {
    if (pair.is_touching) {
      part.lost.push_back(pair);
    }
    if (pair.memory != no_memory) {
      part.free_memories.push_back(pair.memory);
    }
  };
  for (std::size_t i = 0; i < near.size(); ++i) {
    const ProxyPair& pair = near[i];
    while (at < before.size() && is_before(before[at], pair)) {
      lose(before[at++]);
    }
    if (at < before.size() && before[at].low == pair.low && before[at].high == pair.high) {
      const Pair& known = before[at++];
      if (!are_slots_reused || (known.generation_low == infos[pair.low].generation &&
                                known.generation_high == infos[pair.high].generation)) {
        out[i] = known;
        continue;
      }
      lose(known);
    }
    out[i] = {.low = pair.low,
              .high = pair.high,
              .generation_low = infos[pair.low].generation,
              .generation_high = infos[pair.high].generation};
  }
  while (at < before.size()) {
    lose(before[at++]);
  }
}

void PairStore::merge(const Workers& workers, std::span<const ProxyPair> near, std::span<const PlaceInfo> infos,
                      bool are_slots_reused) {
  pairs_.swap(before_);
  if (pairs_.capacity() < near.size()) {
    pairs_.clear();
    pairs_.reserve(near.size());
  }
  pairs_.resize(near.size());
  const Cuts cuts = workers.cut(near.size(), least_of_task);
  parts_.resize(std::max(parts_.size(), cuts.tasks()));
  // A task takes the pairs before that lie between its first one and that of the next task.
  const auto before_at = [&](std::size_t task) {
    if (task == 0 || task == cuts.tasks()) {
      return task == 0 ? 0 : before_.size();
    }
    return static_cast<std::size_t>(
        std::lower_bound(before_.begin(), before_.end(), near[cuts.begin(task)], is_before) - before_.begin());
  };
  workers.for_each(cuts.tasks(), [&](std::size_t task) {
    const std::size_t begin = before_at(task), end = before_at(task + 1);
    merge_part(cuts.of(near, task), std::span<const Pair>(before_).subspan(begin, end - begin), infos, are_slots_reused,
               cuts.of(all(), task), parts_[task]);
  });
  for (const Part& part : std::span(parts_).first(cuts.tasks())) {
    lost_.insert(lost_.end(), part.lost.begin(), part.lost.end());
    free_memories_.insert(free_memories_.end(), part.free_memories.begin(), part.free_memories.end());
  }
}

void PairStore::give_memory(Pair& pair) {
  if (pair.memory != no_memory) {
    return;
  }
  if (free_memories_.empty()) {
    pair.memory = memories_.add();
    return;
  }
  pair.memory = free_memories_.back();
  free_memories_.pop_back();
  memories_.forget(pair.memory);
}

void PairStore::lose(std::span<const Pair> pairs) {
  if (pairs.empty()) {
    return;
  }
  lost_.insert(lost_.end(), pairs.begin(), pairs.end());
  std::ranges::sort(lost_, {}, [](const Pair& pair) { return std::pair(pair.low, pair.high); });
}

std::size_t PairStore::bytes() const {
  std::size_t pairs = pairs_.capacity() + before_.capacity() + lost_.capacity(), numbers = free_memories_.capacity();
  for (const Part& part : parts_) {
    pairs += part.lost.capacity();
    numbers += part.free_memories.capacity();
  }
  return pairs * sizeof(Pair) + numbers * sizeof(std::uint32_t) + memories_.bytes() + parts_.capacity() * sizeof(Part);
}

}  // namespace abut

module abut.universe.pairs;
import abut.broadphase;
import abut.core.standard;
import abut.narrowphase.pair_memory;
import abut.universe.options;

namespace abut {
namespace {

bool is_before(const Pair& a, const ProxyPair& b) { return a.low < b.low || (a.low == b.low && a.high < b.high); }

}  // namespace

void PairStore::merge(std::span<const ProxyPair> near, std::span<const PlaceInfo> infos) {
  pairs_.swap(before_);
  pairs_.clear();
  pairs_.reserve(near.size());
  std::size_t at = 0;
  const auto lose = [&](const Pair& pair) {
    if (pair.is_touching) {
      lost_.push_back(pair);
    }
    if (pair.memory != no_memory) {
      free_memories_.push_back(pair.memory);
    }
  };
  for (const ProxyPair& pair : near) {
    while (at < before_.size() && is_before(before_[at], pair)) {
      lose(before_[at++]);
    }
    const std::uint32_t low = infos[pair.low].generation, high = infos[pair.high].generation;
    if (at < before_.size() && before_[at].low == pair.low && before_[at].high == pair.high) {
      const Pair& known = before_[at++];
      if (known.generation_low == low && known.generation_high == high) {
        pairs_.push_back(known);
        continue;
      }
      lose(known);
    }
    pairs_.push_back({.low = pair.low, .high = pair.high, .generation_low = low, .generation_high = high});
  }
  while (at < before_.size()) {
    lose(before_[at++]);
  }
}

void PairStore::give_memory(Pair& pair) {
  if (pair.memory != no_memory) {
    return;
  }
  if (free_memories_.empty()) {
    pair.memory = static_cast<std::uint32_t>(memories_.size());
    memories_.push_back({});
    return;
  }
  pair.memory = free_memories_.back();
  free_memories_.pop_back();
  memories_[pair.memory] = {};
}

void PairStore::sort_lost() {
  std::ranges::sort(lost_, {}, [](const Pair& pair) { return std::pair(pair.low, pair.high); });
}

}  // namespace abut

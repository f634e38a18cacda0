// SPDX-License-Identifier: Apache-2.0
module abut.broadphase.kept.kept_pairs;
import abut.broadphase.box_record;
import abut.broadphase.kept.pair_order;
import abut.broadphase.proxy;
import abut.core.standard;
import abut.core.workers;

namespace abut {
namespace {

// A task has at least so many pairs to look at.
constexpr std::size_t least_of_task = 4096;
constexpr std::size_t tasks_of_thread = 4;

// In the order of pairs.
[[nodiscard]] inline std::uint64_t key_of(const ProxyPair& pair) { return (std::uint64_t{pair.low} << 32) | pair.high; }

// Numbers of pairs go up and down: a list that grows gets some to spare, so that it soon grows no more.
void reserve_some(std::vector<ProxyPair>& list, std::size_t count) {
  if (list.capacity() < count) {
    list.reserve(count + count / 4);
  }
}

// Merges both ranges. Each pair is written to both lists and stays if it counts: no branch to predict, and none on
// which range comes next. Room is made for a block at a time: nearly all that is found was kept before, and the lists
// need no room for both.
void merge(std::span<const ProxyPair> before, std::span<const ProxyPair> found, std::span<const BoxRecord> records,
           Keeping keeping, std::vector<ProxyPair>& kept, std::vector<ProxyPair>& out) {
  reserve_some(kept, std::max(before.size(), found.size()));
  reserve_some(out, std::max(before.size(), found.size()));
  // The boxes of the higher numbers lie anywhere; those of a few pairs to come are asked for ahead.
  constexpr std::size_t ahead = 24;
  const auto ask_ahead = [&](std::span<const ProxyPair> list, std::size_t at) {
    __builtin_prefetch(&records[list[std::min(at + ahead, list.size() - 1)].high]);
  };
  auto next_kept = kept.begin(), next_out = out.begin();
  const auto take = [&](const ProxyPair& pair, bool is_found) {
    const BoxRecord &low = records[pair.low], &high = records[pair.high];
    const std::uint32_t state = low.state | high.state;
    const bool overlaps = overlap(low, high);
    // What is kept goes when a box was touched; it is found again if it is still there.
    const bool is_out_of_date = (state & (is_found ? 0 : BoxRecord::touched)) != 0;
    const bool stays = !is_out_of_date && low.group != high.group && (keeping == Keeping::unless_touched || overlaps);
    const bool counts = stays && overlaps && (state & BoxRecord::hidden) == 0;
    *next_kept = *next_out = pair;
    next_kept += stays ? 1 : 0;
    next_out += counts ? 1 : 0;
  };
  std::size_t kept_count = 0, out_count = 0, old = 0, added = 0;
  while (old < before.size() || added < found.size()) {
    constexpr std::size_t most_of_block = 256;
    std::size_t left = std::min(most_of_block, before.size() - old + found.size() - added);
    // As much as a whole block needs, or short lists would still grow whenever more is found than ever before.
    reserve_some(kept, kept_count + most_of_block);
    reserve_some(out, out_count + most_of_block);
    kept.resize(std::max(kept.size(), kept_count + left));
    out.resize(std::max(out.size(), out_count + left));
    next_kept = kept.begin() + static_cast<std::ptrdiff_t>(kept_count);
    next_out = out.begin() + static_cast<std::ptrdiff_t>(out_count);
    for (; left > 0 && old < before.size() && added < found.size(); --left) {
      const std::uint64_t key_of_old = key_of(before[old]), key_of_added = key_of(found[added]);
      const bool is_found = key_of_added <= key_of_old;
      ask_ahead(before, old);
      ask_ahead(found, added);
      old += key_of_old <= key_of_added ? 1 : 0;
      added += is_found ? 1 : 0;
      const std::uint64_t key = is_found ? key_of_added : key_of_old;
      take({static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)}, is_found);
    }
    for (; left > 0 && old < before.size() && added == found.size(); --left, ++old) {
      ask_ahead(before, old);
      take(before[old], false);
    }
    for (; left > 0 && added < found.size() && old == before.size(); --left, ++added) {
      ask_ahead(found, added);
      take(found[added], true);
    }
    kept_count = static_cast<std::size_t>(next_kept - kept.begin());
    out_count = static_cast<std::size_t>(next_out - out.begin());
  }
  kept.resize(kept_count);
  out.resize(out_count);
}

}  // namespace

void KeptPairs::renew(const Workers& workers, std::span<const BoxRecord> records, Keeping keeping,
                      std::vector<ProxyPair>& found, std::vector<ProxyPair>& out) {
  put_in_order(found, sorted_.all);
  sorted_.end_call();
  const std::size_t tasks = workers.threads() == 1 ? 1
                                                   : std::clamp<std::size_t>(kept_.size() / least_of_task, 1,
                                                                             tasks_of_thread * workers.threads());
  if (tasks == 1) {
    merge(kept_, found, records, keeping, next_, out);
    kept_.swap(next_);
    return;
  }
  if (parts_.size() < tasks) {
    parts_.resize(tasks);
  }
  // What is found goes to the task of the pair that it precedes.
  const auto merge_part = [&](std::size_t task) {
    const std::span<const ProxyPair> kept(kept_), added(found);
    const auto kept_at = [&](std::size_t i) { return i * kept.size() / tasks; };
    const auto added_at = [&](std::size_t i) {
      if (i == 0 || i == tasks) {
        return i == 0 ? 0 : added.size();
      }
      return static_cast<std::size_t>(std::lower_bound(added.begin(), added.end(), kept[kept_at(i)], is_before) -
                                      added.begin());
    };
    merge(kept.subspan(kept_at(task), kept_at(task + 1) - kept_at(task)),
          added.subspan(added_at(task), added_at(task + 1) - added_at(task)), records, keeping, parts_[task].kept,
          parts_[task].out);
  };
  workers.for_each(tasks, [&](std::size_t task) { merge_part(task); });
  std::size_t kept_count = 0, out_count = 0;
  for (const Part& part : std::span(parts_).first(tasks)) {
    kept_count += part.kept.size();
    out_count += part.out.size();
  }
  reserve_some(kept_, kept_count);
  reserve_some(out, out_count);
  kept_.resize(kept_count);
  out.resize(out_count);
  workers.for_each(tasks, [&](std::size_t task) {
    std::size_t kept_before = 0, out_before = 0;
    for (const Part& part : std::span(parts_).first(task)) {
      kept_before += part.kept.size();
      out_before += part.out.size();
    }
    std::ranges::copy(parts_[task].kept, kept_.begin() + static_cast<std::ptrdiff_t>(kept_before));
    std::ranges::copy(parts_[task].out, out.begin() + static_cast<std::ptrdiff_t>(out_before));
  });
}

void KeptPairs::give_back_scratch() {
  std::vector<ProxyPair>().swap(next_);
  sorted_.give_back();
  std::vector<Part>().swap(parts_);
}

std::size_t KeptPairs::bytes() const {
  std::size_t pairs = kept_.capacity() + next_.capacity();
  for (const Part& part : parts_) {
    pairs += part.kept.capacity() + part.out.capacity();
  }
  return pairs * sizeof(ProxyPair) + sorted_.bytes() + parts_.capacity() * sizeof(Part);
}

}  // namespace abut

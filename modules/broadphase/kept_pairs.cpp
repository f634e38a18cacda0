module abut.broadphase.kept_pairs;
import abut.broadphase.box_record;
import abut.broadphase.pair_order;
import abut.broadphase.proxy;
import abut.core.standard;
import abut.core.workers;

namespace abut {
namespace {

// A task has at least so many pairs to look at.
constexpr std::size_t least_of_task = 4096;
constexpr std::size_t tasks_of_thread = 4;

// Merges both ranges. Each pair is written to both lists and stays if it counts: no branch to predict.
void merge(std::span<const ProxyPair> before, std::span<const ProxyPair> found, std::span<const BoxRecord> records, Keeping keeping,
           std::vector<ProxyPair>& kept, std::vector<ProxyPair>& out) {
  const std::size_t most = before.size() + found.size();
  kept.resize(most);
  out.resize(most);
  auto next_kept = kept.begin(), next_out = out.begin();
  // The boxes of the higher numbers lie anywhere; those of a few pairs to come are asked for ahead.
  constexpr std::size_t ahead = 24;
  const auto ask_ahead = [&](auto at, std::span<const ProxyPair> list) {
    const auto left = static_cast<std::size_t>(list.end() - at);
    __builtin_prefetch(&records[(left > ahead ? at[ahead] : *at).high]);
  };
  const auto take = [&](const ProxyPair& pair) {
    const BoxRecord &low = records[pair.low], &high = records[pair.high];
    const std::uint32_t state = low.state | high.state;
    const bool overlaps = overlap(low, high);
    const bool stays = (state & BoxRecord::touched) == 0 && (keeping == Keeping::unless_touched || overlaps);
    const bool counts = overlaps && (state & (BoxRecord::touched | BoxRecord::hidden)) == 0;
    *next_kept = *next_out = pair;
    next_kept += stays ? 1 : 0;
    next_out += counts ? 1 : 0;
  };
  auto old = before.begin();
  for (auto added = found.begin(); added != found.end(); ++added) {
    const ProxyPair& pair = *added;
    ask_ahead(added, found);
    for (; old != before.end() && is_before(*old, pair); ++old) {
      ask_ahead(old, before);
      take(*old);
    }
    const BoxRecord &low = records[pair.low], &high = records[pair.high];
    if (low.group != high.group) {
      // It may be kept already, and then goes now: its boxes were touched.
      const bool overlaps = overlap(low, high);
      const bool counts = overlaps && ((low.state | high.state) & BoxRecord::hidden) == 0;
      *next_kept = *next_out = pair;
      next_kept += keeping == Keeping::unless_touched || overlaps ? 1 : 0;
      next_out += counts ? 1 : 0;
      if (old != before.end() && *old == pair) {
        ++old;
      }
    }
  }
  for (; old != before.end(); ++old) {
    ask_ahead(old, before);
    take(*old);
  }
  kept.resize(static_cast<std::size_t>(next_kept - kept.begin()));
  out.resize(static_cast<std::size_t>(next_out - out.begin()));
}

}  // namespace

void KeptPairs::renew(const Workers& workers, std::span<const BoxRecord> records, Keeping keeping, std::vector<ProxyPair>& found,
                      std::vector<ProxyPair>& out) {
  put_in_order(found, sorted_);
  const std::size_t tasks =
      workers.threads() == 1 ? 1 : std::clamp<std::size_t>(kept_.size() / least_of_task, 1, tasks_of_thread * workers.threads());
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
      return static_cast<std::size_t>(std::lower_bound(added.begin(), added.end(), kept[kept_at(i)], is_before) - added.begin());
    };
    merge(kept.subspan(kept_at(task), kept_at(task + 1) - kept_at(task)),
          added.subspan(added_at(task), added_at(task + 1) - added_at(task)), records, keeping, parts_[task].kept, parts_[task].out);
  };
  workers.for_each(tasks, [&](std::size_t task) { merge_part(task); });
  std::size_t kept_count = 0, out_count = 0;
  for (const Part& part : std::span(parts_).first(tasks)) {
    kept_count += part.kept.size();
    out_count += part.out.size();
  }
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

std::size_t KeptPairs::bytes() const {
  std::size_t pairs = kept_.capacity() + next_.capacity() + sorted_.capacity();
  for (const Part& part : parts_) {
    pairs += part.kept.capacity() + part.out.capacity();
  }
  return pairs * sizeof(ProxyPair) + parts_.capacity() * sizeof(Part);
}

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
module abut.scene.journal;
import abut.core.standard;

namespace abut {

void Journal::note(std::uint32_t slot, std::uint64_t time) {
  if (count_ == capacity) {
    known_from_ = std::max(known_from_, times_[next_]);
  }
  slots_[next_] = slot;
  times_[next_] = time;
  next_ = (next_ + 1) % capacity;
  count_ = std::min(count_ + 1, capacity);
}

void Journal::forget(std::uint64_t time) {
  known_from_ = time;
  count_ = 0;
}

std::optional<std::vector<std::uint32_t>> Journal::slots_after(std::uint64_t time) const {
  if (time < known_from_) {
    return std::nullopt;
  }
  std::vector<std::uint32_t> out;
  for (std::size_t i = 1; i <= count_; ++i) {
    const std::size_t at = (next_ + capacity - i) % capacity;
    if (times_[at] <= time) {
      break;
    }
    out.push_back(slots_[at]);
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace abut

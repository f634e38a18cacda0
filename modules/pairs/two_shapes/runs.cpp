// SPDX-License-Identifier: Apache-2.0
module abut.pairs.two_shapes.runs;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.warm.pair_memory;
import abut.pairs.registry;

namespace abut {

struct PairMemories::Room {
  std::vector<PairMemory> all;
};

PairMemories::PairMemories() : room_(std::make_unique<Room>()) {}
PairMemories::PairMemories(PairMemories&&) noexcept = default;
PairMemories& PairMemories::operator=(PairMemories&&) noexcept = default;
PairMemories::~PairMemories() = default;

std::uint32_t PairMemories::add() {
  room_->all.push_back({});
  return static_cast<std::uint32_t>(room_->all.size() - 1);
}
void PairMemories::forget(std::uint32_t place) { room_->all[place] = {}; }
bool PairMemories::knows_nothing(std::uint32_t place) const {
  return room_->all[place].state == PairMemory::State::nothing;
}
std::size_t PairMemories::size() const { return room_->all.size(); }
std::size_t PairMemories::bytes() const { return room_->all.capacity() * sizeof(PairMemory); }

Route route_of(std::size_t row, std::size_t column) { return pair_kernels(row, column).route; }
bool gains_from_memory(std::size_t row, std::size_t column) { return pair_kernels(row, column).gains_from_memory; }

void contacts_of_run(const RunKinds& kinds, std::span<const ShapeHandle> shapes, std::span<const Pose> poses,
                     std::span<const PairJob> jobs, const QuerySettings& common, PairMemories& memories, Manifold& out,
                     std::span<PairResult> results) {
  const PairKernels<AnyShape>& kernels = pair_kernels(kinds.row, kinds.column);
  QuerySettings settings = common;
  // Poses and memories of the pairs of a run lie anywhere.
  constexpr std::size_t ahead = 4;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (i + ahead < jobs.size()) {
      const PairJob& next = jobs[i + ahead];
      __builtin_prefetch(&poses[next.a].rotation);
      __builtin_prefetch(&poses[next.a].position);
      __builtin_prefetch(&poses[next.b].rotation);
      __builtin_prefetch(&poses[next.b].position);
      if (next.memory != no_memory) {
        __builtin_prefetch(&memories.room_->all[next.memory]);
      }
    }
    const PairJob& job = jobs[i];
    settings.margin = job.margin;
    PairMemory* const memory = job.memory == no_memory ? nullptr : &memories.room_->all[job.memory];
    const Outcome outcome = kernels.contacts_in_frame(*shapes[job.a], *shapes[job.b],
                                                      relative(poses[job.a], poses[job.b]), settings, memory, out);
    results[i] = {static_cast<std::uint32_t>(out.size()), outcome};
  }
}

Outcome contacts_in_frame(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                          Manifold& out) {
  return pair_kernels(a.index(), b.index()).contacts_in_frame(a, b, ab, settings, nullptr, out);
}

}  // namespace abut

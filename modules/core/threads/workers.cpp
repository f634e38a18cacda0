// SPDX-License-Identifier: Apache-2.0
module;

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#ifdef ABUT_TSAN
#include <sanitizer/tsan_interface.h>
#endif
module abut.core.workers;
import abut.core.memory.spare_blocks;
import abut.core.standard;

namespace abut {

struct Workers::Arena {
  tbb::task_arena arena;
};

namespace {

// Tasks come after what was done before all of them, and before what comes after all; not one after the other. oneTBB
// sees to that where ThreadSanitizer cannot look, so it has to be told.
struct Order {
#ifdef ABUT_TSAN
  char begun = 0, ended = 0;
  Order() { __tsan_release(&begun); }
  ~Order() { __tsan_acquire(&ended); }
  void begin_task() { __tsan_acquire(&begun); }
  void end_task() { __tsan_release(&ended); }
#else
  void begin_task() {}
  void end_task() {}
#endif
};
// One task, whichever way it ends.
struct [[gsl::Pointer]] Turn {
  Order& order;
  explicit Turn(Order& its) : order(its) { order.begin_task(); }
  ~Turn() { order.end_task(); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
};

// More threads than the process admits to oneTBB would not come, and oneTBB complains about them aloud. That is as many
// as the machine runs at once, unless the process has said otherwise with a tbb::global_control.
std::uint32_t possible(std::uint32_t threads) {
  const std::size_t most = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return static_cast<std::uint32_t>(threads == 0 ? most : std::min<std::size_t>(threads, most));
}

}  // namespace

Workers::Workers(std::uint32_t threads) : threads_(threads == 1 ? 1 : possible(threads)) {
  if (threads_ > 1) {
    arena_ = std::make_unique<Arena>(tbb::task_arena(static_cast<int>(threads_)));
  }
}

Workers::Workers(Workers&&) noexcept = default;
Workers& Workers::operator=(Workers&&) noexcept = default;
Workers::~Workers() = default;

void Workers::run(std::size_t count, void (*call)(void* task, std::size_t i), void* task) const {
  Order order;
  SpareBlocks::Use* const of_caller = SpareBlocks::Use::present();
  const auto run_one = [&](std::size_t i) {
    const Turn turn(order);
    std::optional<SpareBlocks::Use> use;
    if (of_caller != nullptr) {
      use.emplace(*of_caller);
    }
    call(task, i);
  };
  arena_->arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, run_one, tbb::simple_partitioner()); });
}

}  // namespace abut

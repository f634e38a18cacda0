module;

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
module abut.core.workers;
import abut.core.standard;

namespace abut {

struct Workers::Arena {
  tbb::task_arena arena;
};

namespace {

// More threads than the process admits to oneTBB would not come, and oneTBB complains about them aloud. That is as many as
// the machine runs at once, unless the process has said otherwise with a tbb::global_control.
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
  arena_->arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { call(task, i); }, tbb::simple_partitioner());
  });
}

}  // namespace abut

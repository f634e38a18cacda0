module;

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
module abut.core.workers;
import abut.core.standard;

namespace abut {

struct Workers::Arena {
  tbb::task_arena arena;
};

namespace {

// More threads than the machine runs at once only get in each other's way, and oneTBB complains about them aloud.
std::uint32_t possible(std::uint32_t threads) {
  const auto most = static_cast<std::uint32_t>(std::max(1, tbb::info::default_concurrency()));
  return threads == 0 ? most : std::min(threads, most);
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

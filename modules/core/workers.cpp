module;
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <thread>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
module abut.core.workers;

namespace abut {

struct Workers::Arena {
  tbb::task_arena arena;
};

Workers::Workers(std::uint32_t threads) : threads_(threads != 0 ? threads : std::max(1u, std::thread::hardware_concurrency())) {
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

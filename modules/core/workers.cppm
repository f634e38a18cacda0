// SPDX-License-Identifier: Apache-2.0
// Threads that share the work of one call.
export module abut.core.workers;
import abut.core.standard;

export namespace abut {

// A list cut into tasks of the same length, give or take one.
class Cuts {
 public:
  Cuts(std::size_t length, std::size_t tasks) : length_(length), tasks_(tasks) {}

  [[nodiscard]] inline std::size_t tasks() const noexcept { return tasks_; }
  [[nodiscard]] inline std::size_t begin(std::size_t task) const noexcept { return task * length_ / tasks_; }
  [[nodiscard]] inline std::size_t end(std::size_t task) const noexcept { return begin(task + 1); }
  template <class Element>
  [[nodiscard]] std::span<Element> of(std::span<Element> list, std::size_t task) const {
    return list.subspan(begin(task), end(task) - begin(task));
  }

 private:
  std::size_t length_, tasks_;
};

// With one thread nothing is started and everything runs in the caller. The threads belong to the process and
// are lent to a call while it runs.
class Workers {
 public:
  // 0: as many as there may be. The most are those that the machine runs at once, or the max_allowed_parallelism of a
  // tbb::global_control that the process holds.
  explicit Workers(std::uint32_t threads);
  Workers(Workers&&) noexcept;
  Workers& operator=(Workers&&) noexcept;
  ~Workers();

  [[nodiscard]] inline std::uint32_t threads() const noexcept { return threads_; }

  // Tasks of at least so many elements, as far as there are. There are enough of them for threads to end together. On
  // one thread it is one task.
  [[nodiscard]] inline Cuts cut(std::size_t length, std::size_t least_of_task) const {
    constexpr std::size_t tasks_of_thread = 8;
    return {length, threads_ == 1 ? 1 : std::clamp<std::size_t>(length / least_of_task, 1, tasks_of_thread * threads_)};
  }

  // Calls task(i) once for each i below count, in any order and on any of the threads, and returns when all are
  // done. What a task writes has to depend on i alone: that is what makes results independent of the threads.
  template <class Task>
  void for_each(std::size_t count, Task&& task) const {
    if (threads_ == 1 || count < 2) {
      for (std::size_t i = 0; i < count; ++i) {
        task(i);
      }
      return;
    }
    using Given = std::remove_reference_t<Task>;
    run(count, [](void* given, std::size_t i) { (*static_cast<Given*>(given))(i); }, &task);
  }

 private:
  struct Arena;
  void run(std::size_t count, void (*call)(void* task, std::size_t i), void* task) const;

  std::uint32_t threads_;
  std::unique_ptr<Arena> arena_;  // none for one thread
};

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// Lazy<T>: made when first asked for, by exactly one of the threads that ask.
export module abut.core.memory.lazy;
import abut.core.standard;

export namespace abut {

template <class T>
class Lazy {
 public:
  Lazy() = default;
  // A copy or a moved-to object makes its own; a lazy value is a cache, not state.
  Lazy(const Lazy&) noexcept {}
  Lazy& operator=(const Lazy&) = delete;
  ~Lazy() = default;

  template <class Maker>
  [[nodiscard]] const T& get(Maker&& make) const [[clang::lifetimebound]] {
    if (!made_.load(std::memory_order_acquire)) {
      const std::scoped_lock lock(mutex_);
      if (!made_.load(std::memory_order_relaxed)) {
        value_.emplace(std::forward<Maker>(make)());
        made_.store(true, std::memory_order_release);
      }
    }
    return *value_;
  }
  // For whoever is alone with the value and changes it along with what it was made of: none where it was not made.
  [[nodiscard]] std::optional<T>& made() noexcept [[clang::lifetimebound]] { return value_; }
  // For whoever is alone with the value, after what it was made of has changed.
  void forget() noexcept {
    made_.store(false, std::memory_order_relaxed);
    value_.reset();
  }
  [[nodiscard]] bool is_made() const noexcept { return made_.load(std::memory_order_acquire); }

 private:
  mutable std::mutex mutex_;
  mutable std::atomic<bool> made_{false};
  mutable std::optional<T> value_;
};

}  // namespace abut

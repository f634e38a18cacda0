// SPDX-License-Identifier: Apache-2.0
// Frozen<T>: shared immutable data with the value semantics of a plain T. The only owner of a
// shared_ptr; a change means a new Frozen, or a value that nobody else holds.
export module abut.core.memory.frozen;
import abut.core.standard;

export namespace abut {

template <class T>
class Frozen {
 public:
  explicit Frozen(T value) : data_(std::make_shared<T>(std::move(value))) {}

  [[nodiscard]] inline const T& operator*() const [[clang::lifetimebound]] { return *data_; }
  // A plain T to those who ask for one.
  [[nodiscard]] inline operator const T&() const [[clang::lifetimebound]] { return *data_; }
  [[nodiscard]] inline const T* operator->() const [[clang::lifetimebound]] { return data_.get(); }
  [[nodiscard]] bool same_as(const Frozen& other) const noexcept { return data_ == other.data_; }

  // The value to change: the one that is there, if nobody else holds it, else a copy, which nobody else holds. As
  // Rust's Arc::make_mut. Only the copy asks for memory, before anything has changed.
  [[nodiscard]] T& own() [[clang::lifetimebound]] {
    if (data_.use_count() == 1) {
      // Whatever the holders before did with the value happens before the change.
      std::atomic_thread_fence(std::memory_order_acquire);
    } else {
      data_ = std::make_shared<T>(std::as_const(*data_));
    }
    return *data_;
  }

 private:
  std::shared_ptr<T> data_;
};

}  // namespace abut

// SPDX-License-Identifier: Apache-2.0
// SmallVector: the first N elements live inside, more go to the heap. For trivial types; the inside
// elements are not initialised before they are pushed.
export module abut.core.memory.small_vector;
import abut.core.standard;

export namespace abut {

template <class T, std::size_t N>
class SmallVector {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_default_constructible_v<T>);

 public:
  inline SmallVector() {}  // leaves inside_ as it is, on purpose

  inline void push_back(const T& value) {
    if (size_ < N) [[likely]] {
      inside_[size_] = value;
    } else {
      spill(value);
    }
    ++size_;
  }
  // Appends the value only where it counts. It is written in any case, so that no branch has to be guessed.
  inline void push_back_if(const T& value, bool counts) {
    if (size_ < N) [[likely]] {
      inside_[size_] = value;
      size_ += counts ? 1 : 0;
    } else if (counts) {
      push_back(value);
    }
  }
  inline void pop_back() {
    if (size_ > N) [[unlikely]] {
      outside_.pop_back();
      if (outside_.size() == N) {
        std::ranges::copy(outside_, inside_.begin());
        outside_.clear();
      }
    }
    --size_;
  }
  inline void clear() {
    size_ = 0;
    outside_.clear();
  }
  [[nodiscard]] inline std::size_t size() const { return size_; }
  [[nodiscard]] inline bool empty() const { return size_ == 0; }
  [[nodiscard]] inline std::span<T> span() [[clang::lifetimebound]] {
    return size_ <= N ? std::span<T>(inside_).first(size_) : std::span<T>(outside_);
  }
  [[nodiscard]] inline std::span<const T> span() const [[clang::lifetimebound]] {
    return size_ <= N ? std::span<const T>(inside_).first(size_) : std::span<const T>(outside_);
  }
  [[nodiscard]] inline T& operator[](std::size_t index) [[clang::lifetimebound]] { return span()[index]; }
  [[nodiscard]] inline const T& operator[](std::size_t index) const [[clang::lifetimebound]] { return span()[index]; }

 private:
  // While there are more than N elements, outside_ holds all of them, so that they are one span.
  void spill(const T& value) {
    if (outside_.empty()) {
      outside_.assign(inside_.begin(), inside_.end());
    }
    outside_.push_back(value);
  }

  std::size_t size_ = 0;
  std::array<T, N> inside_;
  std::vector<T> outside_;
};

}  // namespace abut

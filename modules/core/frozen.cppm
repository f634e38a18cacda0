// Frozen<T>: shared immutable data with the value semantics of a plain T. The only owner of a
// shared_ptr; a change means a new Frozen.
export module abut.core.frozen;
import abut.core.standard;

export namespace abut {

template <class T>
class Frozen {
 public:
  explicit Frozen(T value) : data_(std::make_shared<const T>(std::move(value))) {}

  [[nodiscard]] inline const T& operator*() const [[clang::lifetimebound]] { return *data_; }
  [[nodiscard]] inline const T* operator->() const [[clang::lifetimebound]] { return data_.get(); }
  [[nodiscard]] bool same_as(const Frozen& other) const noexcept { return data_ == other.data_; }

 private:
  std::shared_ptr<const T> data_;
};

}  // namespace abut

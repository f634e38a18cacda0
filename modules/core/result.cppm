// Result<T>: a value or an Error. The members are named as in std::expected, without its unchecked
// operator*, so that C++23 code can take its place by renaming.
module;
#include <type_traits>
#include <utility>
#include <variant>
#include "check.hpp"
export module abut.core.result;
import abut.core.bug;
import abut.core.error;

export namespace abut {

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool has_value() const noexcept { return state_.index() == 0; }
  explicit operator bool() const noexcept { return has_value(); }

  [[nodiscard]] T& value() & [[clang::lifetimebound]] {
    ABUT_CHECK(has_value());
    return std::get<0>(state_);
  }
  [[nodiscard]] const T& value() const& [[clang::lifetimebound]] {
    ABUT_CHECK(has_value());
    return std::get<0>(state_);
  }
  [[nodiscard]] T value() && {
    ABUT_CHECK(has_value());
    return std::get<0>(std::move(state_));
  }
  [[nodiscard]] const Error& error() const& [[clang::lifetimebound]] {
    ABUT_CHECK(!has_value());
    return std::get<1>(state_);
  }
  [[nodiscard]] Error error() && {
    ABUT_CHECK(!has_value());
    return std::get<1>(std::move(state_));
  }

  template <class F>
  [[nodiscard]] auto and_then(F&& next) && -> std::invoke_result_t<F, T> {
    if (!has_value()) {
      return std::get<1>(std::move(state_));
    }
    return std::forward<F>(next)(std::get<0>(std::move(state_)));
  }
  template <class F>
  [[nodiscard]] auto transform(F&& change) && -> Result<std::invoke_result_t<F, T>> {
    if (!has_value()) {
      return std::get<1>(std::move(state_));
    }
    return std::forward<F>(change)(std::get<0>(std::move(state_)));
  }

 private:
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), failed_(true) {}

  [[nodiscard]] bool has_value() const noexcept { return !failed_; }
  explicit operator bool() const noexcept { return has_value(); }
  [[nodiscard]] const Error& error() const& [[clang::lifetimebound]] {
    ABUT_CHECK(failed_);
    return error_;
  }
  [[nodiscard]] Error error() && {
    ABUT_CHECK(failed_);
    return std::move(error_);
  }

 private:
  Error error_;
  bool failed_ = false;
};

}  // namespace abut

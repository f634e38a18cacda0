// SPDX-License-Identifier: Apache-2.0
// Result<T>: a value or an Error. The members are named as in std::expected, without its unchecked
// operator*, so that C++23 code can take its place by renaming.
module;
#include "check.hpp"
export module abut.core.result;
import abut.core.bug;
import abut.core.error;
import abut.core.standard;

export namespace abut {

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  Result(Error error) : error_(std::move(error)) {}

  [[nodiscard]] bool has_value() const noexcept { return value_.has_value(); }
  explicit operator bool() const noexcept { return has_value(); }

  [[nodiscard]] T& value() & [[clang::lifetimebound]] {
    ABUT_CHECK(has_value());
    return *value_;
  }
  [[nodiscard]] const T& value() const& [[clang::lifetimebound]] {
    ABUT_CHECK(has_value());
    return *value_;
  }
  [[nodiscard]] T value() && {
    ABUT_CHECK(has_value());
    return *std::move(value_);
  }
  [[nodiscard]] const Error& error() const& [[clang::lifetimebound]] {
    ABUT_CHECK(!has_value());
    return error_;
  }
  [[nodiscard]] Error error() && {
    ABUT_CHECK(!has_value());
    return std::move(error_);
  }

  template <class F>
  [[nodiscard]] auto and_then(F&& next) && -> std::invoke_result_t<F, T> {
    if (!has_value()) {
      return std::move(error_);
    }
    return std::forward<F>(next)(*std::move(value_));
  }
  template <class F>
  [[nodiscard]] auto transform(F&& change) && -> Result<std::invoke_result_t<F, T>> {
    if (!has_value()) {
      return std::move(error_);
    }
    return std::forward<F>(change)(*std::move(value_));
  }

 private:
  // No variant: clang 19 rejects its friends where a program includes <variant> and the name comes from a module as
  // well.
  std::optional<T> value_;
  Error error_;
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

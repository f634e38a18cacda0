// SPDX-License-Identifier: Apache-2.0
// How calls answer. With exceptions a call returns its value and throws an Error. With ABUT_NO_EXCEPTIONS, which is
// also set where the compiler has no exceptions, it returns a Result: the value or the Error.
#ifndef ABUT_CPP_ANSWER_HPP
#define ABUT_CPP_ANSWER_HPP

#include <abut/abut.h>
#include <abut/cpp/span.hpp>

#include <exception>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#if !defined(ABUT_NO_EXCEPTIONS) && !defined(__cpp_exceptions)
#define ABUT_NO_EXCEPTIONS
#endif

// Sources that answer in different ways may be linked to one program, since their names differ.
#ifdef ABUT_NO_EXCEPTIONS
#define ABUT_ANSWERS results
#else
#define ABUT_ANSWERS exceptions
#endif

namespace abut {

using Status = abut_status_value;

// What was wrong: the status for programs, the message of the library for people.
class Error : public std::runtime_error {
 public:
  Error(Status status, const std::string& message) : std::runtime_error(message), status_(status) {}

  [[nodiscard]] Status status() const noexcept { return status_; }
  // Such as "ABUT_OUT_OF_RANGE".
  [[nodiscard]] const char* name() const noexcept { return abut_status_name(status_); }

 private:
  Status status_;
};

// A value, or the reason why there is none. Who takes the value of an error, or the error of a value, ends the program.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Error error) : content_(std::move(error)) {}

  [[nodiscard]] bool has_value() const noexcept { return content_.index() == 0; }
  explicit operator bool() const noexcept { return has_value(); }

  [[nodiscard]] T& value() & noexcept { return *expect(std::get_if<0>(&content_)); }
  [[nodiscard]] const T& value() const& noexcept { return *expect(std::get_if<0>(&content_)); }
  [[nodiscard]] T value() && noexcept { return std::move(*expect(std::get_if<0>(&content_))); }
  [[nodiscard]] const Error& error() const noexcept { return *expect(std::get_if<1>(&content_)); }
  template <class U>
  [[nodiscard]] T value_or(U&& other) const& {
    return has_value() ? value() : static_cast<T>(std::forward<U>(other));
  }

  [[nodiscard]] T& operator*() & noexcept { return value(); }
  [[nodiscard]] const T& operator*() const& noexcept { return value(); }
  [[nodiscard]] T operator*() && noexcept { return std::move(*this).value(); }
  [[nodiscard]] T* operator->() noexcept { return &value(); }
  [[nodiscard]] const T* operator->() const noexcept { return &value(); }

 private:
  template <class Held>
  static Held* expect(Held* held) noexcept {
    if (held == nullptr) std::terminate();
    return held;
  }

  std::variant<T, Error> content_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  [[nodiscard]] bool has_value() const noexcept { return !error_.has_value(); }
  explicit operator bool() const noexcept { return has_value(); }
  [[nodiscard]] const Error& error() const noexcept {
    if (!error_) std::terminate();
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

inline namespace ABUT_ANSWERS {

#ifdef ABUT_NO_EXCEPTIONS
template <class T>
using Answer = Result<T>;
#else
template <class T>
using Answer = T;
#endif

namespace detail {

inline Error last_error(abut_status status) { return {static_cast<Status>(status), abut_last_error_message()}; }

#ifdef ABUT_NO_EXCEPTIONS
inline Result<void> answer(abut_status status) {
  return status == ABUT_OK ? Result<void>() : Result<void>(last_error(status));
}

// `make` is called when the status is good.
template <class Make>
Result<decltype(std::declval<Make>()())> answer_with(abut_status status, Make&& make) {
  if (status != ABUT_OK) return last_error(status);
  return make();
}
#else
[[noreturn]] inline void throw_last_error(abut_status status) { throw last_error(status); }

inline void answer(abut_status status) {
  if (status != ABUT_OK) throw_last_error(status);
}

template <class Make>
decltype(std::declval<Make>()()) answer_with(abut_status status, Make&& make) {
  if (status != ABUT_OK) throw_last_error(status);
  return make();
}
#endif

// What the call with this status has written.
template <class T>
Answer<T> answer(abut_status status, T& written) {
  return answer_with(status, [&] { return std::move(written); });
}

// What a call has written is taken by reference: an argument may be read before the call beside it is made.
inline Answer<bool> answer_bool(abut_status status, const std::uint32_t& written) {
  return answer_with(status, [&] { return written != 0; });
}

// What the call has written if it has found something.
template <class T, class Count>
Answer<std::optional<T>> answer_if_found(abut_status status, const Count& found, const T& written) {
  return answer_with(status, [&] { return found != 0 ? std::optional<T>(written) : std::nullopt; });
}

// Count-then-fill: `fill(data, capacity, count)` answers a status. Mostly the first call has room enough.
template <class T, class Fill>
Answer<std::vector<T>> collect(Fill&& fill) {
  std::vector<T> values(8);
  std::size_t count = 0;
  abut_status status = fill(values.data(), values.size(), &count);
  while (status == ABUT_OK && count > values.size()) {
    values.resize(count);
    status = fill(values.data(), values.size(), &count);
  }
  if (status == ABUT_OK) values.resize(count);
  return answer(status, values);
}

// The same for many queries: `fill(lists, &count)`. Nothing is asked after a status that is not ABUT_OK.
template <class Lists, class Fill>
Answer<Lists> collect_lists(std::size_t queries, abut_status status, Fill&& fill) {
  Lists lists;
  lists.offsets.resize(queries + 1);
  lists.all.resize(4 * queries);
  std::size_t count = 0;
  if (status == ABUT_OK) status = fill(lists, &count);
  if (status == ABUT_OK && count > lists.all.size()) {
    lists.all.resize(count);
    status = fill(lists, &count);
  }
  if (status == ABUT_OK) lists.all.resize(count);
  return answer(status, lists);
}

// Text, which is counted with the zero at its end.
template <class Fill>
Answer<std::string> collect_text(Fill&& fill) {
  std::string text(4096, '\0');
  std::size_t needed = 0;
  abut_status status = fill(text.data(), text.size(), &needed);
  while (status == ABUT_OK && needed > text.size()) {
    text.resize(needed);
    status = fill(text.data(), text.size(), &needed);
  }
  if (status == ABUT_OK) text.resize(needed == 0 ? 0 : needed - 1);
  return answer(status, text);
}

// How many samples a grid has; more than any array holds where the number does not fit.
inline std::size_t product_of(std::uint32_t columns, std::uint32_t rows, std::uint32_t layers) {
  const std::uint64_t of_layer = std::uint64_t{columns} * rows;
  const std::uint64_t most = std::numeric_limits<std::size_t>::max();
  return static_cast<std::size_t>(layers != 0 && of_layer > most / layers ? most : of_layer * layers);
}
// Arrays of one call have one length.
inline abut_status expect_as_many(const char* name, std::size_t size, const char* of, std::size_t expected) {
  if (size == expected) return ABUT_OK;
  const std::string message = std::string(name) + " has " + std::to_string(size) + " elements; it must have " +
                              std::to_string(expected) + ", as many as " + of;
  return abut_set_last_error(ABUT_INVALID_ARGUMENT, message.c_str());
}

template <class Number>
abut_status expect_whole(const char* name, const Triples<Number>& triples, std::size_t width = 3) {
  if (triples.number_count() % width == 0) return ABUT_OK;
  const std::string message = std::string(name) + " has " + std::to_string(triples.number_count()) +
                              " numbers; it must be a multiple of " + std::to_string(width);
  return abut_set_last_error(ABUT_INVALID_ARGUMENT, message.c_str());
}

// The first that is not ABUT_OK of statuses that are known already.
template <class... Statuses>
abut_status first_failure(Statuses... statuses) {
  abut_status first = ABUT_OK;
  static_cast<void>(((first = statuses, first == ABUT_OK) && ...));
  return first;
}

}  // namespace detail
}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif

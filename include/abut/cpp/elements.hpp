// SPDX-License-Identifier: Apache-2.0
// Elements of meshes that deform: what is near, touches or crosses.
#ifndef ABUT_CPP_ELEMENTS_HPP
#define ABUT_CPP_ELEMENTS_HPP

#include <abut/abut.h>
#include <abut/cpp/answer.hpp>
#include <abut/cpp/options.hpp>
#include <abut/cpp/shape.hpp>
#include <abut/cpp/values.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace abut {
inline namespace ABUT_ANSWERS {

// One owner: it moves, and is not copied. Only one thread at a time may use it.
class Elements {
 public:
  // Holds nothing; its calls answer ABUT_NULL_ARGUMENT.
  Elements() noexcept = default;
  [[nodiscard]] static Answer<Elements> of(const Shape& shape) {
    abut_elements* elements = nullptr;
    const abut_status status = abut_elements_create(shape.get(), &elements);
    return detail::answer_with(status, [&] { return Elements(elements); });
  }
  [[nodiscard]] abut_elements* get() const noexcept { return elements_.get(); }

  [[nodiscard]] Answer<ElementCounts> count() const {
    ElementCounts out;
    return detail::answer(abut_elements_count(get(), &out), out);
  }
  // The ends of all edges.
  [[nodiscard]] Answer<std::vector<std::array<std::uint32_t, 2>>> edges() const {
    return detail::collect<std::array<std::uint32_t, 2>>([&](auto* ends, std::size_t capacity, std::size_t* count) {
      return abut_elements_edges(get(), capacity == 0 ? nullptr : ends->data(), capacity, count);
    });
  }
  // Where the vertices are and stay.
  Answer<void> set_vertices(const Points& vertices) {
    const abut_status whole = detail::expect_whole("vertices", vertices);
    const std::size_t count = vertices.size();
    return detail::answer(whole != ABUT_OK ? whole
                                           : abut_elements_set_vertices(get(), vertices.data(), nullptr, count));
  }
  // Where they are at the start and at the end of a step.
  Answer<void> set_vertices(const Points& start, const Points& end) {
    const abut_status sizes =
        detail::first_failure(detail::expect_whole("start", start), detail::expect_whole("end", end),
                              detail::expect_as_many("end", end.size(), "start", start.size()));
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_elements_set_vertices(get(), start.data(), end.data(), start.size()));
  }

  // Of the mesh with itself, or with another one in the same frame.
  [[nodiscard]] Answer<std::vector<ElementPair>> candidates(OptionalRef<abut_elements_options> options = {}) {
    return candidates(*this, options);
  }
  [[nodiscard]] Answer<std::vector<ElementPair>> candidates(Elements& other,
                                                            OptionalRef<abut_elements_options> options = {}) {
    return collect<ElementPair>([&](auto* pairs, std::size_t capacity, std::size_t* count) {
      return abut_elements_candidates(get(), other.get(), options.get(), pairs, capacity, count);
    });
  }
  [[nodiscard]] Answer<std::vector<Stencil>> closest(OptionalRef<abut_elements_options> options = {}) {
    return closest(*this, options);
  }
  [[nodiscard]] Answer<std::vector<Stencil>> closest(Elements& other, OptionalRef<abut_elements_options> options = {}) {
    return collect<Stencil>([&](auto* stencils, std::size_t capacity, std::size_t* count) {
      return abut_elements_closest(get(), other.get(), options.get(), stencils, capacity, count);
    });
  }
  [[nodiscard]] Answer<std::vector<Stencil>> first_touches(OptionalRef<abut_elements_options> options = {}) {
    return first_touches(*this, options);
  }
  [[nodiscard]] Answer<std::vector<Stencil>> first_touches(Elements& other,
                                                           OptionalRef<abut_elements_options> options = {}) {
    return collect<Stencil>([&](auto* stencils, std::size_t capacity, std::size_t* count) {
      return abut_elements_first_touches(get(), other.get(), options.get(), stencils, capacity, count);
    });
  }
  [[nodiscard]] Answer<std::vector<Crossing>> crossings(OptionalRef<abut_elements_options> options = {}) {
    return crossings(*this, options);
  }
  [[nodiscard]] Answer<std::vector<Crossing>> crossings(Elements& other,
                                                        OptionalRef<abut_elements_options> options = {}) {
    return collect<Crossing>([&](auto* found, std::size_t capacity, std::size_t* count) {
      return abut_elements_crossings(get(), other.get(), options.get(), found, capacity, count);
    });
  }

 private:
  struct Destroy {
    void operator()(abut_elements* elements) const noexcept { abut_elements_destroy(elements); }
  };
  // Each call searches, so a list begins with room for as many as before.
  template <class T, class Fill>
  Answer<std::vector<T>> collect(Fill&& fill) {
    std::vector<T> values(room_);
    std::size_t count = 0;
    abut_status status = fill(values.data(), values.size(), &count);
    if (status == ABUT_OK && count > values.size()) {
      room_ = count + count / 4;
      values.resize(room_);
      status = fill(values.data(), values.size(), &count);
    }
    if (status == ABUT_OK) values.resize(count);
    return detail::answer(status, values);
  }
  explicit Elements(abut_elements* elements) noexcept : elements_(elements) {}

  std::unique_ptr<abut_elements, Destroy> elements_;
  std::size_t room_ = 1024;
};

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif

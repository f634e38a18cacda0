// SPDX-License-Identifier: Apache-2.0
// Help for misspelt names: what there is, and what was probably meant.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cli {

/// The first names with commas between them, and how many more there are.
[[nodiscard]] std::string listing(std::span<const std::string> names);

/// The name that is most like the word, if one is like it at all.
[[nodiscard]] std::optional<std::string> nearest(std::string_view word, std::span<const std::string> names);

/// "; did you mean 'radius'?" where a name is near enough to the word, else nothing.
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> names);

/// What there is of a thing, such as "part", and what was probably meant.
[[nodiscard]] std::string what_there_is(std::string_view of_what, std::string_view word,
                                        std::span<const std::string> names);

}  // namespace cli

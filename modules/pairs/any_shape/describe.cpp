// SPDX-License-Identifier: Apache-2.0
// Why a pair of kinds is answered the way it is, in words.
module abut.pairs.any_shape;
import abut.capability;
import abut.core.standard;
import abut.pairs.registry;
import abut.pairs.routes;

namespace abut {
namespace {

std::string_view reason_of(Route route) {
  switch (route) {
    case Route::half_space: return "a half-space against a convex shape";
    case Route::half_space_of_parts: return "a half-space against a surface";
    case Route::convex: return "both convex";
    case Route::parts: return "a surface against a convex shape";
    case Route::parts_of_both: return "two surfaces";
    case Route::scattered: return "many solids of one kind";
    case Route::hole: return "a hole against what is in it";
    case Route::hole_and_parts: return "a hole against a surface";
    case Route::hole_of_samples: return "a hole against a sampled solid";
    case Route::sampled: return "a sampled solid against a convex shape";
    case Route::sampled_and_parts: return "a sampled solid against a surface";
    case Route::sampled_both: return "two sampled solids";
    case Route::half_space_of_samples: return "a half-space against a sampled solid";
    case Route::children: return "a composite";
    case Route::unsupported:
    case Route::none: return "two that fill space without end: planes, holes";
  }
  return {};
}

template <class S>
constexpr RouteDescription self_description() {
  if constexpr (!meets_itself<S>()) {
    return {"unsupported", "solids do not meet themselves"};
  } else if constexpr (Scattered<S>) {
    return {"closed form", "each pair of its solids"};
  } else {
    return {"SAT, clipping", "each pair of its triangles without a common corner"};
  }
}

struct SelfKind {
  bool meets_itself;
  RouteDescription description;
};
constexpr auto self_kinds = []<std::size_t... Places>(std::index_sequence<Places...>) {
  return std::array<SelfKind, Shapes::count>{
      SelfKind{meets_itself<Shapes::At<Places>>(), self_description<Shapes::At<Places>>()}...};
}(std::make_index_sequence<Shapes::count>{});

}  // namespace

bool meets_itself(std::size_t place) { return self_kinds[place].meets_itself; }

RouteDescription describe_self(std::size_t place) { return self_kinds[place].description; }

RouteDescription describe_route(std::size_t place_a, std::size_t place_b) {
  const auto [low, high] = std::minmax(place_a, place_b);
  const auto& kernels = pair_kernels(low, high);
  return {kernels.searches(), reason_of(kernels.route)};
}

}  // namespace abut

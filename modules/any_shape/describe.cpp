// Why a pair of kinds is answered the way it is, in words.
module abut.any_shape;
import abut.core.standard;
import abut.registry;

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
    case Route::children: return "a composite";
    case Route::unsupported:
    case Route::none: return "terrain never meets terrain, and holes meet solids only";
  }
  return {};
}

}  // namespace

RouteDescription describe_route(std::size_t place_a, std::size_t place_b) {
  const auto [low, high] = std::minmax(place_a, place_b);
  const auto& kernels = pair_kernels(low, high);
  return {kernels.searches(), reason_of(kernels.route)};
}

}  // namespace abut

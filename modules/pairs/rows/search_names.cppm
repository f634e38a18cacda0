// SPDX-License-Identifier: Apache-2.0
// Which searches answer a pair of types of shapes, in words.
export module abut.pairs.rows.search_names;
import abut.capability;
import abut.core.standard;
import abut.narrow.convex;
import abut.narrow.fan.discs.disc_depth_of_pair;
import abut.narrow.fan.disc_pairs;
import abut.narrow.fan.hull_sat;
import abut.pairs.routes;

export namespace abut {

// What finds the distance of two cores that are apart, and the depth of two that overlap; radii are added to either.
// Where a closed form loses its digits, GJK takes over; where SAT finds too many axes or is in doubt, EPA does.
template <Convex A, Convex B>
[[nodiscard]] constexpr std::string_view name_searches() {
  constexpr bool are_box_cores = BoxCored<A> && BoxCored<B>;
  // Points and segments overlap by chance only.
  constexpr bool are_thin = (PointCored<A> || SegmentCored<A>) && (PointCored<B> || SegmentCored<B>);
  if constexpr (are_point_and_field<A, B> || are_thin) {
    return "closed form";
  } else if constexpr (FewFaced<A> && FewFaced<B>) {
    return are_box_cores ? "closed form apart, SAT in overlap" : "GJK apart, SAT in overlap";
  } else if constexpr (has_hull<A, B>) {
    return "GJK apart, SAT over facets in overlap";
  } else if constexpr (has_discs<A, B>) {
    return "GJK apart, SAT over facets and rims in overlap";
  } else {
    return "GJK apart, EPA in overlap";
  }
}

template <class A, class B>
[[nodiscard]] constexpr std::string_view name_algorithm() {
  constexpr Route way = route<A, B>();
  if constexpr (way == Route::unsupported) {
    return "unsupported";
  } else if constexpr (way == Route::half_space || way == Route::half_space_of_parts) {
    return "support point";
  } else if constexpr (way == Route::hole || way == Route::hole_and_parts) {
    return "walls, one by one";
  } else if constexpr (way == Route::half_space_of_samples || way == Route::hole_of_samples ||
                       way == Route::sampled_both) {
    return "points of the surface";
  } else if constexpr (way == Route::sampled || way == Route::sampled_and_parts) {
    return "descent of the field";
  } else if constexpr (way == Route::children) {
    return "as for the children, pair by pair";
  } else if constexpr (way == Route::convex) {
    return name_searches<A, B>();
  } else if constexpr (way == Route::parts || way == Route::parts_of_both) {
    return "nearest triangle apart, separating translation in overlap";
  } else if constexpr (Scattered<A>) {
    return name_algorithm<typename A::Part, B>();
  } else {
    return name_algorithm<A, typename B::Part>();
  }
}

}  // namespace abut

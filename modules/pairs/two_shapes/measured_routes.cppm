// SPDX-License-Identifier: Apache-2.0
// Ways to ask pairs of kinds, as they were measured, and which of them a time budget takes.
//
// The choice is made where options are read, once for a pair of kinds: no kernel knows of budgets. The table is one for
// the process and lies in static memory, so that a choice neither allocates nor waits.
export module abut.pairs.two_shapes.measured_routes;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

enum class Question : std::uint32_t { distance, contacts };

// Over ordinary pairs of two kinds.
struct MeasuredRoute {
  Algorithm algorithm = Algorithm::automatic;
  Real error_bound = 0;  // as in QuerySettings
  Real seconds = 0;      // of one question
  Real worst_error = 0;  // relative to the size of the shapes, as an error bound is
};

// What a caller grants, and asks for.
struct RouteWish {
  Real seconds = 0;      // of one question
  Real error_bound = 0;  // 0: none is asked for
};

// The place of the route to take; nothing where none of them will do.
//  - With an error bound: the cheapest whose worst error keeps it, for a bound goes before a budget.
//  - Without: of those that fit the time the one with the least worst error, and the cheapest of equals. If none fits,
//    the cheapest of all.
[[nodiscard]] std::optional<std::size_t> choose_route(std::span<const MeasuredRoute> routes, const RouteWish& wish);

// Of two kinds by their places among kinds in pairs, in either order. Empty for pairs that nobody has measured.
[[nodiscard]] std::span<const MeasuredRoute> measured_routes(Question question, std::size_t kind_a, std::size_t kind_b);

// The settings of the route that a time budget takes. An error bound stays as it is: it holds for every pair, while a
// worst error has been measured over some. An algorithm that a caller names stays as well.
void take_route(Question question, std::size_t kind_a, std::size_t kind_b, Real seconds, QuerySettings& settings);

// Puts another table in place of that of all pairs, from lines as `abut tune` writes them. Rows of kinds that this
// build lacks are left out. Nothing changes where the text is wrong. Not while another thread asks.
[[nodiscard]] Fault load_routes(std::string_view text);
// The table that abut comes with.
void restore_routes();

// The committed lines: measured_routes_text.cpp.
[[nodiscard]] std::string_view committed_routes();

}  // namespace abut

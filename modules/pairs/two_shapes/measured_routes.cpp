// SPDX-License-Identifier: Apache-2.0
module;
// Reading numbers is not among the names of abut.core.standard, on which everything depends.
#include <charconv>
module abut.pairs.two_shapes.measured_routes;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.pairs.any_shape;

namespace abut {
namespace {

constexpr std::size_t most_routes = 1024, cell_count = 2 * shape_kind_count * shape_kind_count;
constexpr std::array<std::string_view, 2> question_names{"distance", "contacts"};
// Those of an own search. The searches of libccd prove nothing about their errors.
constexpr std::array<std::string_view, 4> algorithm_names{"auto", "analytic", "sat", "gjk_epa"};

struct Row {
  std::size_t cell = 0;
  MeasuredRoute route;
};

// The routes of a cell lie beside each other.
struct RouteTable {
  std::array<MeasuredRoute, most_routes> routes;
  std::array<std::uint16_t, cell_count + 1> begins;

  // In the order of the rows.
  void fill(std::span<const Row> rows) {
    std::array<std::uint16_t, cell_count> next{};
    for (const Row& row : rows) {
      ++next[row.cell];
    }
    std::uint16_t begin = 0;
    for (std::size_t cell = 0; cell < cell_count; ++cell) {
      begins[cell] = begin;
      begin = static_cast<std::uint16_t>(begin + std::exchange(next[cell], begin));
    }
    begins[cell_count] = begin;
    for (const Row& row : rows) {
      routes[next[row.cell]++] = row.route;
    }
  }
};

std::size_t cell_of(Question question, std::size_t kind_a, std::size_t kind_b) {
  const auto [low, high] = std::minmax(kind_a, kind_b);
  return (static_cast<std::size_t>(question) * shape_kind_count + low) * shape_kind_count + high;
}

// Takes what stands before the next of some characters.
std::string_view take_until(std::string_view& text, char end) {
  const std::size_t length = std::min(text.find(end), text.size());
  const std::string_view taken = text.substr(0, length);
  text.remove_prefix(std::min(length + 1, text.size()));
  return taken;
}

Fault wrong_line(std::size_t number, std::string_view line, std::string_view expectation) {
  return Error{Errc::invalid_argument, "text: line " + std::to_string(number) + " is '" +
                                           std::string(line.substr(0, 80)) + "'; it must be " +
                                           std::string(expectation)};
}

bool read_number(std::string_view word, Real& number) {
  const auto [end, error] = std::from_chars(word.begin(), word.end(), number);
  return error == std::errc{} && end == word.end() && number >= 0 && number <= largest_coordinate;
}

template <std::size_t count>
bool read_name(std::string_view word, const std::array<std::string_view, count>& names, std::size_t& place) {
  place = static_cast<std::size_t>(std::ranges::find(names, word) - names.begin());
  return place < count;
}

// A row of seven words. `is_known`: whether this build has both kinds.
bool read_row(std::string_view line, Row& row, bool& is_known) {
  std::array<std::string_view, 7> words;
  for (std::string_view& word : words) {
    word = take_until(line, ' ');
  }
  std::size_t question = 0, algorithm = 0;
  MeasuredRoute& route = row.route;
  if (!line.empty() || !read_name(words[0], question_names, question) || words[1].empty() || words[2].empty() ||
      !read_name(words[3], algorithm_names, algorithm) || !read_number(words[4], route.error_bound) ||
      !read_number(words[5], route.seconds) || !read_number(words[6], route.worst_error)) {
    return false;
  }
  route.algorithm = static_cast<Algorithm>(algorithm);
  const auto a = find_kind(words[1]), b = find_kind(words[2]);
  is_known = a && b;
  if (is_known) {
    row.cell = cell_of(static_cast<Question>(question), kind_in_pairs(*a), kind_in_pairs(*b));
  }
  return true;
}

Fault read_rows(std::string_view text, std::vector<Row>& rows) {
  constexpr std::string_view head = "# abut routes 1";
  const std::string_view first = take_until(text, '\n');
  if (first != head) {
    return wrong_line(1, first, "'" + std::string(head) + "'");
  }
  for (std::size_t number = 2; !text.empty(); ++number) {
    const std::string_view line = take_until(text, '\n');
    if (line.empty() || line.front() == '#') {
      continue;
    }
    Row row;
    bool is_known = false;
    if (!read_row(line, row, is_known)) {
      return wrong_line(number, line,
                        "a question, two kinds, an algorithm, an error bound, seconds and a worst error, such as "
                        "'distance box box auto 0 1e-07 1e-15'");
    }
    if (is_known) {
      rows.push_back(row);
    }
  }
  return rows.size() <= most_routes ? Fault{}
                                    : Fault{error_about(Errc::out_of_range, "rows of text", std::uint64_t{rows.size()},
                                                        "at most " + std::to_string(most_routes))};
}

RouteTable& table() {
  static RouteTable its = [] {
    RouteTable made;
    std::vector<Row> rows;
    if (Fault fault = read_rows(committed_routes(), rows)) {
      rows.clear();
    }
    made.fill(rows);
    return made;
  }();
  return its;
}

bool is_better(const MeasuredRoute& one, const MeasuredRoute& other, bool by_error) {
  return by_error && one.worst_error != other.worst_error ? one.worst_error < other.worst_error
                                                          : one.seconds < other.seconds;
}

}  // namespace

std::optional<std::size_t> choose_route(std::span<const MeasuredRoute> routes, const RouteWish& wish) {
  const auto best = [&](bool by_error, auto&& is_allowed) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < routes.size(); ++i) {
      if (is_allowed(routes[i]) && (!found || is_better(routes[i], routes[*found], by_error))) {
        found = i;
      }
    }
    return found;
  };
  if (wish.error_bound > 0) {
    return best(false, [&](const MeasuredRoute& route) { return route.worst_error <= wish.error_bound; });
  }
  const auto in_time = best(true, [&](const MeasuredRoute& route) { return route.seconds <= wish.seconds; });
  return in_time ? in_time : best(false, [](const MeasuredRoute&) { return true; });
}

std::span<const MeasuredRoute> measured_routes(Question question, std::size_t kind_a, std::size_t kind_b) {
  const RouteTable& its = table();
  const std::size_t cell = cell_of(question, kind_a, kind_b);
  return std::span(its.routes).subspan(its.begins[cell], its.begins[cell + 1] - its.begins[cell]);
}

void take_route(Question question, std::size_t kind_a, std::size_t kind_b, Real seconds, QuerySettings& settings) {
  if (settings.algorithm != Algorithm::automatic) {
    return;
  }
  const std::span<const MeasuredRoute> routes = measured_routes(question, kind_a, kind_b);
  if (const auto place = choose_route(routes, {seconds, settings.error_bound})) {
    settings.algorithm = routes[*place].algorithm;
    settings.error_bound = settings.error_bound > 0 ? settings.error_bound : routes[*place].error_bound;
  }
}

Fault load_routes(std::string_view text) {
  std::vector<Row> rows;
  Fault fault = read_rows(text, rows);
  if (!fault) {
    table().fill(rows);
  }
  return fault;
}

void restore_routes() { static_cast<void>(load_routes(committed_routes())); }

}  // namespace abut

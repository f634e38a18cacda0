module abut.registry.self_contacts;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.narrowphase.self_contacts;
import abut.registry;
import abut.shape;

namespace abut {
namespace {

template <class S>
struct Named {};

template <std::size_t... Places>
constexpr std::array<RouteDescription, sizeof...(Places)> describe_all(std::index_sequence<Places...>) {
  const auto describe = []<class S>(Named<S>) {
    if constexpr (Scattered<S>) {
      return RouteDescription{"closed form", "each pair of its solids"};
    } else if constexpr (MeetsItself<S>) {
      return RouteDescription{"SAT, clipping", "each pair of its triangles without a common corner"};
    } else {
      return RouteDescription{"unsupported", "solids do not meet themselves"};
    }
  };
  return {describe(Named<Shapes::At<Places>>{})...};
}

template <std::size_t... Places>
constexpr std::array<bool, sizeof...(Places)> find_all(std::index_sequence<Places...>) {
  return {MeetsItself<Shapes::At<Places>>...};
}

using Places = std::make_index_sequence<Shapes::count>;

Outcome contacts_of(const AnyShape& shape, const QuerySettings& settings, Manifold& out) {
  return std::visit(
      [&]<class S>(const S& its) {
        if constexpr (MeetsItself<S>) {
          return self_contacts(its, settings, out);
        } else {
          return Outcome::unsupported;
        }
      },
      shape);
}

}  // namespace

bool meets_itself(std::size_t place) {
  static constexpr auto all = find_all(Places{});
  return all[place];
}

RouteDescription describe_self(std::size_t place) {
  static constexpr auto all = describe_all(Places{});
  return all[place];
}

void self_contacts_of_run(std::span<const Frozen<AnyShape>> shapes, std::span<const PairJob> jobs,
                          const QuerySettings& settings, Manifold& out, std::span<PairResult> results) {
  QuerySettings its = settings;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    its.margin = jobs[i].margin;
    const Outcome outcome = contacts_of(*shapes[jobs[i].a], its, out);
    results[i] = {static_cast<std::uint32_t>(out.size()), outcome};
  }
}

}  // namespace abut

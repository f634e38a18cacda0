// SPDX-License-Identifier: Apache-2.0
module abut.pairs.composites.self_contacts;
import abut.capability;
import abut.core.standard;
import abut.narrow.parts.self_contacts;
import abut.pairs.registry;
import abut.pairs.routes;

namespace abut {
namespace {

Outcome contacts_of(const AnyShape& shape, const QuerySettings& settings, Manifold& out) {
  return std::visit(
      [&]<class S>(const S& its) {
        if constexpr (meets_itself<S>()) {
          return self_contacts(its, settings, out);
        } else {
          return Outcome::unsupported;
        }
      },
      shape);
}

}  // namespace

void self_contacts_of_run(std::span<const ShapeHandle> shapes, std::span<const PairJob> jobs,
                          const QuerySettings& settings, Manifold& out, std::span<PairResult> results) {
  QuerySettings its = settings;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    its.margin = jobs[i].margin;
    const Outcome outcome = contacts_of(*shapes[jobs[i].a], its, out);
    results[i] = {static_cast<std::uint32_t>(out.size()), outcome};
  }
}

}  // namespace abut

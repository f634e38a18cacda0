// SPDX-License-Identifier: Apache-2.0
module abut.pairs.registry;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.rows.by_route;

// Members of a class that is attached to no module are not either.
extern "C++" {
namespace abut {

Result<AnyShape> AnyShape::make(std::uint32_t kind, std::span<const Real> parameters, std::span<const Real> reals,
                                std::span<const std::uint32_t> indices) {
  using Maker = Result<AnyShape> (*)(std::span<const Real>, std::span<const Real>, std::span<const std::uint32_t>);
  static constexpr auto makers = Shapes::for_each_kind([]<class S>() -> Maker {
    return [](std::span<const Real> own_parameters, std::span<const Real> own_reals,
              std::span<const std::uint32_t> own_indices) {
      return S::make(own_parameters, own_reals, own_indices).transform([](auto shape) {
        return AnyShape(std::move(shape));
      });
    };
  });
  for (std::size_t place = 0; place < makers.size(); ++place) {
    if (Shapes::kinds[place] == kind) {
      return makers[place](parameters, reals, indices);
    }
  }
  return error_about(Errc::unknown_value, "kind", std::uint64_t{kind}, "a kind of this build");
}

// Of a point outside, on or in a shape, in the frame of the shape.
std::optional<Distance> AnyShape::distance_to(const Vec3& point) const {
  return std::visit(
      [&]<class S>(const S& shape) -> std::optional<Distance> {
        if constexpr (Assembly<S>) {
          return std::nullopt;
        } else {
          Distance found{};
          const Pose placed{Rotation::identity(), point};
          return distance_by_route(core_of(shape), PointCore(0), placed, {}, found) == Outcome::ok
                     ? std::optional(found)
                     : std::nullopt;
        }
      },
      *this);
}

bool AnyShape::is_hole() const {
  return std::visit([]<class S>(const S&) { return Hole<S>; }, *this);
}

bool AnyShape::has_holes() const {
  return std::visit(
      []<class S>(const S& shape) {
        if constexpr (Assembly<S>) {
          return !shape.holes().empty();
        } else {
          return false;
        }
      },
      *this);
}

bool AnyShape::cavity_holds(const Vec3& point, Real inset) const {
  return std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (Hole<S>) {
          return is_within(shape, point, inset);
        } else {
          return false;
        }
      },
      *this);
}

}  // namespace abut
}

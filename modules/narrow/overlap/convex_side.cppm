// SPDX-License-Identifier: Apache-2.0
// A convex shape behind functions, for the question whether two shapes overlap, which is compiled once for all kinds.
export module abut.narrow.overlap.convex_side;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

// Cores that closed forms know: boxes around the origin along their own axes, a segment along Z being one of them.
enum class CoreForm : std::uint8_t { point, segment, box, other };

struct FormOfCore {
  CoreForm form;
  Vec3 half;  // of a core that closed forms know
  Real radius;
};
template <Convex B>
[[nodiscard]] inline FormOfCore form_of_core(const B& core) {
  if constexpr (BoxCored<B>) {
    constexpr CoreForm form = PointCored<B> ? CoreForm::point : SegmentCored<B> ? CoreForm::segment : CoreForm::box;
    return {form, core.half(), core.radius()};
  } else {
    return {CoreForm::other, {0, 0, 0}, core.radius()};
  }
}

// All is in the frame of the shape where nothing else is said.
class ConvexSide {
 public:
  // Of the core.
  Vec3 centre;
  Real extent;  // as in Convex
  Real radius;
  FormOfCore form;
  bool is_curved;

  // The point of the core that lies furthest in a direction.
  [[nodiscard]] virtual Vec3 support(const Vec3& direction) const = 0;
  // From the core to a point, negative inside; nothing where only a search tells it.
  [[nodiscard]] virtual std::optional<Real> distance_to(const Vec3& point) const = 0;
  // The box around the rounded shape where it is placed.
  [[nodiscard]] virtual Aabb box_at(const Pose& pose) const = 0;

 protected:
  ConvexSide(const Vec3& its_centre, Real its_extent, const FormOfCore& its_form, bool curved)
      : centre(its_centre), extent(its_extent), radius(its_form.radius), form(its_form), is_curved(curved) {}
  ConvexSide(const ConvexSide&) = default;
  ConvexSide& operator=(const ConvexSide&) = default;
  ~ConvexSide() = default;
};

// The functions of ConvexSide for a core, as part of `Side`, which may have more.
template <Convex B, class Side>
class [[gsl::Pointer]] CoreFunctions : public Side {
 public:
  explicit CoreFunctions(const B& core)
      : Side(core.centre(), core.extent(), form_of_core(core), Curved<B>), core_(core) {}

  [[nodiscard]] Vec3 support(const Vec3& direction) const override { return core_.support(direction).point; }
  [[nodiscard]] std::optional<Real> distance_to(const Vec3& point) const override {
    if constexpr (Field<B>) {
      return core_.nearest(point).distance;
    } else {
      return std::nullopt;
    }
  }
  [[nodiscard]] Aabb box_at(const Pose& pose) const override { return core_.aabb(pose); }

 protected:
  CoreFunctions(const CoreFunctions&) = default;
  CoreFunctions& operator=(const CoreFunctions&) = delete;
  ~CoreFunctions() = default;
  [[nodiscard]] const B& core() const [[clang::lifetimebound]] { return core_; }

 private:
  const B& core_;
};

template <Convex B>
class CoreSide final : public CoreFunctions<B, ConvexSide> {
 public:
  using CoreFunctions<B, ConvexSide>::CoreFunctions;
};

}  // namespace abut

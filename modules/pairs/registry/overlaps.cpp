// SPDX-License-Identifier: Apache-2.0
module abut.pairs.registry.overlaps;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.overlap.convex_overlap;
import abut.narrow.overlap.convex_side;
import abut.narrow.overlap.surfaces.surface_overlap;
import abut.pairs.composites.children;
import abut.pairs.registry;
import abut.pairs.routes;

namespace abut {
namespace {

// What is asked of a kind. Of two shapes the one whose role comes first asks the other.
enum class Role : std::uint8_t { assembly, hole, scattered, sampled, half_space, surface, convex };

template <class S>
[[nodiscard]] consteval Role role_of() {
  return Assembly<S>       ? Role::assembly
         : Hole<S>         ? Role::hole
         : Scattered<S>    ? Role::scattered
         : SampledSolid<S> ? Role::sampled
         : HalfSpace<S>    ? Role::half_space
         : Surface<S>      ? Role::surface
                           : Role::convex;
}
constexpr auto roles = []<std::size_t... Places>(std::index_sequence<Places...>) {
  return std::array<Role, Shapes::count>{role_of<Shapes::At<Places>>()...};
}(std::make_index_sequence<Shapes::count>{});

// Builds without a kind of such a role have no code for it.
[[nodiscard]] consteval bool has_role(Role role) { return std::ranges::find(roles, role) != roles.end(); }

struct [[gsl::Pointer]] Placed {
  const AnyShape& shape;
  Pose pose;

  [[nodiscard]] Role role() const { return roles[shape.index()]; }
};

[[nodiscard]] bool is_supported_pair(const AnyShape& a, const AnyShape& b) {
  const bool is_swapped = b.index() < a.index();
  return pair_kernels(is_swapped ? b.index() : a.index(), is_swapped ? a.index() : b.index()).route !=
         Route::unsupported;
}

using AskConvex = std::function<bool(ConvexSide&)>;

// Calls with a shape behind functions, which live as long as the call.
[[nodiscard]] bool ask_convex(const AnyShape& shape, const AskConvex& ask) {
  return std::visit(
      [&]<class S>(const S& its) {
        if constexpr (Convex<S>) {
          CoreSide<CoreOf<S>> side(core_of(its));
          return ask(side);
        } else {
          return false;
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

// Whether a surface and another one or the core of a convex shape are within reach.
[[nodiscard]] Met ask_surface(const Placed& surface, const Placed& other, Real reach, Fronts fronts) {
  const Pose ab = relative(surface.pose, other.pose);
  return std::visit(
      [&]<class A>(const A& a) {
        if constexpr (Surface<A>) {
          return std::visit(
              [&]<class B>(const B& b) {
                if constexpr (Convex<B>) {
                  return surface_meets(a, core_of(b), ab, reach, fronts);
                } else if constexpr (Surface<B>) {
                  return surface_meets(a, b, ab, reach, fronts);
                } else {
                  return Met::no;
                }
              },
              static_cast<const AnyShape::Variant&>(other.shape));
        } else {
          return Met::no;
        }
      },
      static_cast<const AnyShape::Variant&>(surface.shape));
}

template <class S>
[[nodiscard]] FormOfCore form_of_kind(const AnyShape& shape) {
  if constexpr (Convex<S>) {
    return form_of_core(*std::get_if<S>(&static_cast<const AnyShape::Variant&>(shape)));
  } else {
    return {CoreForm::other, {0, 0, 0}, 0};
  }
}
constexpr auto forms_of_kinds = []<std::size_t... Places>(std::index_sequence<Places...>) {
  return std::array<FormOfCore (*)(const AnyShape&), Shapes::count>{form_of_kind<Shapes::At<Places>>...};
}(std::make_index_sequence<Shapes::count>{});

class [[gsl::Pointer]] OverlapQuestion {
 public:
  OverlapQuestion(Real margin, OverlapRule rule, Manifold& scratch)
      : margin_(margin),
        rule_(rule),
        fronts_(rule == OverlapRule::of_contacts ? Fronts::respected : Fronts::ignored),
        scratch_(scratch) {}

  [[nodiscard]] Outcome ask(const Placed& one, const Placed& two, bool& out) const {
    const bool is_swapped = two.role() < one.role();
    const Placed &a = is_swapped ? two : one, &b = is_swapped ? one : two;
    if (!is_supported_pair(a.shape, b.shape)) {
      return Outcome::unsupported;
    }
    const Role role = a.role();
    if constexpr (has_role(Role::assembly)) {
      if (role == Role::assembly) {
        return ask_children(a, b, out);
      }
    }
    if constexpr (has_role(Role::scattered)) {
      if (role == Role::scattered) {
        return ask_many(a, b, out);
      }
    }
    if constexpr (has_role(Role::sampled)) {
      if (role == Role::sampled) {
        return ask_sampled(a, b, out);
      }
    }
    if constexpr (has_role(Role::surface)) {
      if (role == Role::surface) {
        return b.role() == Role::surface ? ask_surfaces(a, b, out) : ask_surface_beside(a, b, out);
      }
    }
    return role == Role::convex       ? ask_cores(a, b, out)
           : role == Role::half_space ? ask_half_space(a, b, out)
                                      : ask_in_full(a, b, out);
  }

 private:
  // By a search for how deep, or how far. Without an upper bound nothing is left that could be met: holes took all of
  // it.
  [[nodiscard]] Outcome ask_in_full(const Placed& a, const Placed& b, bool& out) const {
    const QuerySettings settings{.margin = margin_};
    if (rule_ == OverlapRule::of_contacts) {
      scratch_.clear();
      const Outcome outcome = contacts_of_pair(a.shape, b.shape, a.pose, b.pose, settings, scratch_);
      out = !scratch_.empty();
      return outcome;
    }
    Distance found{};
    const auto ask_distance = [&](const PairKernels<AnyShape>& kernels, const AnyShape& first, const AnyShape& second,
                                  const Pose& first_pose, const Pose& second_pose, bool from_b) {
      return kernels.distance(first, second, first_pose, second_pose, from_b, settings, found);
    };
    const Outcome outcome = ask_in_order(a.shape, b.shape, a.pose, b.pose, ask_distance);
    out = found.upper < infinity && found.distance <= margin_;
    return outcome;
  }

  [[nodiscard]] Outcome ask_cores(const Placed& a, const Placed& b, bool& out) const {
    const FormOfCore form_a = forms_of_kinds[a.shape.index()](a.shape),
                     form_b = forms_of_kinds[b.shape.index()](b.shape);
    if (const Real reach = margin_ + (form_a.radius + form_b.radius); reach >= 0) {
      if (const std::optional<bool> answer = are_forms_within(form_a, form_b, relative(a.pose, b.pose), reach)) {
        out = *answer;
        return Outcome::ok;
      }
    }
    bool is_covered = true;
    const auto ask_both = [&](const ConvexSide& first, const ConvexSide& second) {
      const Real reach = margin_ + (first.radius + second.radius);
      is_covered = reach >= 0;
      return is_covered && are_cores_within(first, second, relative(a.pose, b.pose), reach);
    };
    const auto ask_first = [&](ConvexSide& first) {
      const auto ask_second = [&](ConvexSide& second) { return ask_both(first, second); };
      return ask_convex(b.shape, [&ask_second](ConvexSide& second) { return ask_second(second); });
    };
    out = ask_convex(a.shape, [&ask_first](ConvexSide& first) { return ask_first(first); });
    return is_covered ? Outcome::ok : ask_in_full(a, b, out);
  }

  // A depth along one triangle is no deeper than that of the whole.
  [[nodiscard]] Outcome ask_surface_beside(const Placed& a, const Placed& b, bool& out) const {
    const Real radius = forms_of_kinds[b.shape.index()](b.shape).radius, reach = margin_ + radius;
    Met met = reach >= 0 ? ask_surface(a, b, reach, fronts_) : Met::no;
    if (margin_ < 0 && met == Met::no) {
      met = ask_surface(a, b, radius, fronts_) == Met::no ? Met::no : Met::left_to_contacts;
    }
    out = met == Met::yes;
    return met == Met::left_to_contacts ? ask_in_full(a, b, out) : Outcome::ok;
  }

  [[nodiscard]] Outcome ask_surfaces(const Placed& a, const Placed& b, bool& out) const {
    const Met met = ask_surface(a, b, std::fmax(margin_, 0.0), fronts_);
    out = met == Met::yes;
    return met == Met::left_to_contacts || (out && margin_ < 0) ? ask_in_full(a, b, out) : Outcome::ok;
  }

  // The lowest triangle of a surface is found as quickly as any below the plane.
  [[nodiscard]] Outcome ask_half_space(const Placed& a, const Placed& b, bool& out) const {
    if (b.role() == Role::surface) {
      return ask_in_full(a, b, out);
    }
    Vec3 down{0, 0, 0};  // toward the half-space, in the frame of b
    Real height = 0;     // of its plane along that
    std::visit(
        [&]<class S>(const S& its) {
          if constexpr (HalfSpace<S>) {
            const Pose ab = relative(a.pose, b.pose);
            down = ab.rotation.undo(its.normal());
            height = its.offset() - dot(its.normal(), ab.position);
          }
        },
        static_cast<const AnyShape::Variant&>(a.shape));
    const Real limit = height + margin_;
    const auto ask = [&](const ConvexSide& core) {
      const Real lowest = dot(down, core.support(-down)) - core.radius;
      return lowest <= limit + rounding_of(std::fabs(limit) + core.extent);
    };
    out = ask_convex(b.shape, [&ask](ConvexSide& core) { return ask(core); });
    return Outcome::ok;
  }

  // The value at the middle of a core mostly tells enough.
  [[nodiscard]] Outcome ask_sampled(const Placed& a, const Placed& b, bool& out) const {
    if (b.role() != Role::convex) {
      return ask_in_full(a, b, out);
    }
    std::optional<bool> answer;
    const auto ask = [&](const ConvexSide& core) {
      std::visit(
          [&]<class S>(const S& its) {
            if constexpr (SampledSolid<S>) {
              const Vec3 point = relative(a.pose, b.pose) * core.support({0, 0, 1});
              // No point of the core is further from another one than twice as far as from its centre.
              constexpr Real across = 4;
              const Real value = its.value_at(point).value,
                         radius = across * core.extent + core.radius + std::fmax(margin_, 0.0);
              if (margin_ >= 0 && value < 0) {
                answer = true;
              } else if (its.least_within(value, radius) > 0) {
                answer = false;
              }
            }
          },
          static_cast<const AnyShape::Variant&>(a.shape));
      return answer.value_or(false);
    };
    out = ask_convex(b.shape, [&ask](ConvexSide& core) { return ask(core); });
    return answer ? Outcome::ok : ask_in_full(a, b, out);
  }

  // Each of many balls by itself.
  [[nodiscard]] Outcome ask_many(const Placed& a, const Placed& b, bool& out) const {
    if (b.role() == Role::sampled || margin_ < 0) {
      return ask_in_full(a, b, out);
    }
    out = std::visit(
        [&]<class S>(const S& its) {
          if constexpr (Scattered<S>) {
            return is_any_within(its, a.pose, b);
          } else {
            return false;
          }
        },
        static_cast<const AnyShape::Variant&>(a.shape));
    return Outcome::ok;
  }
  template <Scattered S>
  [[nodiscard]] bool is_any_within(const S& many, const Pose& pose, const Placed& b) const {
    const Pose ab = relative(pose, b.pose);
    Aabb near = box_of(b.shape, ab).inflated(margin_ + noise_of(largest_magnitude(ab.position)));
    bool is_found = false;
    const auto ask_each = [&](const auto& ask_one) {
      many.visit_places(near, [&](const Vec3& place, std::uint32_t index) {
        if (!is_found) {
          const auto part = many.part(index);
          CoreSide<CoreOf<typename S::Part>> side(core_of(part));
          is_found = ask_one(side, Pose{ab.rotation, ab.position - place});
        }
      });
      return is_found;
    };
    if (b.role() == Role::convex) {
      const auto ask = [&](const ConvexSide& core) {
        return ask_each([&](const ConvexSide& part, const Pose& to_core) {
          return are_cores_within(part, core, to_core, margin_ + (part.radius + core.radius));
        });
      };
      return ask_convex(b.shape, [&ask](ConvexSide& core) { return ask(core); });
    }
    return std::visit(
        [&]<class O>(const O& other) {
          if constexpr (Surface<O>) {
            return is_any_among(many, near, other, ab);
          } else if constexpr (HalfSpace<O>) {
            const Vec3 normal = ab.rotation * other.normal();
            const Real height = other.offset() + dot(normal, ab.position) + margin_;
            return ask_each([&](const ConvexSide& part, const Pose& to_plane) {
              const Vec3 place = ab.position - to_plane.position;
              return dot(normal, place) - part.radius <= height + rounding_of(std::fabs(height) + part.radius);
            });
          } else if constexpr (Scattered<O>) {
            return ask_each([&](const ConvexSide& part, const Pose& to_other) {
              const Vec3 place = to_other.undo({0, 0, 0});
              const Real reach = part.radius + margin_;
              Aabb around = Aabb::around(place, {reach, reach, reach});
              bool is_met = false;
              other.visit_places(around, [&](const Vec3& beside, std::uint32_t index) {
                const Real both = reach + other.part(index).radius() + rounding_of(largest_magnitude(place));
                is_met = is_met || squared_norm(beside - place) <= both * both;
              });
              return is_met;
            });
          } else {
            return false;
          }
        },
        static_cast<const AnyShape::Variant&>(b.shape));
  }

  // A ball is on one side of a front.
  template <Scattered S, Surface O>
  [[nodiscard]] bool is_any_among(const S& many, Aabb& near, const O& surface, const Pose& ab) const {
    bool is_found = false;
    many.visit_places(near, [&](const Vec3& place, std::uint32_t index) {
      if (!is_found) {
        const auto part = many.part(index);
        const Pose to_surface{ab.rotation, ab.position - place};
        is_found =
            surface_meets(surface, core_of(part), to_surface.inverse(), margin_ + part.radius(), fronts_) == Met::yes;
      }
    });
    return is_found;
  }

  // Some children may have no answer, as two terrains; no answer at all is one of the whole. Holes take away from
  // solids only: what these do not overlap, the whole does not.
  [[nodiscard]] Outcome ask_children(const Placed& a, const Placed& b, bool& out) const {
    std::optional<Outcome> last;
    bool is_any_ok = false, is_found = false;
    const auto ask_child = [&](const AnyShape& of_a, const Pose& pose_a, std::uint32_t, const AnyShape& of_b,
                               const Pose& pose_b, std::uint32_t) {
      if (is_found) {
        return;
      }
      const Outcome outcome = ask({of_a, pose_a}, {of_b, pose_b}, is_found);
      is_any_ok = is_any_ok || outcome == Outcome::ok;
      last = outcome;
      is_found = is_found && outcome == Outcome::ok;
    };
    const Pose ab = relative(a.pose, b.pose);
    const Real reach = std::fmax(margin_, 0.0) + noise_of(largest_magnitude(ab.position));
    visit_pairs_of_children(a.shape, b.shape, ab, reach, ask_child);
    out = is_found;
    if (is_found && (a.shape.has_holes() || b.shape.has_holes())) {
      return ask_in_full(a, b, out);
    }
    return is_any_ok || !last ? Outcome::ok : *last;
  }

  Real margin_;
  OverlapRule rule_;
  Fronts fronts_;
  Manifold& scratch_;
};

// How far a shape reaches from its origin; infinity where that takes too long to tell.
template <class S>
[[nodiscard]] Real reach_of_kind(const AnyShape& shape) {
  const S& its = *std::get_if<S>(&static_cast<const AnyShape::Variant&>(shape));
  constexpr Real loose = 2;  // see the extent of Convex
  if constexpr (BoxCored<S>) {
    return norm(its.half()) + its.radius();
  } else if constexpr (Convex<S>) {
    return norm(its.centre()) + loose * its.extent() + its.radius();
  } else if constexpr (Surface<S> || Scattered<S>) {
    const Aabb box = its.aabb(Pose::identity());
    return norm(maximum(absolute(box.low), absolute(box.high)));
  } else {
    return infinity;
  }
}
constexpr auto reaches_of_kinds = []<std::size_t... Places>(std::index_sequence<Places...>) {
  return std::array<Real (*)(const AnyShape&), Shapes::count>{reach_of_kind<Shapes::At<Places>>...};
}(std::make_index_sequence<Shapes::count>{});

}  // namespace

bool are_far_apart(const AnyShape& a, const AnyShape& b, const Vec3& from, const Vec3& to, Real margin) {
  const Real both = reaches_of_kinds[a.index()](a) + reaches_of_kinds[b.index()](b);
  const Real reach = both + std::fmax(margin, 0.0) + noise_of(both + largest_magnitude(from) + largest_magnitude(to));
  return squared_norm(to - from) > reach * reach && is_supported_pair(a, b);
}

Outcome ask_overlap(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b, Real margin,
                    OverlapRule rule, Manifold& scratch, bool& out) {
  return OverlapQuestion(margin, rule, scratch).ask({a, pose_a}, {b, pose_b}, out);
}

}  // namespace abut

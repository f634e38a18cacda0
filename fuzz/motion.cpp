// SPDX-License-Identifier: Apache-2.0
// Motions of two shapes from bytes, and the judge of times of impact. The distance judges, which other targets judge.
module;
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>
module abut.fuzz;
import abut.math.turn;

namespace abut::fuzz {
namespace {

constexpr int sample_count = 64;
// Enough for all that is no search along a face.
constexpr ImpactOptions options{.most_rounds = 200};

// From the bits of any number to one within a range, small ones as they are.
Real held(Real value, Real most) { return std::clamp(tamed(value), -most, most); }

Vec3 held_vector(const MovingRecord& record, std::size_t first, Real most) {
  const auto number = [&](std::size_t index) { return held(record.motion[first + index], most); };
  return {number(0), number(1), number(2)};
}

// Velocities are multiples of the size of the scene. So a giant and a speck meet in time as well.
struct NamedMotion {
  Motion motion;
  Vec3 centre;
};
NamedMotion motion_of(const MovingRecord& record, std::size_t first, Real size) {
  constexpr Real most_sizes = 4, most_turn = 20, most_turn_change = 16;
  const auto has = [&](std::uint8_t bit) { return (record.aim & bit) != 0; };
  NamedMotion out;
  out.motion.velocity = size * held_vector(record, first, most_sizes);
  out.motion.angular_velocity = has(turns_not) ? Vec3{0, 0, 0} : held_vector(record, first + 3, most_turn);
  if (!has(speeds_not_up)) {
    out.motion.acceleration = size * held_vector(record, first + 6, most_sizes);
    out.motion.angular_acceleration = has(turns_not) ? Vec3{0, 0, 0} : held_vector(record, first + 9, most_turn_change);
  }
  out.centre = size * held_vector(record, first + 12, 1);
  return out;
}

Result<Distance> distance_at(const MovingScene& moving, Real time) {
  Distance out{};
  const Outcome outcome =
      pair_distance(moving.scene.a, moving.scene.b, moving.path_a.at(time), moving.path_b.at(time), {}, out);
  if (outcome != Outcome::ok) {
    return Error{Errc::unsupported, "no distance"};
  }
  return out;
}

// What the aim makes of the velocities of numbers.
void aim_at(const MovingRecord& record, const Scene& scene, NamedMotion& a, NamedMotion& b) {
  const auto has = [&](std::uint8_t bit) { return (record.aim & bit) != 0; };
  if (has(rests)) {
    a.motion = {};
  }
  Distance gap{};
  const bool is_known = pair_distance(scene.a, scene.b, scene.ab, {}, gap) == Outcome::ok && is_finite(gap.normal) &&
                        std::isfinite(gap.distance);
  if (has(meets) && is_known) {
    b.motion.velocity = a.motion.velocity - 2 * gap.distance * gap.normal;
  }
  if (has(grazes) && is_known) {
    const Vec3 relative_velocity = b.motion.velocity - a.motion.velocity;
    b.motion.velocity += -dot(relative_velocity, gap.normal) * gap.normal;
  }
  if (has(moves_alike)) {
    b.motion = a.motion;
    b.centre = scene.ab.undo(a.centre);
  }
}

std::string fault(std::string_view what, Real got, Real expected) {
  return std::string(what) + ": got " + to_text(got) + ", expected " + to_text(expected);
}

// Lets through what comes from behind: there a distance says less than a touch. Solid meshes do not.
bool has_one_side(const AnyShape& shape) {
  if (kind_name(shape.index()) == "height_field") {
    return true;
  }
  return std::visit(
      []<class S>(const S& s) {
        if constexpr (Assembly<S>) {
          return std::ranges::any_of(s.children(), [](const auto& child) { return has_one_side(*child.shape); });
        } else if constexpr (requires { s.triangle_count(); }) {
          return s.parameters()[0] == 1;
        } else {
          return false;
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}
bool is_seen_from_all_sides(const Scene& scene) { return !has_one_side(scene.a) && !has_one_side(scene.b); }

// Lengths that rounding may take, the way of the bodies included.
Real noise_of(const MovingScene& moving) {
  const auto way = [](const Path& path) { return path.largest_speed(path.whole(), 0); };
  const auto arm = [](const Path& path) { return norm(path.centre_at(0) - path.start().position); };
  return tolerance(moving.scene) +
         1e-10 * (way(moving.path_a) + way(moving.path_b) + arm(moving.path_a) + arm(moving.path_b));
}

// Samples show no overlap deeper than rounding.
Verdict judge_free(const MovingScene& moving, const TimeSpan& span, std::string_view what) {
  const Real noise = noise_of(moving);
  for (int i = 0; i < sample_count; ++i) {
    const Result<Distance> gap = distance_at(moving, span.begin + span.length() * i / sample_count);
    if (gap && gap.value().upper < -noise) {
      return fault(what, gap.value().upper, -noise) + " at sample " + std::to_string(i);
    }
  }
  return std::nullopt;
}

std::optional<Impact> ask(const MovingScene& moving) {
  Impact out;
  const Outcome outcome =
      time_of_impact({moving.scene.a, moving.path_a}, {moving.scene.b, moving.path_b}, options, out);
  return outcome == Outcome::ok ? std::optional(out) : std::nullopt;
}

// Two answers about the same motion. A touch that only one tells is a graze: nothing is deep until the other's time.
Verdict compare(const MovingScene& moving, const Impact& found, const Impact& other, std::string_view what) {
  const Real begin = std::min(found.upper, other.upper), end = std::max(found.lower, other.lower);
  if (!(begin < end) || !is_seen_from_all_sides(moving.scene)) {
    return std::nullopt;
  }
  return judge_free(moving, {begin, end}, what);
}

Verdict judge_swap(const MovingScene& moving, const Impact& found) {
  const MovingScene turned{
      {moving.scene.b, moving.scene.a, moving.scene.ab.inverse(), moving.scene.margin, moving.scene.size},
      moving.path_b,
      moving.path_a};
  const auto other = ask(turned);
  if (!other) {
    return "swapped shapes have no time of impact";
  }
  if (other->state != found.state || other->lower != found.lower || other->upper != found.upper) {
    return fault("time of impact of swapped shapes", other->upper, found.upper);
  }
  return std::nullopt;
}

// Both bodies in a frame that is turned and shifted.
Verdict judge_frame(const MovingScene& moving, const Impact& found) {
  const Pose frame{rotation_by({0.3, -1.1, 0.7}), moving.scene.size * Vec3{0.4, -0.8, 0.6}};
  const auto placed = [&](const Path& path) {
    const Motion& motion = path.motion();
    const Rotation& turn = frame.rotation;
    const Motion turned{turn * motion.velocity, turn * motion.angular_velocity, turn * motion.acceleration,
                        turn * motion.angular_acceleration};
    return Path::along(frame * path.start(), path.start().undo(path.centre_at(0)), turned, path.duration());
  };
  const auto a = placed(moving.path_a), b = placed(moving.path_b);
  if (!a || !b) {
    return std::nullopt;
  }
  const auto other = ask({moving.scene, a.value(), b.value()});
  return other ? compare(moving, found, *other, "gap until the later of two times, one in another frame")
               : Verdict("no time of impact in another frame");
}

// A motion whose axes are fixed goes on where its first half ends.
Verdict judge_halves(const MovingScene& moving, const Impact& found) {
  const auto is_steady = [](const Path& path) { return squared_norm(path.motion().angular_acceleration) == 0; };
  if (!is_steady(moving.path_a) || !is_steady(moving.path_b)) {
    return std::nullopt;
  }
  const Real half = 0.5 * moving.path_a.duration();
  const auto part = [&](const Path& path, Real time) {
    Motion motion = path.motion();
    motion.velocity = path.velocity_at(time);
    return Path::along(path.at(time), path.start().undo(path.centre_at(0)), motion, half).value();
  };
  const auto first = ask({moving.scene, part(moving.path_a, 0), part(moving.path_b, 0)});
  if (!first) {
    return "no time of impact of a half";
  }
  Impact both = *first;
  if (first->state == ImpactState::apart) {
    const auto second = ask({moving.scene, part(moving.path_a, half), part(moving.path_b, half)});
    if (!second) {
      return "no time of impact of the second half";
    }
    both.lower = half + second->lower;
    both.upper = half + second->upper;
  }
  return compare(moving, found, both, "gap until the later of two times, one in two halves");
}

}  // namespace

MovingRecord read_moving_record(std::span<const std::uint8_t> bytes) {
  const auto byte = [&](std::size_t index) { return index < bytes.size() ? bytes[index] : std::uint8_t{0}; };
  MovingRecord record{.scene = read_record(bytes), .aim = byte(record_size)};
  for (std::size_t i = 0; i < motion_number_count; ++i) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      bits |= std::uint64_t{byte(record_size + 1 + 8 * i + k)} << (8 * k);
    }
    record.motion[i] = std::bit_cast<Real>(bits);
  }
  return record;
}

std::array<std::uint8_t, moving_record_size> bytes_of(const MovingRecord& record) {
  std::array<std::uint8_t, moving_record_size> bytes{};
  std::ranges::copy(bytes_of(record.scene), bytes.begin());
  bytes[record_size] = record.aim;
  for (std::size_t i = 0; i < motion_number_count; ++i) {
    const auto bits = std::bit_cast<std::uint64_t>(record.motion[i]);
    for (std::size_t k = 0; k < 8; ++k) {
      bytes[record_size + 1 + 8 * i + k] = static_cast<std::uint8_t>((bits >> (8 * k)) & 0xff);
    }
  }
  return bytes;
}

MovingRecord random_moving_record(std::uint64_t seed) {
  MovingRecord record{.scene = random_record(seed)};
  Random random(seed ^ 0x6d6f74696f6e);
  // Mostly so far away that they are apart at the start, and so aimed that they meet.
  for (Real& coordinate : record.scene.position) {
    coordinate *= random.between(1, 8);
  }
  const std::uint64_t rare = random.bits() & random.bits() & random.bits();
  const bool is_aimed = random.below(4) != 0;
  record.aim = static_cast<std::uint8_t>((rare & 0x7e) | (is_aimed ? meets : 0));
  const Real turning = std::exp2(random.between(-3, 4));
  for (std::size_t i = 0; i < motion_number_count; ++i) {
    const std::size_t vector = i / 3 % 5;
    const Real magnitude = vector == 1 || vector == 3 ? turning : 0.75;
    record.motion[i] = random.below(5) == 0 ? 0 : random.between(-magnitude, magnitude);
  }
  return record;
}

Result<MovingScene> make_moving_scene(std::size_t place_a, std::size_t place_b, const MovingRecord& record) {
  Record placed = record.scene;
  if ((record.aim & starts_touching) != 0) {
    snap_to_touching(place_a, place_b, placed);
  }
  Result<Scene> scene = make_scene(place_a, place_b, placed);
  if (!scene) {
    return scene.error();
  }
  const Real size = scene.value().size;
  NamedMotion a = motion_of(record, 0, size), b = motion_of(record, motion_number_count / 2, size);
  aim_at(record, scene.value(), a, b);
  const auto path_a = Path::along(Pose::identity(), a.centre, a.motion, 1);
  const auto path_b = Path::along(scene.value().ab, b.centre, b.motion, 1);
  if (!path_a || !path_b) {
    return path_a ? path_b.error() : path_a.error();
  }
  return MovingScene{std::move(scene).value(), path_a.value(), path_b.value()};
}

Verdict judge_impact(const MovingScene& moving, const Impact& found) {
  const Real end = moving.path_a.duration(), noise = noise_of(moving);
  if (!(found.lower >= 0 && found.lower <= found.upper && found.upper <= end)) {
    return fault("an interval of time that ends too early or too late", found.lower, found.upper);
  }
  if (found.state == ImpactState::apart && found.lower < end) {
    return fault("shapes that stay apart are so until", found.lower, end);
  }
  if (!is_seen_from_all_sides(moving.scene)) {
    return std::nullopt;
  }
  if (found.state != ImpactState::starts_together) {
    if (Verdict verdict = judge_free(moving, {0, found.lower}, "gap before the time of impact")) {
      return verdict;
    }
  }
  if (found.state == ImpactState::touches || found.state == ImpactState::starts_together) {
    // A lower bound may know less than the shape, and is no touch.
    const Result<Distance> gap = distance_at(moving, found.upper);
    if (gap && !(gap.value().upper <= noise)) {
      return fault("gap at the time of impact", gap.value().upper, noise);
    }
    if (!is_finite(found.contact.point_a) || !is_finite(found.contact.point_b)) {
      return "a touch at no point";
    }
  }
  return std::nullopt;
}

Verdict judge_motion(std::size_t place_a, std::size_t place_b, const MovingRecord& record) {
  const Result<MovingScene> made = make_moving_scene(place_a, place_b, record);
  if (!made) {
    return "the motion is refused: " + made.error().message;
  }
  const MovingScene& moving = made.value();
  const auto found = ask(moving);
  if (!found) {
    const bool has_distance = distance_at(moving, 0).has_value();
    return has_distance ? Verdict("a pair with a distance has no time of impact") : Verdict();
  }
  Verdict verdict = judge_impact(moving, *found);
  verdict = verdict ? verdict : judge_swap(moving, *found);
  verdict = verdict ? verdict : judge_frame(moving, *found);
  return verdict ? verdict : judge_halves(moving, *found);
}

}  // namespace abut::fuzz

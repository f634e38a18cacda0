// SPDX-License-Identifier: Apache-2.0
// Edits of a shape while balls touch it, against a shape and a universe made anew, and against all triangles.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "oracle.hpp"

namespace edit_fuzzing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), tolerance = 1e-9;
constexpr abut_pose identity{{0, 0, 0}, {1, 0, 0, 0}};
constexpr std::size_t ball_count = 5;

struct Destroy {
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
};
using Universe = std::unique_ptr<abut_universe, Destroy>;

// A defect: of a call that may not fail, or an answer that is wrong.
void require(bool holds, const std::string& what) {
  if (!holds) {
    throw std::runtime_error(what);
  }
}
void succeed(abut_status status, const char* call) {
  require(status == ABUT_OK,
          std::string(call) + " answers " + abut_status_name(status) + ": " + abut_last_error_message());
}
void agree(double found, double expected, const char* what) {
  require(found == expected || std::fabs(found - expected) <= tolerance,
          std::string(what) + " is " + std::to_string(found) + " and should be " + std::to_string(expected));
}

// The shape stands still, and balls lie at places of their own.
struct Scene {
  Universe universe;
  abut_geometry_id subject{};

  Scene(const abut_shape* shape, const abut_shape* ball, const std::vector<abut_pose>& places) {
    abut_universe* made = nullptr;
    succeed(abut_universe_create(nullptr, &made), "abut_universe_create");
    universe.reset(made);
    subject = add(shape, identity, ABUT_MOTION_STATIC);
    for (const abut_pose& place : places) {
      add(ball, place, ABUT_MOTION_DYNAMIC);
    }
  }
  abut_geometry_id add(const abut_shape* shape, const abut_pose& pose, abut_motion motion) {
    abut_part_options options;
    abut_part_options_init(&options, sizeof options);
    options.pose = pose;
    options.motion = motion;
    abut_part_id part{};
    abut_geometry_id out{};
    succeed(abut_part_create(universe.get(), &options, &part), "abut_part_create");
    succeed(abut_geometry_create(universe.get(), part, shape, nullptr, &out), "abut_geometry_create");
    return out;
  }
  // Of each ball the deepest contact with the shape, by slot; infinity where there is none.
  std::array<double, ball_count + 2> step() {
    succeed(abut_universe_step(universe.get(), 0.01), "abut_universe_step");
    const abut_contact* contacts = nullptr;
    std::size_t count = 0;
    succeed(abut_universe_contacts(universe.get(), &contacts, &count), "abut_universe_contacts");
    std::array<double, ball_count + 2> deepest{};
    deepest.fill(infinity);
    std::vector<abut_contact> all;
    std::copy_n(contacts, count, std::back_inserter(all));
    for (const abut_contact& contact : all) {
      const auto other = contact.geometry_a.slot == subject.slot ? contact.geometry_b : contact.geometry_a;
      if (contact.geometry_a.slot == subject.slot || contact.geometry_b.slot == subject.slot) {
        deepest.at(other.slot) = std::min(deepest.at(other.slot), contact.distance);
      }
    }
    return deepest;
  }
  Shape shape() const {
    abut_shape* out = nullptr;
    succeed(abut_geometry_shape(universe.get(), subject, &out), "abut_geometry_shape");
    return Shape(out);
  }
};

class Play {
 public:
  Play(const Record& first, Counts& counts) : counts_(counts), subject_(subject_of(first)) {
    abut_shape* ball = nullptr;
    succeed(abut_sphere_create(ball_radius, &ball), "abut_sphere_create");
    ball_.reset(ball);
    for (std::size_t i = 0; i < ball_count; ++i) {
      // Off the grid, so that no ball lies at a corner by chance.
      const double angle = 1.3 * static_cast<double>(i);
      places_.push_back(
          {{1.1 * std::cos(angle) + 0.3, 1.1 * std::sin(angle) + 0.2, first.number(11 + i) / 2 + 0.013}, {1, 0, 0, 0}});
    }
    scene_ = std::make_unique<Scene>(subject_->made_anew().get(), ball_.get(), places_);
    judge(first);
  }

  void edit(const Record& record) {
    const abut_status status = subject_->change(scene_->universe.get(), scene_->subject, record);
    require(status != ABUT_INTERNAL, std::string("an edit finds a defect: ") + abut_last_error_message());
    ++(status == ABUT_OK ? counts_.edits : counts_.refused);
    judge(record);
  }

 private:
  void judge(const Record& record) {
    const Shape anew = subject_->made_anew();
    // Now and then somebody else holds the shape, so that the next edit makes a copy.
    held_ = record.bytes[15] % 4 == 0 ? scene_->shape() : nullptr;
    const abut_geometry_id id = scene_->subject;
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    succeed(abut_geometry_describe(scene_->universe.get(), id, &info), "abut_geometry_describe");
    judge_box(info.shape, anew.get());
    for (std::size_t i = 0; i < 4; ++i) {
      judge_ray(info.shape, anew.get(), record, i);
      judge_distance(info.shape, anew.get(), record, i);
    }
    judge_touches(anew.get());
  }
  static void judge_box(const abut_shape* shape, const abut_shape* anew) {
    abut_aabb one{}, other{};
    succeed(abut_shape_aabb(shape, &identity, &one), "abut_shape_aabb");
    succeed(abut_shape_aabb(anew, &identity, &other), "abut_shape_aabb");
    const auto sides = [](const abut_aabb& box) {
      return std::array{box.minimum.x, box.minimum.y, box.minimum.z, box.maximum.x, box.maximum.y, box.maximum.z};
    };
    require(sides(one) == sides(other), "the box is not that of a shape made anew");
  }
  void judge_ray(const abut_shape* shape, const abut_shape* anew, const Record& record, std::size_t i) {
    const Point origin{2.3 * record.number(1 + i) + 0.01, 2.3 * record.number(2 + i) + 0.02, 3 - 0.5 * double(i)},
        direction{record.number(5 + i) + 0.003, record.number(6 + i) - 0.004, -1.5};
    const abut_ray ray{{origin[0], origin[1], origin[2]}, {direction[0], direction[1], direction[2]}, infinity};
    abut_ray_hit one{}, other{};
    std::uint32_t is_hit = 0, is_hit_anew = 0;
    succeed(abut_shape_cast_ray(shape, &identity, &ray, &one, &is_hit), "abut_shape_cast_ray");
    succeed(abut_shape_cast_ray(anew, &identity, &ray, &other, &is_hit_anew), "abut_shape_cast_ray");
    require(is_hit == is_hit_anew, "a ray meets one of the shape and the shape made anew");
    agree(is_hit != 0 ? one.distance : infinity, is_hit != 0 ? other.distance : infinity,
          "the distance of a ray, beside the shape made anew,");
    const std::vector<Triangle> triangles = subject_->triangles();
    const Crossing crossing = first_crossing(origin, direction, triangles);
    if (!triangles.empty() && crossing.is_sure) {
      const double length = std::hypot(direction[0], direction[1], direction[2]);
      require((is_hit != 0) == crossing.at.has_value(), "a ray meets a triangle that is not there, or misses one");
      agree(is_hit != 0 ? one.distance : 0, length * crossing.at.value_or(0), "the distance of a ray");
      ++counts_.rays;
    }
  }
  void judge_distance(const abut_shape* shape, const abut_shape* anew, const Record& record, std::size_t i) {
    const Point centre{2.6 * record.number(3 + i) + 0.017, 2.6 * record.number(4 + i) + 0.029,
                       1.7 * record.number(8 + i) + 0.011};
    const abut_pose pose{{centre[0], centre[1], centre[2]}, {1, 0, 0, 0}};
    abut_distance one{}, other{};
    succeed(abut_pair_distance(shape, &identity, ball_.get(), &pose, nullptr, &one), "abut_pair_distance");
    succeed(abut_pair_distance(anew, &identity, ball_.get(), &pose, nullptr, &other), "abut_pair_distance");
    agree(one.distance, other.distance, "a distance, beside the shape made anew,");
    const std::vector<Triangle> triangles = subject_->triangles();
    const std::vector<Ball> balls = subject_->balls();
    if (!triangles.empty() || !balls.empty()) {
      const double gap =
          (triangles.empty() ? distance_from(centre, balls) : distance_from(centre, triangles)) - ball_radius;
      const bool is_exact = gap > tolerance || !balls.empty();
      require(is_exact || gap > -tolerance || one.distance <= 0, "a ball that overlaps a triangle is apart");
      agree(is_exact ? one.distance : 0, is_exact ? gap : 0, "a distance");
      ++counts_.distances;
    }
  }
  void judge_touches(const abut_shape* anew) {
    const auto found = scene_->step();
    Scene other(anew, ball_.get(), places_);
    const auto expected = other.step();
    for (std::size_t slot = 0; slot < found.size(); ++slot) {
      counts_.touches += found.at(slot) < infinity ? 1 : 0;
      if (subject_->stops_from_the_front_only() && std::fabs(found.at(slot) - expected.at(slot)) < ball_radius) {
        counts_.excused += std::fabs(found.at(slot) - expected.at(slot)) > tolerance ? 1 : 0;
      } else {
        agree(found.at(slot), expected.at(slot), "the deepest contact of a ball");
      }
    }
  }

  static constexpr double ball_radius = 0.35;
  Counts& counts_;
  std::unique_ptr<Subject> subject_;
  Shape ball_, held_;
  std::vector<abut_pose> places_;
  std::unique_ptr<Scene> scene_;
};

}  // namespace

std::vector<Record> read_records(std::span<const std::uint8_t> bytes) {
  std::vector<Record> out;
  for (std::size_t first = 0; first < bytes.size() && out.size() <= most_edits; first += record_size) {
    Record& record = out.emplace_back();
    std::ranges::copy(bytes.subspan(first, std::min(record_size, bytes.size() - first)), record.bytes.begin());
  }
  return out;
}

std::string finding_of(std::span<const std::uint8_t> bytes, Counts& counts) {
  const std::vector<Record> records = read_records(bytes);
  if (records.empty()) {
    return "";
  }
  std::size_t edits = 0;
  try {
    Play play(records.front(), counts);
    for (const Record& record : std::span(records).subspan(1)) {
      ++edits;
      play.edit(record);
    }
  } catch (const std::runtime_error& finding) {
    return "after " + std::to_string(edits) + " edits: " + finding.what();
  }
  return "";
}

}  // namespace edit_fuzzing

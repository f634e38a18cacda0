// SPDX-License-Identifier: Apache-2.0
#include "script.hpp"

#include <algorithm>

#include "pose_reader.hpp"

namespace cli {
namespace {

std::vector<Keyframe> read_keyframes(const Node& node) {
  std::vector<Keyframe> keyframes;
  for (const Node& element : node.list("keyframes")) {
    Fields fields(element);
    const Node time = fields.need("time");
    keyframes.push_back({time.not_negative(), read_pose_fields(fields)});
    fields.done();
    if (keyframes.size() > 1 && keyframes.back().time <= keyframes[keyframes.size() - 2].time) {
      time.refuse("a time after that of the keyframe before");
    }
  }
  if (keyframes.empty()) {
    node.refuse("at least one keyframe");
  }
  return keyframes;
}

// Positions on the straight line; orientations on the arc between both, by the shorter way. The weight is that of b.
abut_pose between(const abut_pose& a, const abut_pose& b, double weight) {
  const abut_quat& p = a.orientation;
  const abut_quat& q = b.orientation;
  const double side = p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z < 0.0 ? -weight : weight;
  const double rest = 1.0 - weight;
  return {a.position * rest + b.position * weight,
          unit({p.w * rest + q.w * side, p.x * rest + q.x * side, p.y * rest + q.y * side, p.z * rest + q.z * side})};
}

abut_pose keyframe_at(const Script& script, double time) {
  const std::vector<Keyframe>& keys = script.keyframes;
  const double period = keys.back().time;
  const double within = script.repeat && period > 0.0 ? std::fmod(time, period) : time;
  const auto later = std::find_if(keys.begin(), keys.end(), [&](const Keyframe& key) { return key.time > within; });
  if (later == keys.begin()) {
    return keys.front().pose;
  }
  const Keyframe& before = *(later - 1);
  if (later == keys.end()) {
    return before.pose;
  }
  return between(before.pose, later->pose, (within - before.time) / (later->time - before.time));
}

}  // namespace

Script read_script(const Node& node) {
  Fields fields(node);
  Script script;
  const auto keyframes = fields.find("keyframes");
  const auto velocity = fields.find("velocity");
  const auto spin = fields.find("spin");
  const auto repeat = fields.find("repeat");
  fields.done();
  if (keyframes.has_value() == (velocity || spin) || (repeat && !keyframes)) {
    node.refuse("either keyframes, perhaps with repeat, or velocity and spin");
  }
  if (keyframes) {
    script.keyframes = read_keyframes(*keyframes);
    script.repeat = repeat && repeat->flag();
  }
  if (velocity) {
    script.velocity = velocity->vector();
  }
  if (spin) {
    Fields turning(*spin);
    script.spin_axis = turning.need("axis").direction();
    script.degrees_per_second = turning.need("degrees_per_second").number();
    turning.done();
  }
  return script;
}

abut_pose pose_at(const Script& script, const abut_pose& start, double time) {
  if (!script.keyframes.empty()) {
    return compose(start, keyframe_at(script, time));
  }
  const abut_quat spun = turn_by(script.spin_axis, script.degrees_per_second * time);
  return {start.position + script.velocity * time, unit(multiply(spun, start.orientation))};
}

}  // namespace cli

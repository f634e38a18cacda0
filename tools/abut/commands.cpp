// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"

#include <chrono>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "common/progress.hpp"
#include "document.hpp"
#include "interruption.hpp"
#include "output_file.hpp"
#include "parameters.hpp"
#include "summary.hpp"
#include "writers.hpp"

namespace cli {
namespace {

// The scene with what the arguments put in place of it.
Scene scene_for(const Arguments& arguments) {
  Scene scene = read_scene(arguments.operands[0]);
  scene.steps = arguments.steps.value_or(arguments.command == Command::run ? scene.steps : 1);
  scene.dt = arguments.dt.value_or(scene.dt);
  scene.universe.threads = arguments.threads.value_or(scene.universe.threads);
  return scene;
}

World world_for(const Arguments& arguments) {
  Scene scene = scene_for(arguments);
  try {
    return World(std::move(scene));
  } catch (const BadInput& failure) {
    throw BadInput(shown_name(arguments.operands[0]) + ": " + failure.what());
  }
}

template <class Writer>
std::optional<Writer> writer_for(const std::string& path, bool json) {
  if (path.empty()) {
    return std::nullopt;
  }
  return Writer(path, path == "-" && json ? Format::json : format_of(path));
}

}  // namespace

void run(const Arguments& arguments) {
  World world = world_for(arguments);
  const Interruption interruption;
  auto contacts = writer_for<ContactWriter>(arguments.contacts, arguments.json);
  auto elements = writer_for<ElementWriter>(arguments.elements, arguments.json);
  auto events = writer_for<EventWriter>(arguments.events, arguments.json);
  for (const auto& [option, path] :
       {std::pair{"--states", arguments.states}, std::pair{"--motion", arguments.motion}}) {
    if (!path.empty() && world.dynamics() == nullptr) {
      throw BadInput(std::string(option) + " is '" + path + "'; the scene has no response, so it has no bodies");
    }
  }
  auto states = writer_for<StateWriter>(arguments.states, arguments.json);
  auto motion = writer_for<MotionWriter>(arguments.motion, arguments.json);
  Summary summary;
  std::optional<Progress> progress;
  if (!arguments.quiet) {
    progress.emplace("steps", world.scene().steps, Elsewhere::nothing);
  }
  for (std::uint64_t step = 1; step <= world.scene().steps; ++step) {
    const auto start = std::chrono::steady_clock::now();
    world.step(step);
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    summary.add(world, elapsed.count());
    if (contacts) {
      contacts->add(world, step);
    }
    if (elements) {
      elements->add(world, step);
    }
    if (events) {
      events->add(world, step);
    }
    if (states) {
      states->add(world, step);
    }
    if (motion) {
      motion->add(world, step);
    }
    if (progress) {
      progress->show(step);
    }
    if (progress && interruption.has_come()) {
      progress->stop();
    }
    interruption.check(step, world.scene().steps);
  }
  if (progress) {
    progress->finish();
  }
  if (contacts) {
    contacts->finish();
  }
  if (elements) {
    elements->finish();
  }
  if (events) {
    events->finish();
  }
  if (states) {
    states->finish();
  }
  if (motion) {
    motion->finish();
  }
  if (arguments.quiet) {
    return;
  }
  const std::string table = arguments.json ? summary.json(world) : summary.table(world);
  if (arguments.contacts == "-" || arguments.elements == "-" || arguments.events == "-" || arguments.states == "-" ||
      arguments.motion == "-") {
    std::fputs(table.c_str(), stderr);
  } else {
    print(table);
  }
}

World world_at_last_step(const Arguments& arguments) {
  World world = world_for(arguments);
  const Interruption interruption;
  for (std::uint64_t step = 1; step <= world.scene().steps; ++step) {
    if (arguments.command == Command::explain && step == world.scene().steps) {
      // The universe measures pairs of kinds from the first question on.
      static_cast<void>(plan_of(world.universe()));
    }
    world.step(step);
    interruption.check(step, world.scene().steps);
  }
  return world;
}

void list_shapes(const Arguments& arguments) {
  std::string text;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < abut_shape_kind_count(); ++i) {
    const abut_shape_kind kind = abut_shape_kind_at(i);
    const std::string name = abut_shape_kind_name(kind);
    std::string line = name + std::string(name.size() < 15 ? 15 - name.size() : 1, ' ');
    nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
    for (std::size_t j = 0; j < abut_shape_kind_parameter_count(kind); ++j) {
      const std::string parameter = abut_shape_kind_parameter_name(kind, j);
      const bool optional = is_optional(name, parameter);
      line += " " + (optional ? "[" + parameter + "]" : parameter);
      parameters.push_back({{"name", parameter}, {"optional", optional}});
    }
    for (const std::string& array : arrays_of(name)) {
      line += " " + array;
    }
    json[name] = {{"parameters", parameters}, {"arrays", arrays_of(name)}};
    text += line + "\n";
  }
  print(arguments.json ? json.dump(2) + "\n" : text);
}

}  // namespace cli

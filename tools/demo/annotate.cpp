// SPDX-License-Identifier: Apache-2.0
#include "annotate.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "picture/marks.hpp"
#include "picture/text.hpp"
#include "shade.hpp"

namespace demo {
namespace {

constexpr Colour cloth_mark_colour{0.55, 1.0, 0.95};

enum class Sight : std::uint8_t { seen, behind_own_body, hidden };

Sight sight_of(const abut_contact& contact, const Pixel& pixel, const abut_pick& pick, const Scene& scene) {
  // A contact lies between two surfaces that overlap, hence a little below what is seen.
  const double below = 2.0 + std::max(0.0, -contact.distance) + 0.001 * pixel.distance;
  if (pick.geometry.slot == 0 || pick.distance > pixel.distance - below) {
    return Sight::seen;
  }
  const Owner in_front = scene.owner(pick.geometry);
  const bool own = in_front.body != 0 && (in_front.body == scene.owner(contact.geometry_a).body ||
                                          in_front.body == scene.owner(contact.geometry_b).body);
  return own ? Sight::behind_own_body : Sight::hidden;
}

}  // namespace

std::size_t mark_contacts(Picture& picture, const abut_camera& camera, std::span<const abut_contact> contacts,
                          const Scene& scene) {
  struct Mark {
    Pixel pixel;
    Sight sight;
  };
  std::vector<Mark> marks;
  for (const abut_contact& contact : contacts) {
    const std::optional<Pixel> pixel = project(camera, (contact.point_a + contact.point_b) * 0.5);
    if (!pixel) {
      continue;
    }
    const auto index = static_cast<std::size_t>(pixel->y) * camera.width + static_cast<std::size_t>(pixel->x);
    const Sight sight = sight_of(contact, *pixel, picture.picks[index], scene);
    if (sight != Sight::hidden) {
      marks.push_back({*pixel, sight});
    }
  }
  std::ranges::sort(marks, std::ranges::greater{}, [](const Mark& mark) { return mark.pixel.distance; });
  const double scale = camera.height / 720.0;
  for (const Mark& mark : marks) {
    const double radius = scale * std::clamp(3.4 * 1200.0 / mark.pixel.distance, 1.1, 3.8);
    if (mark.sight == Sight::seen) {
      draw_mark(picture.image, mark.pixel, radius, scale);
    } else {
      draw_faint_mark(picture.image, mark.pixel, radius);
    }
  }
  return static_cast<std::size_t>(std::ranges::count(marks, Sight::seen, &Mark::sight));
}

std::size_t mark_cloth(Picture& picture, const abut_camera& camera, const Scene& scene) {
  const Cloth& cloth = scene.cloth();
  const double scale = camera.height / 720.0;
  std::size_t seen = 0;
  for (const abut_element_contact& contact : cloth.contacts()) {
    const std::optional<Pixel> pixel = project(camera, cloth.middle_of(contact));
    if (!pixel) {
      continue;
    }
    const auto index = static_cast<std::size_t>(pixel->y) * camera.width + static_cast<std::size_t>(pixel->x);
    constexpr double below = 4.0;  // the middle lies under the cloth
    const abut_pick& pick = picture.picks[index];
    if (pick.geometry.slot == 0 || pick.distance > pixel->distance - below) {
      picture.image.draw_disc(pixel->x, pixel->y, 0.7 * scale, cloth_mark_colour, 0.8);
      ++seen;
    }
  }
  return seen;
}

void draw_legend(Image& image, const Scene& scene, std::size_t contacts) {
  struct Entry {
    Kind kind;
    std::string_view label;
  };
  constexpr std::array<Entry, 8> entries{{{Kind::sphere, "sphere"},
                                          {Kind::box, "box"},
                                          {Kind::capsule, "capsule"},
                                          {Kind::hull, "convex hull"},
                                          {Kind::compound, "several shapes"},
                                          {Kind::bunny_mesh, "bunny, mesh"},
                                          {Kind::bunny_hull, "bunny, hull"},
                                          {Kind::cloth, "cloth"}}};
  const double s = image.width() / 1280.0;
  const double letter = 8.0 * s;
  const double gap = 17.0 * s;
  const double strip = 30.0 * s;
  const double y = image.height() - 0.5 * (strip + letter);
  const double middle = image.height() - 0.5 * strip;
  const Colour ink{0.88, 0.88, 0.88};
  image.draw_panel(0.0, image.height() - strip, image.width(), image.height() + 1.0, 0.0, {0.008, 0.012, 0.016}, 0.8);
  const std::string title = std::to_string(scene.body_count()) + " bodies";
  double x = gap;
  draw_text(image, x, y, letter, title, ink);
  x += text_width(title, letter) + 1.5 * gap;
  for (const Entry& entry : entries) {
    image.draw_disc(x + 0.5 * letter, middle, 0.65 * letter, tone_mapped(colour_of(entry.kind) * 1.1), 1.0);
    x += 1.9 * letter;
    draw_text(image, x, y, letter, entry.label, ink);
    x += text_width(entry.label, letter) + gap;
  }
  const auto add_count = [&](const Colour& colour, double size, std::size_t count, const char* what) {
    const std::string text = std::to_string(count) + what;
    image.draw_disc(x + 0.5 * letter, middle, size * letter, colour, 1.0);
    draw_text(image, x + 1.9 * letter, y, letter, text, ink);
    x += 1.9 * letter + text_width(text, letter) + gap;
  };
  add_count(mark_colour, 0.5, contacts, " contacts");
  add_count(cloth_mark_colour, 0.3, scene.cloth().contacts().size(), " of the cloth");
}

}  // namespace demo

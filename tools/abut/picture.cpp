// SPDX-License-Identifier: Apache-2.0
#include "picture.hpp"

#include <algorithm>

#include "commands.hpp"
#include "digits.hpp"
#include "element_points.hpp"
#include "output_file.hpp"
#include "picking_library.hpp"
#include "picture/marks.hpp"
#include "picture/render.hpp"
#include "picture/text.hpp"
#include "studio.hpp"

namespace cli {
namespace {

enum class Sight : std::uint8_t { seen, behind_own, hidden };

// A contact, or an element contact.
struct Mark {
  Vec3 middle;
  double depth;  // of two surfaces that overlap
  std::uint32_t slot_a, slot_b;
};

std::vector<Mark> marks_of(const std::vector<abut_contact>& contacts, const std::vector<ElementPoint>& elements) {
  std::vector<Mark> marks;
  for (const abut_contact& contact : contacts) {
    marks.push_back({(contact.point_a + contact.point_b) * 0.5, std::max(0.0, -contact.distance),
                     contact.geometry_a.slot, contact.geometry_b.slot});
  }
  for (const ElementPoint& element : elements) {
    marks.push_back({element.middle, 0.0, element.geometry_a.slot, element.geometry_b.slot});
  }
  return marks;
}

Sight sight_of(const Mark& mark, const Pixel& pixel, const abut_pick& in_front, double radius) {
  // A contact lies between two surfaces that overlap, hence a little below what is seen.
  const double below = mark.depth + 0.004 * radius;
  if (in_front.geometry.slot == 0 || in_front.distance > pixel.distance - below) {
    return Sight::seen;
  }
  const bool own = in_front.geometry.slot == mark.slot_a || in_front.geometry.slot == mark.slot_b;
  return own ? Sight::behind_own : Sight::hidden;
}

void draw_marks(Picture& picture, const abut_camera& camera, const std::vector<Mark>& marks, double radius) {
  const double scale = camera.height / 720.0;
  const double dot_radius = std::max(1.2, 3.6 * scale);
  for (const Mark& mark : marks) {
    const auto pixel = project(camera, mark.middle);
    if (!pixel) {
      continue;
    }
    const auto index = static_cast<std::size_t>(pixel->y) * camera.width + static_cast<std::size_t>(pixel->x);
    switch (sight_of(mark, *pixel, picture.picks[index], radius)) {
      case Sight::seen: draw_mark(picture.image, *pixel, dot_radius, scale); break;
      case Sight::behind_own: draw_faint_mark(picture.image, *pixel, dot_radius); break;
      case Sight::hidden: break;
    }
  }
}

std::vector<abut_shape_kind> kinds_of(const Scene& scene) {
  std::vector<abut_shape_kind> kinds;
  for (const Geometry& geometry : scene.geometries) {
    kinds.push_back(abut_shape_kind_of(geometry.shape));
  }
  std::ranges::sort(kinds);
  kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
  return kinds;
}

// Names the colours and counts the contacts, as far as they fit.
void draw_legend(Image& image, const Scene& scene, std::size_t contacts, std::size_t elements) {
  const double s = image.width() / 1280.0;
  const double letter = 8.0 * s, gap = 17.0 * s, strip = 30.0 * s;
  const double y = image.height() - 0.5 * (strip + letter);
  const double middle = image.height() - 0.5 * strip;
  const Colour ink{0.88, 0.88, 0.88};
  image.draw_panel(0.0, image.height() - strip, image.width(), image.height() + 1.0, 0.0, {0.008, 0.012, 0.016}, 0.8);
  double x = gap;
  const auto add = [&](const Colour& colour, std::string label) {
    std::ranges::replace(label, '_', ' ');
    image.draw_disc(x + 0.5 * letter, middle, 0.6 * letter, colour, 1.0);
    draw_text(image, x + 1.9 * letter, y, letter, label, ink);
    x += 1.9 * letter + text_width(label, letter) + gap;
  };
  add(mark_colour, counted(contacts, "contact"));
  if (elements > 0) {
    add(mark_colour, counted(elements, "element contact"));
  }
  for (const abut_shape_kind kind : kinds_of(scene)) {
    add(tone_mapped(colour_of(kind) * 1.3), abut_shape_kind_name(kind));
  }
}

}  // namespace

void draw_scene(const Arguments& arguments) {
  const std::string& path = arguments.operands[1];
  if (path != "-" && !path.ends_with(".png")) {
    throw BadInput("the picture is '" + path + "'; expected a name that ends in .png, or - for the standard output");
  }
  const PickingFunctions picking = load_picking();
  World world = world_at_last_step(arguments);
  const View view = view_of(world, arguments);
  const Picker picker(picking, world.universe());
  const abut_camera camera =
      picker.camera(arguments.width, arguments.height, vertical_fov, view.eye, view.target, view.up);
  Picture picture = render(picker, Studio(world, view), camera, Elsewhere::nothing);
  const std::vector<abut_contact> contacts = contacts_of(world.universe());
  const std::vector<ElementPoint> elements = element_points_of(world);
  draw_marks(picture, camera, marks_of(contacts, elements), view.radius);
  draw_legend(picture.image, world.scene(), contacts.size(), elements.size());
  OutputFile out(path);
  out.write(encode_png(picture.image));
  out.finish();
}

}  // namespace cli

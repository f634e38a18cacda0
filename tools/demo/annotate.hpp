// SPDX-License-Identifier: Apache-2.0
// What is drawn over the picture: marks of contacts and the legend.
#pragma once

#include <cstdint>
#include <span>

#include "picture/render.hpp"
#include "scene.hpp"

namespace demo {

/// A solid dot for each contact that the camera sees, a faint one where only a touching body is in the way. There is
/// none where anything else hides the contact. Returns how many dots are solid.
std::size_t mark_contacts(Picture& picture, const abut_camera& camera, std::span<const abut_contact> contacts,
                          const Scene& scene);

/// A small dot for each element contact of the cloth that the camera sees. Returns how many there are.
std::size_t mark_cloth(Picture& picture, const abut_camera& camera, const Scene& scene);

/// Names the colours and says what the picture shows.
void draw_legend(Image& image, const Scene& scene, std::size_t contacts);

}  // namespace demo

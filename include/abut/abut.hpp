// SPDX-License-Identifier: Apache-2.0
// abut for C++17 and newer, in headers alone, on top of abut.h, where every function is described. docs/cpp.md tells
// more.
//
//   abut::Universe universe;
//   const abut::PartId ball = universe.create_part(abut::PartOptions().with_pose(abut::pose({0, 0, 2})));
//   universe.create_geometry(ball, abut::Shape::sphere(0.5));
//   universe.step(0.01);
//
// Objects own what they hold, ids are plain values, arrays are spans. A call that fails throws abut::Error with the
// status and the message; with ABUT_NO_EXCEPTIONS, or without exceptions in the compiler, it answers an abut::Result.
//
// The modules of abut export a namespace of the same name: a program uses either these headers or the modules.
#ifndef ABUT_ABUT_HPP
#define ABUT_ABUT_HPP

#include <abut/cpp/deforming.hpp>
#include <abut/cpp/elements.hpp>
#include <abut/cpp/impact.hpp>
#include <abut/cpp/library.hpp>
#include <abut/cpp/pair.hpp>
#include <abut/cpp/shape.hpp>
#include <abut/cpp/universe.hpp>

#endif

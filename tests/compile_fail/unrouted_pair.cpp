// SPDX-License-Identifier: Apache-2.0
// Two shapes that have nothing in common and that nobody has declared unsupported.
// expect: (?s)no capability in common.*route<Ghost, Phantom>
import abut;

struct Ghost {};
struct Phantom {};

constexpr abut::Route way = abut::route<Ghost, Phantom>();

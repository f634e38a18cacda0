// SPDX-License-Identifier: Apache-2.0
// What the demo shares with other tools, and owners of the objects of the picking interface.
#pragma once

#include <memory>

#include "abut/picking.h"
#include "common/owners.hpp"
#include "common/vector.hpp"

namespace demo {

using namespace tools;
// Operators on colours would hide those on vectors otherwise.
using tools::operator+;
using tools::operator-;
using tools::operator*;

struct DestroyPicker {
  void operator()(abut_picker* picker) const { abut_picker_destroy(picker); }
};

using PickerOwner = std::unique_ptr<abut_picker, DestroyPicker>;

}  // namespace demo

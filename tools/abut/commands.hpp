// What the program can be asked to do.
#pragma once

#include "arguments.hpp"

namespace cli {

void run(const Arguments& arguments);
void explain(const Arguments& arguments);
void list_shapes(const Arguments& arguments);

}  // namespace cli

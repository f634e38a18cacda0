// SPDX-License-Identifier: Apache-2.0
// A library of abut that is loaded when something first needs it, so that all else runs without what it stands on.
#pragma once

#include <bit>
#include <string>

#include <dlfcn.h>

#include "abut/abut.h"
#include "failures.hpp"

namespace cli {

class LoadedLibrary {
 public:
  /// `what` needs the library `name`, for people: "pictures", "picking". Throws BadInput where it is not installed.
  LoadedLibrary(const char* file, const std::string& what, std::string name) : name_(std::move(name)) {
    // It stays for good: threads of what it stands on may outlive its last use.
    library_ = dlopen(file, RTLD_NOW | RTLD_NODELETE);
    if (library_ == nullptr) {
      throw BadInput(what + " need the " + name_ + " library of abut, which cannot be loaded: " + dlerror());
    }
  }

  template <class Function>
  void find(const char* name, Function*& out) const {
    void* const symbol = dlsym(library_, name);
    if (symbol == nullptr) {
      throw BadInput("the " + name_ + " library has no " + name + "; expected that of abut " + abut_version_string());
    }
    out = std::bit_cast<Function*>(symbol);
  }

 private:
  std::string name_;
  void* library_ = nullptr;
};

}  // namespace cli

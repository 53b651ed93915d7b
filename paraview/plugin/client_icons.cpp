#include "client_icons.h"

#include <filesystem>

#include <dlfcn.h>

namespace {

/// Whether this process has already loaded a library.
bool has_library(const char* name) {
  void* library = dlopen(name, RTLD_LAZY | RTLD_NOLOAD);
  if (library == nullptr) return false;
  dlclose(library);
  return true;
}

std::filesystem::path own_path() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&load_client_icons), &info) == 0) return {};
  return info.dli_fname;
}

}  // namespace

void load_client_icons() {
  if (!has_library("libQt5Core.so.5")) return;
  // The filters work without icons. They stay loaded for the menus.
  dlopen(own_path().replace_filename("BrindleIcons.so").c_str(), RTLD_LAZY | RTLD_LOCAL);
}

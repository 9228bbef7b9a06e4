// Which libraries the process has loaded, by the name that they give themselves.
#pragma once

#include <link.h>

#include <string_view>

namespace truequad {

// DT_SONAME of a library, or the name of its file if it has none.
std::string_view name_of(const link_map* library);

// True if a library of this name is loaded. dlopen() with RTLD_NOLOAD knows that too, but searches the disk to say no.
bool is_loaded(std::string_view name);

}  // namespace truequad

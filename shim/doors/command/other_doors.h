// What the environment has to say for a program that is reached otherwise than by preloading.
#pragma once

#include <filesystem>
#include <string>

namespace truequad {

// Makes truequad the vendor library of libGLX and libEGL, in front of the driver's. `directory` holds libtruequad.so. Returns
// why that cannot be, or nothing.
std::string become_vendor(const std::filesystem::path& directory);

// Puts truequad's libGL and libOSMesa before the driver's. As above.
std::string stand_for_libraries(const std::filesystem::path& directory);

// True if the dynamic linker will run `program` in its secure mode (ld.so(8)), where it takes no orders.
bool is_privileged(const std::string& program);

}  // namespace truequad

// libglvnd's rules: __GLX_VENDOR_LIBRARY_NAME names libGLX_NAME.so.0; without it the X server does, which this command
// does not ask, so there must be one only. EGL's vendors are listed in JSON files (libglvnd, src/EGL/icd_enumeration.md).
#include "doors/command/other_doors.h"

#include <dlfcn.h>
#include <link.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <vector>

namespace truequad {
namespace {

namespace fs = std::filesystem;

constexpr char kOwnGlx[] = "truequad", kFrontEnds[] = "truequad-libraries";

std::string variable(const char* name) {
  const char* text = std::getenv(name);
  return text ? text : "";
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    if (end > begin) parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

void put_first(const char* name, const fs::path& directory) {
  const std::string old = variable(name);
  ::setenv(name, (directory.string() + (old.empty() ? "" : ":" + old)).c_str(), 1);
}

// The file that the dynamic linker takes for a library's name here, or nothing.
std::string file_of(const char* library) {
  void* const handle = ::dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  const link_map* map = nullptr;
  if (!handle || ::dlinfo(handle, RTLD_DI_LINKMAP, &map) != 0) return "";
  return map->l_name;
}

std::string list(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::set<std::string> glx_vendors() {
  if (const std::string name = variable("__GLX_VENDOR_LIBRARY_NAME"); !name.empty()) return {name};
  std::vector<std::string> places = split(variable("LD_LIBRARY_PATH"));
  if (const std::string neutral = file_of("libGLX.so.0"); !neutral.empty()) places.push_back(fs::path(neutral).parent_path());
  static const std::regex kName("libGLX_(.+)\\.so\\.0");
  std::set<std::string> names;
  std::error_code error;
  for (const std::string& place : places) {
    for (const fs::directory_entry& entry : fs::directory_iterator(place, error)) {
      std::smatch match;
      const std::string file = entry.path().filename();
      // "indirect" is a second name of the library that draws through the X server.
      if (std::regex_match(file, match, kName) && match[1] != "indirect") names.insert(match[1]);
    }
  }
  return names;
}

std::set<std::string> egl_vendors() {
  std::vector<std::string> files = split(variable("__EGL_VENDOR_LIBRARY_FILENAMES"));
  if (files.empty()) {
    std::vector<std::string> places = split(variable("__EGL_VENDOR_LIBRARY_DIRS"));
    if (places.empty()) places = {"/etc/glvnd/egl_vendor.d", "/usr/share/glvnd/egl_vendor.d"};
    std::error_code error;
    for (const std::string& place : places) {
      for (const fs::directory_entry& entry : fs::directory_iterator(place, error)) {
        if (entry.path().extension() == ".json") files.push_back(entry.path());
      }
    }
  }
  static const std::regex kLibrary("\"library_path\"\\s*:\\s*\"([^\"]+)\"");
  std::set<std::string> names;
  for (const std::string& file : files) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    std::smatch match;
    if (std::regex_search(text, match, kLibrary)) names.insert(match[1]);
  }
  return names;
}

// Within a program that truequad stands behind or before already: the driver's names stand in TRUEQUAD_VENDOR, or ours is the
// first libGL.
bool is_vendor() { return variable("__GLX_VENDOR_LIBRARY_NAME") == kOwnGlx && !variable("TRUEQUAD_VENDOR").empty(); }
bool is_front_end(const std::string& library, const fs::path& directory) {
  std::error_code error;
  return fs::equivalent(library, directory / kFrontEnds / "libGL.so.1", error);
}

}  // namespace

std::string become_vendor(const fs::path& directory) {
  // Started by a program that has one of these doors already: one is enough.
  if (is_vendor() || is_front_end(file_of("libGL.so.1"), directory)) return "";
  const std::set<std::string> glx = glx_vendors(), egl = egl_vendors();
  if (glx.empty() && egl.empty()) return "--vendor: there is no vendor library of libglvnd here";
  if (glx.size() > 1) return "--vendor: which of " + list(glx) + " draws? Set __GLX_VENDOR_LIBRARY_NAME";
  if (egl.size() > 1) return "--vendor: which of " + list(egl) + " draws? Set __EGL_VENDOR_LIBRARY_FILENAMES";
  const fs::path own = directory / "truequad-vendor";
  std::error_code error;
  if (!fs::exists(own / "egl.json", error)) return "--vendor: " + own.string() + " is missing";
  const std::string glx_library = glx.empty() ? "" : "libGLX_" + *glx.begin() + ".so.0", egl_library = egl.empty() ? "" : *egl.begin();
  for (const std::string& library : {glx_library, egl_library}) {
    if (!library.empty() && file_of(library.c_str()).empty()) return "--vendor: " + library + " cannot be loaded";
  }
  if (!glx.empty()) {
    ::setenv("__GLX_VENDOR_LIBRARY_NAME", kOwnGlx, 1);
  }
  if (!egl.empty()) {
    ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", (own / "egl.json").c_str(), 1);
  }
  ::setenv("TRUEQUAD_VENDOR", (glx_library + ":" + egl_library).c_str(), 1);
  put_first("LD_LIBRARY_PATH", own);
  return "";
}

std::string stand_for_libraries(const fs::path& directory) {
  if (is_vendor()) return "";
  const fs::path own = directory / kFrontEnds;
  std::error_code error;
  if (!fs::exists(own / "libGL.so.1", error)) return "--library-path: " + (own / "libGL.so.1").string() + " is missing";
  const std::string here = file_of("libGL.so.1");
  if (is_front_end(here, directory)) return "";
  // What stands behind ours was decided when it was linked.
  if (!fs::equivalent(here, TRUEQUAD_BEHIND_GL, error)) {
    return "--library-path: libGL.so.1 is " + (here.empty() ? "missing" : here) + " here, not " TRUEQUAD_BEHIND_GL;
  }
  put_first("LD_LIBRARY_PATH", own);
  return "";
}

bool is_privileged(const std::string& program) {
  std::vector<std::string> places = split(variable("PATH"));
  if (program.find('/') != std::string::npos) places = {""};
  for (const std::string& place : places) {
    const std::string file = place.empty() ? program : place + "/" + program;
    struct stat status;
    if (::access(file.c_str(), X_OK) != 0 || ::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
    // A file system may give no privileges (mount(8), nosuid).
    struct statvfs system;
    if (::statvfs(file.c_str(), &system) == 0 && (system.f_flag & ST_NOSUID)) return false;
    // Nor does a process that is to have no more of them get another user's, though it is secure with capabilities of a file.
    if (::prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) != 1) {
      if ((status.st_mode & S_ISUID) && status.st_uid != ::getuid()) return true;
      if ((status.st_mode & S_ISGID) && status.st_gid != ::getgid()) return true;
    }
    // Capabilities of a file, which give root nothing new.
    return ::getuid() != 0 && ::getxattr(file.c_str(), "security.capability", nullptr, 0) > 0;
  }
  return false;
}

}  // namespace truequad

// Where real functions are found: the libraries that the process has loaded, never one that it has not.
#pragma once

namespace truequad {

enum class Api : unsigned char {
  kNext,  // no window-system interface: whatever follows us in the global scope
  kGlx,
  kEgl,
  kOsmesa,
};

// The function `name` that the program would reach without us: what follows us in the global scope, else what an API's
// library has that was loaded later (a plug-in's libGL: RTLD_NEXT of dlsym(3) does not look there). Null if there is
// none, or if it is our own.
void* next_symbol(Api api, const char* name);

// The OpenGL command `name` of an API: of the library that has the API's MakeCurrent, else what the API's own
// getProcAddress says, else next_symbol. The same name may stand in several libraries of one process (libOSMesa beside
// libGL), so the order matters. Null if there is none.
void* command_symbol(Api api, const char* name);

// A function of the API itself (glX…, egl…, OSMesa…), extensions included. Null if there is none.
void* interface_symbol(Api api, const char* name);

// As a vendor library (vendor.cc) we are behind libGL and libEGL, whose symbols lead to us: from then on everything of
// the API, and what belongs to no known context, is found by the driver's own function alone.
using GetProcAddress = void* (*)(const char* name);
void set_vendor(Api api, GetProcAddress get);
void* vendor_symbol(Api api, const char* name);

// True if an address is in this library.
bool is_ours(const void* address);

// True if the process has a function `name` besides our own, in the global scope or in a library of any API.
bool is_behind_us(const char* name);

// True if `function` is in a library that the calls of our door `name` go to: one of an API, or a hook behind us.
bool leads_to_driver(const char* name, const void* function);

// True while this thread looks for a real function: our getProcAddress doors then show what is behind them.
bool is_looking_up();

}  // namespace truequad

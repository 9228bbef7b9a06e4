// The dynamic linker's functions that have doors of ours, as they are behind these.
#pragma once

namespace truequad {

using Dlsym = void* (*)(void* handle, const char* name);
using Dlopen = void* (*)(const char* file, int mode);

// dlsym(3) and dlopen(3) of whoever comes after us: another hook, or the C library. What RTLD_NEXT and run paths mean
// depends on where they are called from.
Dlsym real_dlsym();
Dlopen real_dlopen();

}  // namespace truequad

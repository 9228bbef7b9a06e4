// A library of a program that keeps what getProcAddress gave in variables of the functions' own names, as many did.
extern "C" {
[[gnu::visibility("default")]] void* glMultiTexCoord2fARB = nullptr;
[[gnu::visibility("default")]] void* glBegin = nullptr;
[[gnu::visibility("default")]] void* glXGetProcAddressARB = nullptr;
[[gnu::visibility("default")]] void* OSMesaGetProcAddress = nullptr;
[[gnu::visibility("default")]] void* eglGetProcAddress = nullptr;
}

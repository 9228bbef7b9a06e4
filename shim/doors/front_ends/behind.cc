// Nothing: only the name of this library counts, when a front end is linked with it.
extern "C" void truequad_behind() {}

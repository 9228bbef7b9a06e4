extern "C" [[gnu::visibility("default")]] int layer() { return 3; }

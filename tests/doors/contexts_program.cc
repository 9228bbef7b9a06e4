#include "contexts.h"

int main(int argc, char** argv) { return contexts_main(argc - 1, argv + 1); }

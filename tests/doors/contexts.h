// What `contexts` and `plug_in` do with their words (contexts.cc).
#pragma once

extern "C" int contexts_main(int count, char** words);

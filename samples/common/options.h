// The command line of every sample.
#pragma once

#include <optional>

#include "common/sample.h"

namespace samples {

// Reads the arguments into `options` and into the sample's own; the exit status if the program has to end at
// once.
std::optional<int> parse(Sample& sample, int argc, char** argv, Options& options);

// One line on stderr, in front of it the program's name.
void complain(const char* program, const std::string& text);

}  // namespace samples

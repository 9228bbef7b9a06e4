// write(2) as a guest may use it.
#pragma once

#include <string_view>

namespace truequad {

// Writes all of `text`; false, with errno, if that fails. Raises no SIGPIPE: that a reader of ours went away must not end the
// program, which has not written anything.
bool write_whole(int file, std::string_view text);

}  // namespace truequad

// The exported OpenGL: one door for every command of the registry, aliases included.
#include <algorithm>
#include <iterator>
#include <string_view>

#include "capture/capture.h"
#include "capture/record.h"
#include "doors/doors.h"

extern "C" {

// The rare way stands apart, so that the usual one is a load, a branch and a jump, without a stack frame.
#define TQ_COMMAND(name, result, parameters, arguments)                               \
  [[gnu::noinline, gnu::cold]] static result GLAPIENTRY tq_settle_##name parameters { \
    truequad::barrier(truequad::entry);                                               \
    return truequad::entry.driver->name arguments;                                    \
  }                                                                                   \
  TRUEQUAD_DOOR result GLAPIENTRY gl##name parameters {                               \
    if (truequad::entry.active) [[unlikely]] return tq_settle_##name arguments;       \
    return truequad::entry.driver->name arguments;                                    \
  }
#include "other_calls.inc"
#undef TQ_COMMAND

// Likewise; recording keeps every argument in its register, as the capture comes last.
#define TQ_COMMAND(name, result, parameters, arguments)                                           \
  [[gnu::noinline]] static void tq_captured_##name TQ_THEN_CAPTURE parameters {                   \
    if (truequad::record_##name TQ_BEHIND_CAPTURE arguments) truequad::entry.driver->name arguments; \
  }                                                                                               \
  TRUEQUAD_DOOR result GLAPIENTRY gl##name parameters {                                           \
    truequad::Capture* const tq_active = truequad::entry.active;                                  \
    if (tq_active) return tq_captured_##name TQ_THEN_ACTIVE arguments;                            \
    return truequad::entry.driver->name arguments;                                                \
  }
#define TQ_THEN_CAPTURE(...) (__VA_ARGS__ __VA_OPT__(, ) truequad::Capture* tq_active)
#define TQ_BEHIND_CAPTURE(...) (*tq_active __VA_OPT__(, ) __VA_ARGS__)
#define TQ_THEN_ACTIVE(...) (__VA_ARGS__ __VA_OPT__(, ) tq_active)
#include "attribute_commands.inc"
#undef TQ_THEN_CAPTURE
#undef TQ_BEHIND_CAPTURE
#undef TQ_THEN_ACTIVE
#undef TQ_COMMAND

TRUEQUAD_DOOR void GLAPIENTRY glBegin(GLenum mode) { truequad::begin(truequad::entry, mode); }

TRUEQUAD_DOOR void GLAPIENTRY glEnd() { truequad::end(truequad::entry); }

TRUEQUAD_DOOR void GLAPIENTRY glNewList(GLuint list, GLenum mode) {
  truequad::Entry& entry = truequad::entry;
  if (entry.active) [[unlikely]] truequad::barrier(entry);
  entry.driver->NewList(list, mode);
  truequad::list_opened(entry);
}

TRUEQUAD_DOOR void GLAPIENTRY glEndList() {
  truequad::Entry& entry = truequad::entry;
  if (entry.active) [[unlikely]] truequad::barrier(entry);
  entry.driver->EndList();
  truequad::list_closed(entry);
}

}  // extern "C"

namespace truequad {
namespace {

// Plain pointers: the table is finished when the library is loaded, before any code of ours could run.
struct Door {
  const char* name;
  void* function;
};

// Sorted by name, as the generator writes them.
const Door kDoors[] = {
#define TQ_COMMAND(name, result, parameters, arguments) {"gl" #name, reinterpret_cast<void*>(&gl##name)},
#include "gl_commands.inc"
#undef TQ_COMMAND
};

}  // namespace

void* command_door(std::string_view name) {
  const Door* found = std::lower_bound(std::begin(kDoors), std::end(kDoors), name,
                                       [](const Door& door, std::string_view key) { return door.name < key; });
  return found != std::end(kDoors) && found->name == name ? found->function : nullptr;
}

}  // namespace truequad

// The exported OpenGL: one door for every command of the registry, aliases included.
#include <algorithm>
#include <iterator>

#include "capture/capture.h"
#include "capture/record.h"
#include "doors/doors.h"

extern "C" {

#define TQ_COMMAND(name, result, parameters, arguments)                   \
  TRUEQUAD_DOOR result GLAPIENTRY gl##name parameters {                   \
    truequad::Entry& tq_entry = truequad::entry;                          \
    if (tq_entry.active) [[unlikely]] truequad::barrier(tq_entry);        \
    return tq_entry.driver->name arguments;                               \
  }
#include "other_calls.inc"
#undef TQ_COMMAND

#define TQ_COMMAND(name, result, parameters, arguments)                                     \
  TRUEQUAD_DOOR result GLAPIENTRY gl##name parameters {                                     \
    truequad::Entry& tq_entry = truequad::entry;                                            \
    truequad::Capture* const tq_active = tq_entry.active;                                   \
    if (tq_active && !truequad::record_##name TQ_WITH_CAPTURE arguments) return;            \
    return tq_entry.driver->name arguments;                                                 \
  }
#define TQ_WITH_CAPTURE(...) (*tq_active __VA_OPT__(, ) __VA_ARGS__)
#include "attribute_commands.inc"
#undef TQ_WITH_CAPTURE
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

struct Door {
  std::string_view name;
  void* function;
};

// Sorted by name, as the registry is read.
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

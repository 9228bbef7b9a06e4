// The exported commands that concern vertex arrays and buffer objects.
#include "capture/arrays.h"
#include "capture/deletions.h"
#include "capture/rect.h"
#include "doors/doors.h"

namespace truequad {
namespace {

template <typename First, typename... Rest>
GLuint first_of(First first, Rest...) {
  return GLuint(first);
}

}  // namespace

extern "C" {

#define TQ_ARRAY_STATE(name, result, parameters, arguments)    \
  TRUEQUAD_DOOR result GLAPIENTRY gl##name parameters {        \
    entry.arrays_known = entry.index_buffer_known = false;     \
    return entry.dispatch->name arguments;                     \
  }
#define TQ_READER_STATE(name, result, parameters, arguments)   \
  TRUEQUAD_DOOR result GLAPIENTRY gl##name parameters {        \
    entry.readers_known = false;                               \
    return entry.dispatch->name arguments;                     \
  }
#define TQ_INDEX_BUFFER(name, result, parameters, arguments)                   \
  TRUEQUAD_DOOR result GLAPIENTRY gl##name parameters {                        \
    if (target == GL_ELEMENT_ARRAY_BUFFER) entry.index_buffer_known = false;   \
    return entry.dispatch->name arguments;                                     \
  }
#define TQ_CHANGE(of, which, name, result, parameters, arguments)      \
  TRUEQUAD_DOOR result GLAPIENTRY gl##name parameters {                \
    const BufferChange change(entry, BufferChange::Of::of, which);     \
    return entry.dispatch->name arguments;                             \
  }
#define TQ_BUFFER_OF_TARGET(name, ...) TQ_CHANGE(kTarget, first_of TQ_ARGUMENTS(__VA_ARGS__), name, __VA_ARGS__)
#define TQ_BUFFER_OF_NAME(name, ...) TQ_CHANGE(kName, first_of TQ_ARGUMENTS(__VA_ARGS__), name, __VA_ARGS__)
#define TQ_ARGUMENTS(result, parameters, arguments) arguments
#define TQ_BUFFER_PACKED(name, ...) TQ_CHANGE(kPacked, 0, name, __VA_ARGS__)
#define TQ_BUFFER_QUERIED(name, ...) TQ_CHANGE(kQueried, 0, name, __VA_ARGS__)
#define TQ_ANY_BUFFER(name, ...) TQ_CHANGE(kAny, 0, name, __VA_ARGS__)
#include "array_commands.inc"

// Arrays that were in them are so no more.
#define TQ_DELETE(name)                                                    \
  TRUEQUAD_DOOR void GLAPIENTRY gl##name(GLsizei n, const GLuint* names) { \
    const BufferChange change(entry, BufferChange::Of::kAny, 0);           \
    entry.arrays_known = entry.index_buffer_known = false;                 \
    note_deleted_buffers(entry, n, names);                                 \
    entry.dispatch->name(n, names);                                        \
  }
TQ_DELETE(DeleteBuffers)
TQ_DELETE(DeleteBuffersARB)

#define TQ_NEW_OBJECTS(name)                                           \
  TRUEQUAD_DOOR void GLAPIENTRY gl##name(GLsizei n, GLuint* objects) { \
    entry.dispatch->name(n, objects);                                  \
    note_new_objects(entry, n, objects);                               \
  }
TQ_NEW_OBJECTS(GenVertexArrays)
TQ_NEW_OBJECTS(GenVertexArraysAPPLE)
TQ_NEW_OBJECTS(CreateVertexArrays)

#define TQ_PUSH(name)                                         \
  TRUEQUAD_DOOR void GLAPIENTRY gl##name(GLbitfield mask) {   \
    note_pushed_arrays(entry);                                \
    entry.arrays_known = entry.index_buffer_known = false;    \
    entry.dispatch->name(mask);                               \
  }
TQ_PUSH(PushClientAttrib)
TQ_PUSH(PushClientAttribDefaultEXT)
TRUEQUAD_DOOR void GLAPIENTRY glPopClientAttrib() {
  note_popped_arrays(entry);
  entry.arrays_known = entry.index_buffer_known = false;
  entry.dispatch->PopClientAttrib();
}

#define TQ_DRAW(name, parameters, arguments, draw)              \
  TRUEQUAD_DOOR void GLAPIENTRY gl##name parameters {           \
    const auto own = [&] { entry.dispatch->name arguments; };   \
    draw;                                                       \
  }
// Two functions: a door that kept its parameters for what may follow would put them on the stack for every draw of triangles.
#define TQ_DRAW_OF(name, parameters, arguments, draw)                             \
  [[gnu::noinline]] static void draw_##name parameters {                              \
    const auto own = [&] { entry.dispatch->name arguments; };                         \
    draw;                                                                             \
  }                                                                                   \
  TRUEQUAD_DOOR void GLAPIENTRY gl##name parameters {                                 \
    if (!may_have_quads(entry, mode)) [[likely]] return entry.dispatch->name arguments; \
    draw_##name arguments;                                                            \
  }
#include "capture/array_calls.inc"

}  // extern "C"
}  // namespace truequad

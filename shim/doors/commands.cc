// The exported OpenGL: one door for every command of the registry, aliases included.
#include <algorithm>
#include <iterator>
#include <string_view>

#include "capture/array_state.h"
#include "capture/capture.h"
#include "capture/list_compile.h"
#include "capture/list_play.h"
#include "doors/doors.h"

extern "C" {

// Some doors are in array_commands.cc.
#define TQ_COMMAND(name, result, parameters, arguments) TRUEQUAD_DOOR result GLAPIENTRY gl##name parameters;
#include "gl_commands.inc"
#undef TQ_COMMAND

#define TQ_COMMAND(name, result, parameters, arguments) \
  TRUEQUAD_DOOR result GLAPIENTRY gl##name parameters { return truequad::entry.dispatch->name arguments; }
#include "attribute_commands.inc"
#include "other_calls.inc"
#undef TQ_COMMAND

// These have something to be noted by the capture in any case.
TRUEQUAD_DOOR void GLAPIENTRY glBegin(GLenum mode) { truequad::begin(truequad::entry, mode); }
TRUEQUAD_DOOR void GLAPIENTRY glEnd() { truequad::end(truequad::entry); }
TRUEQUAD_DOOR void GLAPIENTRY glNewList(GLuint list, GLenum mode) { truequad::new_list(truequad::entry, list, mode); }
TRUEQUAD_DOOR void GLAPIENTRY glEndList() { truequad::end_list(truequad::entry); }
TRUEQUAD_DOOR void GLAPIENTRY glCallList(GLuint list) { truequad::call_list(truequad::entry, list); }
TRUEQUAD_DOOR void GLAPIENTRY glCallLists(GLsizei count, GLenum type, const void* lists) {
  truequad::call_lists(truequad::entry, count, type, lists);
}
TRUEQUAD_DOOR void GLAPIENTRY glListBase(GLuint base) { truequad::list_base(truequad::entry, base); }
TRUEQUAD_DOOR void GLAPIENTRY glPopAttrib() { truequad::pop_attrib(truequad::entry); }
TRUEQUAD_DOOR void GLAPIENTRY glDeleteLists(GLuint list, GLsizei range) {
  truequad::delete_lists(truequad::entry, list, range);
}
TRUEQUAD_DOOR GLuint GLAPIENTRY glGenLists(GLsizei range) { return truequad::gen_lists(truequad::entry, range); }
TRUEQUAD_DOOR GLboolean GLAPIENTRY glIsList(GLuint list) { return truequad::is_list(truequad::entry, list); }

// glGet: the driver compiles a split list under other names than the program's.
#define TQ_GET(name, type)                                                        \
  TRUEQUAD_DOOR void GLAPIENTRY gl##name(GLenum what, type* data) {               \
    truequad::entry.dispatch->name(what, data);                                   \
    GLint answer;                                                                 \
    if (truequad::list_answer(truequad::entry, what, answer)) *data = type(answer); \
  }
TQ_GET(GetDoublev, GLdouble)
TQ_GET(GetFloatv, GLfloat)
TQ_GET(GetIntegerv, GLint)
TRUEQUAD_DOOR void GLAPIENTRY glGetBooleanv(GLenum what, GLboolean* data) {
  truequad::entry.dispatch->GetBooleanv(what, data);
  GLint answer;
  if (truequad::list_answer(truequad::entry, what, answer)) *data = GL_TRUE;
}
#undef TQ_GET
TRUEQUAD_DOOR void GLAPIENTRY glEnable(GLenum capability) { truequad::enable(truequad::entry, capability); }
TRUEQUAD_DOOR void GLAPIENTRY glDisable(GLenum capability) { truequad::disable(truequad::entry, capability); }
TRUEQUAD_DOOR void GLAPIENTRY glClear(GLbitfield mask) { truequad::clear(truequad::entry, mask); }
TRUEQUAD_DOOR void GLAPIENTRY glDepthFunc(GLenum function) { truequad::depth_func(truequad::entry, function); }
TRUEQUAD_DOOR void GLAPIENTRY glStencilOp(GLenum fail, GLenum depth_fail, GLenum pass) {
  truequad::stencil_op(truequad::entry, fail, depth_fail, pass);
}
TRUEQUAD_DOOR void GLAPIENTRY glStencilOpSeparate(GLenum face, GLenum fail, GLenum depth_fail, GLenum pass) {
  truequad::stencil_op_separate(truequad::entry, face, fail, depth_fail, pass);
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

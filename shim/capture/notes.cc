// Calls after which passes over the same vertices may meet, or meet no more (drawn.h).
#include "capture/capture.h"
#include "capture/drawn.h"
#include "capture/state.h"

namespace truequad {
namespace {

void forget(Capture& c) {
  c.unnoted = false;
  if (c.drawn && !c.drawn->empty()) c.drawn->forget();
}

// Does a clear of these buffers leave nothing that a later pass could meet? Asks the driver only if there are meshes.
bool clears_all(const Entry& e, GLbitfield mask) {
  if (!(mask & GL_DEPTH_BUFFER_BIT) || e.inside || e.list) return false;
  if (!e.own->drawn || !e.own->drawn->any_mesh()) return true;
  const Driver& driver = *e.driver;
  GLint depth_mask = 0;
  driver.GetIntegerv(GL_DEPTH_WRITEMASK, &depth_mask);
  return depth_mask != 0 && !driver.IsEnabled(GL_SCISSOR_TEST) &&
         ((mask & GL_STENCIL_BUFFER_BIT) || !driver.IsEnabled(GL_STENCIL_TEST));
}

}  // namespace

void clear(Entry& e, GLbitfield mask) {
  e.dispatch->Clear(mask);
  if (e.own && clears_all(e, mask)) forget(*e.own);
}

void depth_func(Entry& e, GLenum function) {
  depth_func_called(function);
  e.dispatch->DepthFunc(function);
}

void stencil_op(Entry& e, GLenum fail, GLenum depth_fail, GLenum pass) {
  stencil_op_called();
  e.dispatch->StencilOp(fail, depth_fail, pass);
}

void stencil_op_separate(Entry& e, GLenum face, GLenum fail, GLenum depth_fail, GLenum pass) {
  stencil_op_called();
  e.dispatch->StencilOpSeparate(face, fail, depth_fail, pass);
}

void frame_ended(Entry& e) {
  if (e.own) forget(*e.own);
}

}  // namespace truequad

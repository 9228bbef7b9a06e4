// A thread's capture: what the program has said since glBegin, as far as it may still be needed. The window holds the
// vertices of the quad being built (a strip: with the pair that it shares with the last one); everything older is the
// driver's or has been drawn. So its size does not depend on the length of a primitive.
#pragma once

#include "capture/context.h"
#include "capture/entry.h"
#include "capture/lights.h"
#include "capture/rows.h"
#include "capture/settings.h"
#include "capture/slots.h"
#include "capture/stats.h"
#include "capture/values.h"
#include "capture/view.h"
#include "kernel/affine_fast.h"

namespace truequad {

struct Scratch;
class Drawn;

enum class State : std::uint8_t {
  kOpen,     // the driver is inside the program's Begin: calls are recorded and forwarded
  kHeld,     // it is outside (or inside our own glBegin(GL_TRIANGLES)): calls are recorded only
  kPassive,  // calls are forwarded; quads are counted
};

// What quads that need no correction are looked at for, because of other passes over the same vertices (drawn.h).
enum class Watch : std::uint8_t {
  kNothing,
  kTriangles,  // noted, in case that a later pass needs correction
  kMeshes,     // and looked up, in case that an earlier pass was corrected
};

// The arguments of a call whose numbers are not floats: bytes of the numbers, then of what else the call takes.
struct alignas(16) Raw {
  unsigned char bytes[32];
};

inline constexpr unsigned kWindow = 5;  // four corners, and one place for a polygon's further vertices

struct Capture {
  // Hot: what every attribute and vertex call touches.
  SlotMask live = 0;        // set in this Begin; all ones while passive
  SlotMask forwarded = 0;   // of these: calls go to the driver as well; none while held
  SlotMask raw_kept = 0;    // of these: some value needs its Raw
  std::uint32_t next = 0;   // place in the window of the next vertex
  std::uint32_t turn = 0;   // what `due` changes by from quad to quad: a strip's pairs take turns
  std::uint32_t due = 0;    // place of the vertex that completes a quad
  State state = State::kPassive;
  bool forwarding = true;   // calls go to the driver: state != kHeld
  Watch watch = Watch::kNothing;
  bool textures_alone = true;  // decide about a quad: nothing to watch, and colours do not matter
  bool usual = false;       // open, textures alone decide, and no polygon: see usual_quad()
  bool usual_vertex = false;  // and only the first texture's coordinates are live
  float order = kAround;    // of a quad's vertices in the window's first four places
  Slot pending = 0;         // what a recorder left to do (record.h): set this first, complete the quad, give up …
  std::uint32_t extensions = 0;  // bit i: the driver is known to have kExtensions[i], or it does not matter

  SlotMask present[kWindow];              // slots that were live when the vertex was given
  RowId now_row[kSlots];                  // the call that set the value
  RowId row[kSlots][kWindow];
  Float4 now[kSlots];                     // its value
  Float4 at[kSlots][kWindow];
  Raw now_raw[kSlots];                    // its arguments, where they are not `now` itself
  Raw raw[kSlots][kWindow];

  // Cold: the primitive.
  GLenum mode = 0;
  Entry* entry = nullptr;
  const Driver* driver = nullptr;
  const Options* options = nullptr;
  Settings settings;            // of this primitive, or of what is drawn outside of one
  Settings chosen;              // of the next one
  Reason passive_reason = Reason::kNone;
  std::uint64_t quads = 0;      // completed in this Begin
  bool began = false;           // the driver has seen a glBegin since the program's
  bool mesh_open = false;       // the driver is inside our glBegin(GL_TRIANGLES)
  bool mesh_unlit = false;      // and GL_LIGHTING, which the program has enabled, is off for it
  bool calls_grew = false;      // longer calls were sent than the program's own, see end_batch()
  bool corrected = false;       // something in this Begin was
  LightsRead lights_read = LightsRead::kNothing;
  SlotMask judged = kTextureSlots;  // what a quad's correction depends on
  bool lit = false;             // TRUEQUAD_COLOR=1, and GL_LIGHTING is enabled
  bool view_read = false;
  bool elements_found = false;  // the arrays of glArrayElement are known for this Begin
  bool listing = false;         // a list is being compiled: the driver draws nothing now
  GLuint relist = 0;            // in which list the driver's primitives are compiled before they are drawn; 0: in none
  std::uint64_t counted_before = 0;  // quads of this thread before this Begin, if it is of a list
  FrameView view;
  // Called before anything is drawn in the place of a quad, if not null: a draw from arrays (array_draw.cc).
  void (*before_draw)(Capture&) = nullptr;
  void* drawing = nullptr;
  // The thread.
  bool start_held = false;  // the last primitive was corrected: the next one probably will be
  Scratch* scratch = nullptr;
  Drawn* drawn = nullptr;
  bool unnoted = false;     // quads were drawn since the last clear that `drawn` does not know
  Counters counters;
};

// Corners A B C D of a quad: places in the window.
struct Quad {
  unsigned corner[4];
};

// The window's vertices in the order in which they came.
struct WindowOrder {
  unsigned count, oldest;
  unsigned operator[](unsigned i) const { return oldest == 0 ? i : (oldest + i) & 3; }
};
inline WindowOrder window_order(const Capture& c) {
  // A strip's pairs take turns in places 0 1 and 2 3.
  if (c.mode == GL_QUAD_STRIP && c.due == 1) return {c.next + 2, 2};
  return {c.next, 0};
}

// The next quad: of GL_QUADS four new vertices; of a strip the newer pair stays, and the older one makes room.
inline void next_quad(Capture& c) {
  const std::uint32_t due = c.due;
  c.next = due ^ 3;
  c.due = due ^ c.turn;
}

// The window's first four places: A B C D of GL_QUADS and GL_POLYGON, the two pairs of a strip.
inline const float (&corner_rows(const Capture& c, Slot slot))[4][4] {
  static_assert(sizeof(Float4) == sizeof(float[4]));
  return reinterpret_cast<const float(&)[4][4]>(c.at[slot]);
}

// The usual quad: affine in its only texture, where c.usual. True: it is counted, and its last vertex is forwarded
// like the others. Inline, so that a vertex call need save nothing for it.
[[gnu::always_inline]] inline bool usual_quad(Capture& c) {
  // Which pair of a strip is the older one does not matter to the test.
  if (!surely_affine(corner_rows(c, kPosition), corner_rows(c, kTexture), c.order)) return false;
  c.counters.pass(Reason::kAffine);
  ++c.quads;
  next_quad(c);
  return true;
}

// thread.cc: this thread's capture, which it has none of yet. Null without memory.
Capture* allocate_capture(Entry& entry);

// primitive.cc, for record.h and draw.cc.

// A vertex arrived at place c.due. True: forward its call.
bool quad_complete(Capture& c);
// `slot` is about to be set for the first time in this Begin.
void set_first(Capture& c, Slot slot);
// The first call of kExtensions[extension]: does the driver have it? If not, gives up.
void use_extension(Capture& c, unsigned extension);
// Gives up for the rest of this Begin. Afterwards the driver has seen everything, and calls are forwarded.
void abandon(Capture& c, Reason reason);
// draw.cc: makes the driver forget which sizes of calls it has seen.
void end_batch(Capture& c);
// Ends our own glBegin(GL_TRIANGLES), if open: the driver is outside Begin/End then, its state the program's.
inline void close_mesh(Capture& c) {
  if (c.mesh_open) {
    c.mesh_open = false;
    c.driver->End();
    if (c.mesh_unlit) end_unlit(c);
  }
  if (c.calls_grew) end_batch(c);
}

}  // namespace truequad

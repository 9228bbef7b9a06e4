#include "capture/list_compile.h"

#include <cstdlib>
#include <cstring>
#include <new>

#include "capture/capture.h"
#include "capture/correct.h"
#include "capture/list_play.h"
#include "capture/state.h"

namespace truequad {
namespace {

ShareGroup* group_of(const Entry& e) { return e.context ? e.context->group : nullptr; }

void set_driver(Entry& e, const Driver* driver) {
  e.driver = driver;
  if (!e.active) e.dispatch = driver;
}

// Runs f() as if no list were being compiled. The driver's list must be closed.
template <typename F>
void outside_list(Entry& e, F f) {
  ListCompile* const list = e.list;
  const ListCompile* const outer = e.executing;
  const Driver* const driver = e.driver;
  e.executing = list;
  e.list = nullptr;
  set_driver(e, list->driver);
  f();
  e.list = list;
  e.executing = outer;
  set_driver(e, driver);
}

// The driver cannot close its list between the glBegin and glEnd that it executes (GL 2.1 section 5.4).
bool executes_primitive(const Entry& e) { return e.list->mode == GL_COMPILE_AND_EXECUTE && e.inside; }
bool driver_executes_primitive(const Entry& e) { return e.list->driver_open && executes_primitive(e); }

// Of what the driver has compiled in this part.
Part::Half half_of(const Entry& e) {
  const ListCompile& list = *e.list;
  if (e.inside) return list.opened_inside ? Part::Half::kNone : Part::Half::kBegins;
  return list.opened_inside || list.unmatched_end ? Part::Half::kEnds : Part::Half::kNone;
}

void close_driver(Entry& e) {
  ListCompile& list = *e.list;
  if (!list.driver_open) return;
  if (list.driver_part) list.driver_part->half = half_of(e);
  list.driver->EndList();
  list.driver_open = false;
  set_driver(e, &keeping);
}

bool start_split(Entry& e) {
  ListCompile& list = *e.list;
  if (list.split) return true;
  if (!group_of(e)) return false;
  SplitList* split = new (std::nothrow) SplitList(list.name);
  Part* part = split ? split->add(Part::Kind::kDriver) : nullptr;
  if (!part) {
    delete split;
    return false;
  }
  list.existed = list.driver->IsList(list.name) != GL_FALSE;
  // What the driver has compiled so far is the first part, under the program's own name: it stays reserved.
  part->name = list.name;
  list.split = split;
  list.driver_part = part;
  return true;
}

Part* add_part(Entry& e, Part::Kind kind) {
  execute_kept(e);
  e.list->kept = nullptr;
  return e.list->split->add(kind);
}

// Parts of a list that is gone. Inside Begin/End they have to stay.
void delete_parts(const Entry& e, SplitList* list) {
  if (!list) return;
  for (const Part* part = list->first; part && !e.inside; part = part->next) {
    if (is_hidden_part(*part, *list)) e.driver->DeleteLists(part->name, 1);
  }
  SplitList::release(list);
}

unsigned name_size(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE: return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_2_BYTES: return 2;
    case GL_3_BYTES: return 3;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT:
    case GL_4_BYTES: return 4;
    default: return 0;
  }
}

}  // namespace

void new_list(Entry& e, GLuint name, GLenum mode) {
  barrier(e);
  e.dispatch->NewList(name, mode);
  // Errors begin no list (GL 2.1 section 5.4).
  if (e.list || e.inside || name == 0 || (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE) || !e.context) return;
  e.list = new (std::nothrow) ListCompile(name, mode, e.driver);
  if (!e.list || mode != GL_COMPILE) return;
  e.list->leading = new (std::nothrow) Part(Part::Kind::kKept);
  if (e.list->leading) set_driver(e, &keeping);
}

void keep_leading(Entry& e) {
  ListCompile& list = *e.list;
  if (!list.leading || e.inside) return;
  Part* const leading = list.leading;
  if (!end_driver_part(e)) return;
  list.leading = nullptr;
  list.split->first->name = 0;
  *list.split->end = leading;
  list.split->end = &leading->next;
  list.kept = leading;
  list.kept_primitive = list.kept_inside = false;
}

namespace {

// A list that is kept whole and has nothing but vertices and attributes is the driver's as well, for calls of it that only
// the driver can compile (compile_call).
void give_whole(Entry& e) {
  ListCompile& list = *e.list;
  SplitList& split = *list.split;
  const Part* const kept = split.first->next;
  if (split.first->name != 0 || !kept || kept->next || kept != list.kept || list.kept_primitive) return;
  outside_list(e, [&] {
    e.driver->NewList(list.name, GL_COMPILE);
    kept->kept.play(e);
    e.driver->EndList();
  });
  split.whole = true;
}

}  // namespace

void end_list(Entry& e) {
  barrier(e);
  if (!e.list) return e.driver->EndList();
  ListCompile& list = *e.list;
  if (list.leading) open_driver_part(e);
  if (executes_primitive(e)) return list.driver->EndList();  // an error: the list goes on
  // What is called after a list depends on whether it leaves the driver between glBegin and glEnd.
  if (!list.split && half_of(e) != Part::Half::kNone) start_split(e);
  if (!list.split) {
    e.driver->EndList();
  } else {
    close_driver(e);
    execute_kept(e);
    give_whole(e);
    set_driver(e, list.driver);
  }
  SplitList* const split = list.split;
  const GLuint name = list.name;
  const bool only_compiled = list.mode == GL_COMPILE;
  delete e.list;
  e.list = nullptr;
  if (ShareGroup* group = group_of(e)) {
    group->note_name(name);
    delete_parts(e, group->put(name, split));
  }
  // What was compiled has not happened.
  if (only_compiled) e.inside = false;
}

void note_unmatched_end(ListCompile& list) {
  if (list.driver_open && !list.leading) list.unmatched_end = true;
}

KeptCalls* kept_calls(Entry& e) {
  ListCompile& list = *e.list;
  if (list.leading) return &list.leading->kept;
  if (!list.kept) {
    list.kept = add_part(e, Part::Kind::kKept);
    list.kept_primitive = list.kept_inside = false;
  }
  return list.kept ? &list.kept->kept : nullptr;
}

bool keeps_quads(const Entry& e) {
  return e.list && !e.list->driver_open && e.list->kept && e.list->kept_primitive;
}

void execute_kept(Entry& e) {
  ListCompile* const list = e.list;
  if (!list || !list->kept || list->mode != GL_COMPILE_AND_EXECUTE) return;
  const Part* const part = list->kept;
  // The next call that is kept opens another part.
  list->kept = nullptr;
  const bool inside = e.inside;
  outside_list(e, [&] {
    e.inside = list->executed_inside;
    play_kept(e, *part, Played::kExecuted);
    list->executed_inside = e.inside;
    if (e.active) {
      // Cut in the midst of a primitive: the rest of it is the driver's.
      barrier(e);
      set_active(e, nullptr);
    }
  });
  e.inside = inside;
}

const Driver& open_driver_part(Entry& e) {
  ListCompile& list = *e.list;
  if (Part* const leading = list.leading) {
    list.leading = nullptr;
    set_driver(e, list.driver);
    leading->kept.play(e);
    delete leading;
  }
  if (list.driver_open) return *list.driver;
  execute_kept(e);
  list.kept = nullptr;
  if (executes_primitive(e)) return *list.driver;
  set_driver(e, list.driver);
  list.executed_inside = false;
  const GLuint name = group_of(e)->hidden_name(*e.driver);
  Part* const part = name ? list.split->add(Part::Kind::kDriver) : nullptr;
  list.driver_open = true;
  list.driver_part = part;
  list.opened_inside = e.inside;
  list.unmatched_end = false;
  if (!part) return *list.driver;
  part->name = name;
  e.driver->NewList(name, list.mode);
  return *list.driver;
}

bool is_unborn(const Entry& e, GLuint name) {
  const ListCompile* const list = e.list ? e.list : e.executing;
  return list && list->split && !list->existed && list->name == name;
}

const Driver* real_driver(const Entry& e) { return e.list ? e.list->driver : e.driver; }

bool end_driver_part(Entry& e) {
  if (driver_executes_primitive(e) || !start_split(e)) return false;
  close_driver(e);
  return true;
}

bool compile_call(Entry& e, GLuint name) {
  if (e.list->leading) open_driver_part(e);
  if (driver_executes_primitive(e)) {
    // Into the list that the driver compiles.
    play_list(e, name);
    return true;
  }
  if (!end_driver_part(e)) return false;
  Part* const part = add_part(e, Part::Kind::kCall);
  if (!part) return false;
  part->name = name;
  if (e.list->mode == GL_COMPILE_AND_EXECUTE) outside_list(e, [&] { call_list(e, name); });
  return true;
}

bool compile_calls(Entry& e, GLsizei count, GLenum type, const void* names) {
  const unsigned size = name_size(type);
  if (!size || count <= 0) return false;
  if (e.list->leading) open_driver_part(e);
  if (driver_executes_primitive(e)) {
    play_lists(e, count, type, names);
    return true;
  }
  unsigned char* const copy = static_cast<unsigned char*>(std::malloc(std::size_t(count) * size));
  Part* const part = copy && end_driver_part(e) ? add_part(e, Part::Kind::kCallMany) : nullptr;
  if (!part) {
    std::free(copy);
    return false;
  }
  std::memcpy(copy, names, std::size_t(count) * size);
  part->name = GLuint(count);
  part->type = type;
  part->names = copy;
  if (e.list->mode == GL_COMPILE_AND_EXECUTE) outside_list(e, [&] { call_lists(e, count, type, names); });
  return true;
}

void drop_list(ListCompile* list) {
  if (!list) return;
  SplitList::release(list->split);
  delete list->leading;
  delete list;
}

}  // namespace truequad

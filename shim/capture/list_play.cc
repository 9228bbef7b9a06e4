#include "capture/list_play.h"

#include <algorithm>
#include <cstring>

#include "capture/array_state.h"
#include "capture/capture.h"
#include "capture/list_compile.h"
#include "capture/state.h"

namespace truequad {
namespace {

// "GL_MAX_LIST_NESTING … at least 64" (GL 2.1 section 5.4): deeper calls are ignored, as they are by drivers.
constexpr int kMaxNesting = 64;

ShareGroup* group_of(const Entry& e) { return e.context ? e.context->group : nullptr; }

void play(Entry& e, const SplitList& list);

// A name among those of glCallLists, without the base (GL 2.1 section 5.4).
GLuint name_at(GLenum type, const void* names, GLsizei i) {
  const auto* bytes = static_cast<const unsigned char*>(names);
  const auto read = [&]<typename T>(T value) {
    std::memcpy(&value, bytes + std::size_t(i) * sizeof value, sizeof value);
    return value;
  };
  switch (type) {
    case GL_BYTE: return GLuint(GLint(read(GLbyte())));
    case GL_UNSIGNED_BYTE: return read(GLubyte());
    case GL_SHORT: return GLuint(GLint(read(GLshort())));
    case GL_UNSIGNED_SHORT: return read(GLushort());
    case GL_INT: return GLuint(read(GLint()));
    case GL_UNSIGNED_INT: return read(GLuint());
    case GL_FLOAT: {
      const GLfloat value = read(GLfloat());
      // Beyond the integers a conversion has no meaning, here or in the driver.
      return value >= -0x1p31f && value < 0x1p32f ? GLuint(std::int64_t(value)) : 0;
    }
    case GL_2_BYTES: return GLuint(bytes[2 * i]) << 8 | bytes[2 * i + 1];
    case GL_3_BYTES: return GLuint(bytes[3 * i]) << 16 | GLuint(bytes[3 * i + 1]) << 8 | bytes[3 * i + 2];
    default:
      return GLuint(bytes[4 * i]) << 24 | GLuint(bytes[4 * i + 1]) << 16 | GLuint(bytes[4 * i + 2]) << 8 | bytes[4 * i + 3];
  }
}

// Between glBegin and glEnd it cannot be asked for; what is only compiled has not changed it.
void ask_list_base(Entry& e) {
  if (e.inside || (e.list && e.list->mode == GL_COMPILE)) return;
  GLint base = 0;
  real_driver(e)->GetIntegerv(GL_LIST_BASE, &base);
  e.context->list_base = GLuint(base);
}

// After calls of lists.
void note_called(Entry& e) {
  const ShareGroup* const group = group_of(e);
  if (!group) return;
  if (group->base_in_lists.load(std::memory_order_relaxed)) {
    e.context->list_base_set = true;
  } else if (!e.context->list_base_set || !group->pop_in_lists.load(std::memory_order_relaxed)) {
    return;
  }
  ask_list_base(e);
}

bool is_name_type(GLenum type) { return type >= GL_BYTE && type <= GL_4_BYTES; }

// A list has left the driver between glBegin and glEnd, or has ended a primitive, perhaps one that was captured.
void driver_is(Entry& e, bool inside) {
  if (!inside) set_active(e, nullptr);
  e.inside = inside;
}

void play(Entry& e, const SplitList& list) {
  for (const Part* part = list.first; part; part = part->next) {
    switch (part->kind) {
      case Part::Kind::kDriver:
        if (part->name == 0) break;
        barrier(e);
        e.driver->CallList(part->name);
        if (part->half != Part::Half::kNone) driver_is(e, part->half == Part::Half::kBegins);
        note_called(e);
        break;
      case Part::Kind::kKept: play_kept(e, *part, Played::kCalled); break;
      case Part::Kind::kCall:
        play_list(e, part->name);
        note_called(e);
        break;
      case Part::Kind::kCallMany:
        play_lists(e, GLsizei(part->name), part->type, part->names);
        note_called(e);
        break;
    }
  }
}

}  // namespace

void play_list(Entry& e, GLuint name) {
  ShareGroup* const group = group_of(e);
  if ((group && group->is_hidden(name)) || is_unborn(e, name)) return;  // to the program there is no such list
  SplitList* const list = group ? group->find(name) : nullptr;
  if (!list || (e.list && list->whole)) {
    SplitList::release(list);
    barrier(e);
    return e.driver->CallList(name);
  }
  if (e.list_depth < kMaxNesting) {
    ++e.list_depth;
    play(e, *list);
    --e.list_depth;
  }
  SplitList::release(list);
}

void play_lists(Entry& e, GLsizei count, GLenum type, const void* names) {
  ShareGroup* const group = group_of(e);
  const bool any_split = group && (group->any_split() || e.executing || e.list);
  if (!any_split || count <= 0 || !is_name_type(type)) {
    barrier(e);
    return e.driver->CallLists(count, type, names);
  }
  // Inside Begin/End it cannot be asked for; then it is what glListBase said, or what it was when it could be.
  if (!e.inside) {
    GLint base = 0;
    barrier(e);
    e.driver->GetIntegerv(GL_LIST_BASE, &base);
    e.context->list_base = GLuint(base);
  }
  const GLuint base = e.context->list_base;
  for (GLsizei i = 0; i < count; ++i) {
    const GLuint offset = name_at(type, names, i);
    if (base + offset != 0) {
      play_list(e, base + offset);
      continue;
    }
    // Of a list 0 drivers have their own opinion: an error of glCallList is none here.
    barrier(e);
    e.driver->CallLists(1, GL_UNSIGNED_INT, &offset);
  }
}

void play_kept(Entry& e, const Part& part, Played how) {
  if (e.inside && part.opens) {
    // "GL_INVALID_OPERATION": a primitive inside another. Drivers then draw nothing of a compiled one.
    barrier(e);
    return e.driver->Begin(GL_QUADS);
  }
  const bool outer = e.playing, outer_relisting = e.relisting;
  e.playing = true;
  // A list that has but half of a primitive, and vertices called inside of one, are immediate mode's to drivers as well.
  e.relisting = how == Played::kCalled && !e.list && !e.inside && part.paired && !part.inside;
  part.kept.play(e);
  e.playing = outer;
  e.relisting = outer_relisting;
}

namespace {

// What lists enable, and the programs that they use, no call of the program's told.
class ListsAreCalled {
 public:
  explicit ListsAreCalled(Entry& e) : entry_(e) {}
  ~ListsAreCalled() { forget_arrays(entry_); }

 private:
  Entry& entry_;
};

}  // namespace

void call_list(Entry& e, GLuint name) {
  const ListsAreCalled called(e);
  if (!e.list) {
    play_list(e, name);
    return note_called(e);
  }
  barrier(e);
  // Whether a list 0 is an error, and when, is the driver's to say.
  if (name == 0 || !compile_call(e, name)) e.dispatch->CallList(name);
}

void call_lists(Entry& e, GLsizei count, GLenum type, const void* names) {
  const ListsAreCalled called(e);
  if (!e.list) {
    play_lists(e, count, type, names);
    return note_called(e);
  }
  barrier(e);
  if (!compile_calls(e, count, type, names)) e.dispatch->CallLists(count, type, names);
}

namespace {

// Split lists of [first, first + count) are gone, with what the driver has of them under names of ours.
void drop_split(ShareGroup& group, const Driver& driver, GLuint first, GLuint count) {
  for (SplitList* list; (list = group.take(first, count));) {
    for (const Part* part = list->first; part; part = part->next) {
      if (is_hidden_part(*part, *list)) driver.DeleteLists(part->name, 1);
    }
    SplitList::release(list);
  }
}

// The program's name of a list that is split while it is compiled is the driver's list with its first part. To the
// program it is the list before that, until glEndList.
bool compiles_split_among(const Entry& e, GLuint first, GLsizei count) {
  if (!e.list || !e.list->split || (e.inside && e.list->mode == GL_COMPILE_AND_EXECUTE)) return false;
  return e.list->name >= first && e.list->name - first < GLuint(count);
}

}  // namespace

void delete_lists(Entry& e, GLuint first, GLsizei count) {
  barrier(e);
  ShareGroup* const group = group_of(e);
  if (group && count > 0 && compiles_split_among(e, first, count)) {
    const GLuint name = e.list->name;
    drop_split(*group, *e.list->driver, name, 1);
    e.list->existed = false;
    const GLsizei before = GLsizei(name - first);
    if (before > 0) delete_lists(e, first, before);
    if (count - before > 1) delete_lists(e, name + 1, count - before - 1);
    return;
  }
  if (!group || count <= 0 || e.inside || (!group->any_hidden() && !group->any_split())) {
    return e.dispatch->DeleteLists(first, count);
  }
  // The program's names, without ours.
  const std::uint64_t begin = first, end = begin + std::uint64_t(count);
  const std::uint64_t from = ShareGroup::kHidden, to = ShareGroup::kHiddenEnd;
  const Driver& driver = e.list ? *e.list->driver : *e.driver;
  if (begin < from) driver.DeleteLists(first, GLsizei(std::min(end, from) - begin));
  if (end > to) driver.DeleteLists(GLuint(std::max(begin, to)), GLsizei(end - std::max(begin, to)));
  drop_split(*group, driver, first, GLuint(count));
}

GLuint gen_lists(Entry& e, GLsizei count) {
  barrier(e);
  ShareGroup* const group = group_of(e);
  const GLuint largest = group ? group->largest_name() : 0;
  // The driver would count on from our names, or from that of a list that is split and not yet ended.
  const bool by_us = group && (group->any_hidden() || (e.list && e.list->split)) && count > 0 && !e.inside &&
                     std::uint64_t(largest) + std::uint64_t(count) < ShareGroup::kHidden;
  if (by_us && e.list && e.list->leading) open_driver_part(e);
  if (by_us && (!e.list || end_driver_part(e))) {
    // "A contiguous set of count previously unused display list names": empty lists, as it makes them itself.
    const Driver& driver = *real_driver(e);
    for (GLuint name = largest + 1; name <= largest + GLuint(count); ++name) {
      if (compiles_split_among(e, name, 1)) {
        // The driver has its first part there.
        e.list->existed = true;
        continue;
      }
      driver.NewList(name, GL_COMPILE);
      driver.EndList();
    }
    group->note_name(largest + GLuint(count));
    return largest + 1;
  }
  const GLuint first = e.dispatch->GenLists(count);
  if (group && first && count > 0) group->note_name(first + GLuint(count) - 1);
  return first;
}

GLboolean is_list(Entry& e, GLuint name) {
  const GLboolean is = e.dispatch->IsList(name);
  const ShareGroup* const group = group_of(e);
  if (is && e.list && e.list->split && name == e.list->name) return GLboolean(e.list->existed);
  return group && group->is_hidden(name) ? GLboolean(GL_FALSE) : is;
}

void lists_made(Entry& e, GLuint first, GLsizei count) {
  ShareGroup* const group = group_of(e);
  if (!group || count <= 0) return;
  group->note_name(first + GLuint(count) - 1);
  for (SplitList* list; (list = group->take(first, GLuint(count)));) SplitList::release(list);
}

namespace {

// A command that changes the base was compiled. A glBegin that follows starts another part, so that the base can be asked for
// between the two whenever they are played.
void split_after_base(Entry& e, std::atomic<bool> ShareGroup::* in_lists) {
  if (!e.list || !e.context->group) return;
  (e.context->group->*in_lists).store(true, std::memory_order_relaxed);
  if (!e.inside) end_driver_part(e);
}

}  // namespace

void list_base(Entry& e, GLuint base) {
  e.dispatch->ListBase(base);
  if (!e.context) return;
  split_after_base(e, &ShareGroup::base_in_lists);
  if (e.inside || (e.list && e.list->mode == GL_COMPILE)) return;
  e.context->list_base = base;
  e.context->list_base_set = true;
}

void pop_attrib(Entry& e) {
  // Programs and enables of textures may be others.
  e.readers_known = false;
  e.dispatch->PopAttrib();
  if (!e.context) return;
  const ShareGroup* const group = e.context->group;
  if (e.context->list_base_set || (group && group->base_in_lists.load(std::memory_order_relaxed))) {
    split_after_base(e, &ShareGroup::pop_in_lists);
    ask_list_base(e);
  } else if (e.list && group) {
    e.context->group->pop_in_lists.store(true, std::memory_order_relaxed);
  }
}

bool list_answer(const Entry& e, GLenum name, GLint& answer) {
  if (!e.list || !e.list->split) return false;
  if (name == GL_LIST_INDEX) answer = GLint(e.list->name);
  else if (name == GL_LIST_MODE) answer = GLint(e.list->mode);
  else return false;
  return true;
}

}  // namespace truequad

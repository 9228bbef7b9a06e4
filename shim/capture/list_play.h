// Display lists when they are called, made, deleted and asked for.
#pragma once

#include "capture/lists.h"

namespace truequad {

// The program's own calls; each makes the driver's calls itself.
void call_list(Entry& entry, GLuint list);
void call_lists(Entry& entry, GLsizei count, GLenum type, const void* lists);
void list_base(Entry& entry, GLuint base);
void pop_attrib(Entry& entry);
void delete_lists(Entry& entry, GLuint first, GLsizei count);
GLuint gen_lists(Entry& entry, GLsizei count);
GLboolean is_list(Entry& entry, GLuint list);
// After the driver made `count` lists itself (glXUseXFont).
void lists_made(Entry& entry, GLuint first, GLsizei count);

// What glGet answers to GL_LIST_INDEX and GL_LIST_MODE while a list is split; false: the driver's answer is right.
bool list_answer(const Entry& entry, GLenum name, GLint& answer);

// What glCallList and glCallLists do outside of compilation; for lists that are compiled: into the driver's own list.
void play_list(Entry& entry, GLuint list);
void play_lists(Entry& entry, GLsizei count, GLenum type, const void* lists);

// Makes the calls of a kept part. While they are executed as they are compiled they are immediate mode's.
enum class Played : std::uint8_t { kCalled, kExecuted };
void play_kept(Entry& entry, const Part& part, Played how);

}  // namespace truequad

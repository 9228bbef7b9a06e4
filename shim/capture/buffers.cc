#include "capture/buffers.h"

#include <algorithm>
#include <cstdlib>

#include "capture/context.h"
#include "capture/entry.h"
#include "capture/list_compile.h"

namespace truequad {
namespace {

// Buffers through their target, as long as there have been any.
struct Calls {
  const Driver& driver;
  bool core;
  void bind(GLuint name) const {
    core ? driver.BindBuffer(GL_ARRAY_BUFFER, name) : driver.BindBufferARB(GL_ARRAY_BUFFER, name);
  }
  GLint parameter(GLenum name) const {
    GLint value = 0;
    core ? driver.GetBufferParameteriv(GL_ARRAY_BUFFER, name, &value)
         : driver.GetBufferParameterivARB(GL_ARRAY_BUFFER, name, &value);
    return value;
  }
  std::int64_t size(const Caps& caps) const {
    if (caps.version < 32) return parameter(GL_BUFFER_SIZE);
    GLint64 value = 0;
    driver.GetBufferParameteri64v(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &value);
    return value;
  }
  void read(std::size_t size, void* to) const {
    core ? driver.GetBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(size), to)
         : driver.GetBufferSubDataARB(GL_ARRAY_BUFFER, 0, GLsizeiptr(size), to);
  }
  bool exists(GLuint name) const { return core ? driver.IsBuffer(name) : driver.IsBufferARB(name); }
};

}  // namespace

BufferCopies::~BufferCopies() {
  for (BufferCopy& copy : copies_) std::free(copy.bytes);
}

// Its own place, or that of the copy that was not used for longest; null if all are in use.
BufferCopy* BufferCopies::place_for(GLuint name) {
  BufferCopy* oldest = &copies_[0];
  for (BufferCopy& copy : copies_) {
    if (copy.name == name) return &copy;
    if (copy.last_use < oldest->last_use) oldest = &copy;
  }
  if (oldest->last_use == use_) return nullptr;
  oldest->name = 0;
  return oldest;
}

bool BufferCopies::reserve(BufferCopy& copy, std::size_t size) {
  if (size <= copy.capacity && size >= copy.capacity / 4) return true;
  total_ -= copy.capacity;
  std::free(copy.bytes);
  copy.bytes = nullptr;
  copy.capacity = 0;
  while (total_ + size > kMostBytes) {
    BufferCopy* oldest = nullptr;
    for (BufferCopy& other : copies_) {
      if (other.capacity > 0 && other.last_use != use_ && (!oldest || other.last_use < oldest->last_use)) oldest = &other;
    }
    if (!oldest) return false;
    total_ -= oldest->capacity;
    std::free(oldest->bytes);
    *oldest = BufferCopy{};
  }
  // At least a byte, so that an empty buffer has a copy.
  copy.bytes = static_cast<unsigned char*>(std::malloc(std::max<std::size_t>(size, 1)));
  if (!copy.bytes) return false;
  copy.capacity = size;
  total_ += size;
  return true;
}

const BufferCopy* BufferCopies::contents(const Driver& driver, const ContextRecord& context, GLuint name) {
  const Caps& caps = context.caps;
  BufferChanges& changes = context.group->buffers;
  BufferCopy* const copy = place_for(name);
  if (!copy) return nullptr;
  changes.watch();
  // Before the contents: a change that comes in between makes the copy old.
  const std::uint64_t stamp = changes.stamp(name);
  copy->last_use = use_;
  if (copy->name == name && copy->stamp == stamp) return copy;
  copy->name = 0;

  const Calls calls{driver, caps.version >= 15};
  // Binding a name that is not in use would make a buffer of it.
  if (!calls.exists(name)) return nullptr;
  GLint before = 0;
  driver.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &before);
  // A binding of a buffer that another context deleted could not be made again, nor has it the contents of the name.
  if (before != 0 && may_be_deleted_in_context(context, GLuint(before))) return nullptr;
  if (before != 0 && GLuint(before) != name && !calls.exists(GLuint(before))) return nullptr;
  if (GLuint(before) != name) calls.bind(name);
  const std::int64_t size = calls.size(caps);
  const bool readable = !calls.parameter(GL_BUFFER_MAPPED) && size >= 0 && std::uint64_t(size) <= kMostBytes;
  const bool read = readable && reserve(*copy, std::size_t(size));
  if (read && size > 0) calls.read(std::size_t(size), copy->bytes);
  if (GLuint(before) != name) calls.bind(GLuint(before));
  if (!read) return nullptr;
  copy->name = name;
  copy->stamp = stamp;
  copy->size = std::size_t(size);
  return copy;
}

namespace {

// The query of a target's binding and the version that has it; 0: another target.
struct Binding {
  GLenum query = 0;
  int version = 0;
};
constexpr Binding binding_of(GLenum target) {
  switch (target) {
    case GL_ARRAY_BUFFER: return {GL_ARRAY_BUFFER_BINDING, 0};
    case GL_ELEMENT_ARRAY_BUFFER: return {GL_ELEMENT_ARRAY_BUFFER_BINDING, 0};
    case GL_PIXEL_PACK_BUFFER: return {GL_PIXEL_PACK_BUFFER_BINDING, 21};
    case GL_PIXEL_UNPACK_BUFFER: return {GL_PIXEL_UNPACK_BUFFER_BINDING, 21};
    case GL_UNIFORM_BUFFER: return {GL_UNIFORM_BUFFER_BINDING, 31};
    case GL_TEXTURE_BUFFER: return {GL_TEXTURE_BUFFER_BINDING, 31};
    case GL_COPY_READ_BUFFER: return {GL_COPY_READ_BUFFER_BINDING, 31};
    case GL_COPY_WRITE_BUFFER: return {GL_COPY_WRITE_BUFFER_BINDING, 31};
    case GL_QUERY_BUFFER: return {GL_QUERY_BUFFER_BINDING, 44};
    default: return {};
  }
}

void target_changed(Entry& e, BufferChanges& changes, GLenum target) {
  const Binding binding = binding_of(target);
  const ContextRecord& context = *e.context;
  if (binding.query == 0 || !context.caps_read || context.caps.version < binding.version) return changes.all_changed();
  GLint name = 0;
  real_driver(e)->GetIntegerv(binding.query, &name);
  if (name != 0) changes.changed(GLuint(name));
}

}  // namespace

BufferChange::~BufferChange() {
  Entry& e = entry_;
  // Between glBegin and glEnd such calls are errors.
  if (!e.context || !e.context->group || !e.context->group->buffers.watched() || e.inside) return;
  BufferChanges& changes = e.context->group->buffers;
  switch (of_) {
    case Of::kTarget: target_changed(e, changes, which_); break;
    case Of::kName: changes.changed(which_); break;
    case Of::kPacked: target_changed(e, changes, GL_PIXEL_PACK_BUFFER); break;
    case Of::kQueried: target_changed(e, changes, GL_QUERY_BUFFER); break;
    case Of::kAny: changes.all_changed(); break;
  }
}

}  // namespace truequad

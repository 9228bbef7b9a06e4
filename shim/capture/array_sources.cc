#include "capture/array_sources.h"

#include <algorithm>
#include <new>

#include "capture/lists.h"

namespace truequad {

// More than any sum of an index and a base vertex; sums below zero are beyond it.
static constexpr std::uint64_t kClientElements = std::uint64_t(1) << 34;

void free_array_memory(ContextRecord& context) {
  delete context.arrays;
}

ArrayMemory* array_memory(Entry& e) {
  if (!e.context->arrays) e.context->arrays = new (std::nothrow) ArrayMemory;
  return e.context->arrays;
}

Reason ArraySources::open(Entry& e, const Driver& driver) {
  ContextRecord& context = *e.context;
  caps_ = &caps_of(context, driver);
  if (!caps_->supported) return Reason::kUnknownContext;
  entry_ = &e;
  driver_ = &driver;
  state_ = &context.arrays->state;
  ready_ = 0;
  elements_ = ~std::uint64_t(0);
  context.arrays->buffers.start();
  read_arrays(e, driver, *caps_, *state_);
  if (state_->unified) return Reason::kBuffer;
  if (state_->generic_position) return Reason::kGenericAttribute;
  return Reason::kNone;
}

const BufferCopy* ArraySources::contents(GLuint name) {
  ContextRecord& context = *entry_->context;
  if (!context.group || may_be_deleted_in_arrays(context, *driver_, name)) return nullptr;
  return context.arrays->buffers.contents(*driver_, context, name);
}

Reason ArraySources::find(SlotMask slots) {
  Reason reason = Reason::kNone;
  for_each_slot(slots & ~ready_, [&](Slot slot) {
    const VertexArray& array = state_->array[slot];
    ArraySource& source = source_[slot];
    source = {array.pointer, array.stride, kClientElements, array.type, array.size, array.normalized, array.bgra};
    if (array.buffer != 0) {
      const BufferCopy* const copy = contents(array.buffer);
      if (!copy) return void(reason = Reason::kBuffer);
      const std::uint64_t offset = reinterpret_cast<std::uintptr_t>(array.pointer);
      const std::uint64_t end = copy->size;
      source.bytes = copy->bytes + std::min(offset, end);
      source.elements = offset > end || array.bytes > end - offset ? 0 : (end - offset - array.bytes) / array.stride + 1;
    }
    if (!source.bytes || array.bytes == 0) return void(reason = Reason::kArrayRange);
    elements_ = std::min(elements_, source.elements);
    ready_ |= bit(slot);
  });
  return reason;
}

Reason ArraySources::find(const ArrayDraw& draw, GLsizei primitive, Elements& out) {
  out = {};
  if (draw.type == 0) {
    out.base = draw.first[primitive];
    return Reason::kNone;
  }
  out.type = draw.type;
  out.base = draw.base ? draw.base[primitive] : 0;
  out.indices = static_cast<const unsigned char*>(draw.indices[primitive]);
  if (const GLuint name = index_buffer(*entry_, *driver_, *caps_, *state_); name != 0) {
    const BufferCopy* const copy = contents(name);
    if (!copy) return Reason::kBuffer;
    const std::uint64_t offset = reinterpret_cast<std::uintptr_t>(out.indices);
    const std::uint64_t size = std::uint64_t(draw.count[primitive]) * index_bytes(draw.type);
    if (offset > copy->size || size > copy->size - offset) return Reason::kArrayRange;
    out.indices = copy->bytes + offset;
  }
  return out.indices ? Reason::kNone : Reason::kArrayRange;
}

bool ArraySources::all_readable() {
  bool readable = true;
  for_each_slot(state_->enabled & ~ready_, [&](Slot slot) {
    const GLuint buffer = state_->array[slot].buffer;
    readable = readable && (buffer == 0 || contents(buffer));
  });
  return readable;
}

}  // namespace truequad

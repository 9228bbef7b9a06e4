// Where calls go while a primitive is captured: attributes and vertices are recorded, everything else settles it first.
// One table for the whole time between glBegin and glEnd, so that a door is a load and a jump, and asks nothing.
#include "capture/capture.h"
#include "capture/record.h"

namespace truequad {
namespace {

template <auto member, typename Function>
struct Settled;
template <auto member, typename Result, typename... Arguments>
struct Settled<member, Result(GLAPIENTRY*)(Arguments...)> {
  [[gnu::cold]] static Result GLAPIENTRY call(Arguments... arguments) {
    barrier(entry);
    return (entry.driver->*member)(arguments...);
  }
};

constexpr Driver make_capturing() {
  Driver table{};
#define TQ_COMMAND(name, result, parameters, arguments) \
  table.name = Settled<&Driver::name, decltype(Driver::name)>::call;
#include "other_calls.inc"
#undef TQ_COMMAND
#define TQ_ARRAY_STATE(name, result, parameters, arguments) \
  table.name = Settled<&Driver::name, decltype(Driver::name)>::call;
#define TQ_INDEX_BUFFER TQ_ARRAY_STATE
#define TQ_READER_STATE TQ_ARRAY_STATE
#define TQ_BUFFER_OF_TARGET TQ_ARRAY_STATE
#define TQ_BUFFER_OF_NAME TQ_ARRAY_STATE
#define TQ_BUFFER_PACKED TQ_ARRAY_STATE
#define TQ_BUFFER_QUERIED TQ_ARRAY_STATE
#define TQ_ANY_BUFFER TQ_ARRAY_STATE
#include "array_commands.inc"
#define TQ_DRAW(name, parameters, arguments, draw) table.name = Settled<&Driver::name, decltype(Driver::name)>::call;
#include "capture/array_calls.inc"
#undef TQ_DRAW
#define TQ_ATTRIBUTE(Name, family, size, type, normalized, vector, requires_) \
  table.Name = recording::Recorder<kRows[kRow##Name], &Driver::Name>::call;
#include "attribute_calls.inc"
#undef TQ_ATTRIBUTE
  // Their doors note something, and then come here.
#define TQ_NOTED(name) table.name = Settled<&Driver::name, decltype(Driver::name)>::call;
  TQ_NOTED(DeleteBuffers) TQ_NOTED(DeleteBuffersARB) TQ_NOTED(Disable) TQ_NOTED(Enable)
  TQ_NOTED(GenVertexArrays) TQ_NOTED(GenVertexArraysAPPLE) TQ_NOTED(CreateVertexArrays)
  TQ_NOTED(PushClientAttrib) TQ_NOTED(PushClientAttribDefaultEXT) TQ_NOTED(PopClientAttrib)
  TQ_NOTED(Clear) TQ_NOTED(DepthFunc) TQ_NOTED(StencilOp) TQ_NOTED(StencilOpSeparate)
  TQ_NOTED(CallList) TQ_NOTED(CallLists) TQ_NOTED(ListBase) TQ_NOTED(PopAttrib) TQ_NOTED(DeleteLists) TQ_NOTED(GenLists) TQ_NOTED(IsList)
  TQ_NOTED(GetBooleanv) TQ_NOTED(GetDoublev) TQ_NOTED(GetFloatv) TQ_NOTED(GetIntegerv)
  TQ_NOTED(NewList) TQ_NOTED(EndList)
#undef TQ_NOTED
  table.Begin = [](GLenum mode) { begin(entry, mode); };
  table.End = [] { end(entry); };
  return table;
}

}  // namespace

constinit const Driver capturing = make_capturing();

}  // namespace truequad

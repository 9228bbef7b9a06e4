#include "array_commands.h"

#include <regex>

namespace truequad::generate {
namespace {

struct Kind {
  const char* macro;
  std::regex names;
};

// The first that matches. What is not known to leave arrays and buffers alone may match: it costs a query or two.
const Kind kKinds[] = {
    {"", std::regex("(Get|Is|Gen|ExtGet|Create).*Pointer.*|IsVertexArray.*|GenVertexArrays.*|GetVertexA.*")},
    // GL 4.6 compatibility sections 10.3 and 10.4, EXT_direct_state_access …
    {"TQ_ARRAY_STATE", std::regex(".*Pointer(ARB|EXT|NV|OES|APPLE|ATI|SUN|ListIBM|vINTEL)?|.*(ClientState|ClientAttrib).*|"
                                  "(ClientActiveTexture|BindVertexArray|DeleteVertexArrays|VertexArray).*|"
                                  "(Enable|Disable)Vertex(Attrib)?Array.*|InterleavedArrays|BindVertexBuffers?|"
                                  "VertexBindingDivisor|VertexAttrib(Binding|Divisor|I?Format|LFormat|ArrayObject).*|"
                                  ".*FormatNV|PrimitiveRestartIndex(NV)?")},
    {"TQ_INDEX_BUFFER", std::regex("BindBuffer(ARB)?")},
    // Programs and pipelines (section 7.3), and texture enables by the number of their unit.
    {"TQ_READER_STATE", std::regex("Use(Shader)?Program.*|ActiveProgramEXT|(Bind|Delete)ProgramPipelines?.*|DeletePrograms?.*|"
                                   "DeleteObjectARB|(Enable|Disable)(i|Indexed).*")},
    // Section 6: the first parameter is a target that the buffer is bound to.
    {"TQ_BUFFER_OF_TARGET",
     std::regex("(Buffer(Sub)?Data|BufferStorage|(Map|Unmap)Buffer|MapBufferRange|FlushMappedBufferRange|"
                "BufferPageCommitment|ClearBuffer(Sub)?Data|BufferParameteri)(ARB|EXT|OES|APPLE|ExternalEXT|MemEXT|MemNV)?")},
    // The first parameter is its name.
    {"TQ_BUFFER_OF_NAME",
     std::regex("(NamedBuffer(Sub)?Data|NamedBufferStorage|(Map|Unmap)NamedBuffer|MapNamedBufferRange|"
                "FlushMappedNamedBufferRange|NamedBufferPageCommitment|ClearNamedBuffer(Sub)?Data|"
                "InvalidateBuffer(Sub)?Data|NamedBufferAttachMemory)(ARB|EXT|NV|ExternalEXT|MemEXT|MemNV)?")},
    // What is read back may go into the pixel pack buffer (section 18.2), a query's result into the query buffer.
    {"TQ_BUFFER_PACKED",
     std::regex("Readn?Pixels(ARB|EXT|KHR)?|Getn?(Compressed)?(Tex|Texture|MultiTex)(Sub)?Image(ARB|EXT)?|"
                "Getn?(ColorTable|ConvolutionFilter|SeparableFilter|Histogram|Minmax|PixelMapu?[fsi]v|PixelMapusv|"
                "PolygonStipple)(ARB|EXT|SGI)?")},
    {"TQ_BUFFER_QUERIED", std::regex("GetQueryObject(u?i|u?i64)v(ARB|EXT)?")},
    // Copies, transform feedback, writes of shaders, which a barrier must follow, and vendors' ways.
    {"TQ_ANY_BUFFER",
     std::regex("(Async)?Copy(Named)?BufferSubData.*|NamedCopyBufferSubDataEXT|MemoryBarrier.*|"
                "(Begin|End|Pause|Resume)TransformFeedback.*|GetQueryBufferObject.*|.*ObjectBufferATI|Multicast.*Buffer.*|"
                "LGPU.*|BufferAttachMemoryNV|QueryObjectParameteruiAMD|VertexArrayRange.*")},
};

}  // namespace

std::string array_macro(const std::string& name) {
  for (const Kind& kind : kKinds) {
    if (std::regex_match(name, kind.names)) return kind.macro;
  }
  return "";
}

bool draws_from_arrays(const std::string& name) {
  static const std::regex names(
      "(Multi)?Draw(Arrays|Elements)(EXT)?|DrawRangeElements(EXT)?|((Multi)?Draw|DrawRange)ElementsBaseVertex|"
      "Draw(Arrays|Elements)Instanced(ARB|EXT)?|DrawArraysInstancedBaseInstance|"
      "DrawElementsInstancedBase(Vertex|Instance|VertexBaseInstance)|ArrayElement(EXT)?|DeleteBuffers(ARB)?|"
      "GenVertexArrays(APPLE)?|CreateVertexArrays|PushClientAttrib(DefaultEXT)?|PopClientAttrib|"
      "(Multi)?Draw(Arrays|Elements)Indirect|"
      "Rect[dfis]v?");
  return std::regex_match(name, names);
}

}  // namespace truequad::generate

#include <cstring>

#include "elements.h"

namespace truequad::images {
namespace {

// All elements in one buffer behind a gap, `fill` puts them there; each primitive by glDrawArrays.
void from_buffer(const Scene& scene, const std::function<void(std::size_t gap, std::size_t size, const void*)>& fill) {
  constexpr std::size_t kGap = 12;
  std::vector<GLint> first;
  std::vector<GLsizei> count;
  const auto all = all_elements(scene, first, count);
  const std::size_t size = all.size() * sizeof(Element);
  const GLuint buffer = buffer_of(GL_ARRAY_BUFFER, kGap + size, nullptr);
  fill(kGap, size, all.data());
  enable_arrays();
  point_at(offset(kGap));
  for (std::size_t i = 0; i < first.size(); ++i) glDrawArrays(mode_of(scene.primitives[i]), first[i], count[i]);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  disable_arrays();
  delete_buffer(buffer);
}

// The buffer has other contents when it is first drawn from; then `change` replaces them.
auto changed_buffer(const std::function<void(GLuint, std::size_t, const void*)>& change, bool mutable_ = true) {
  return [change, mutable_](const Scene& scene) {
    std::vector<GLint> first;
    std::vector<GLsizei> count;
    const auto all = all_elements(scene, first, count);
    const std::size_t size = all.size() * sizeof(Element);
    auto others = all;
    for (Element& e : others) {
      e.position[0] = -e.position[0] * 0.75f;
      e.texture[0] = 1 - e.texture[0];
    }
    GLuint buffer;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    if (mutable_) {
      glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(size), others.data(), GL_DYNAMIC_DRAW);
    } else {
      glBufferStorage(GL_ARRAY_BUFFER, GLsizeiptr(size), others.data(),
                      GL_DYNAMIC_STORAGE_BIT | GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT);
    }
    enable_arrays();
    point_at(offset(0));
    const auto draw = [&] {
      for (std::size_t i = 0; i < first.size(); ++i) glDrawArrays(mode_of(scene.primitives[i]), first[i], count[i]);
    };
    draw();
    glClear(GL_COLOR_BUFFER_BIT);
    change(buffer, size, all.data());
    draw();
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    disable_arrays();
    delete_buffer(buffer);
  };
}

}  // namespace

void add_buffer_ways(std::map<std::string, Way>& ways) {
  ways.insert({
      {"buffer", [](const Scene& s) {
         from_buffer(s, [](std::size_t gap, std::size_t size, const void* data) {
           glBufferSubData(GL_ARRAY_BUFFER, GLintptr(gap), GLsizeiptr(size), data);
         });
       }},
      {"index_buffer", [](const Scene& s) {
         enable_arrays();
         for (const Primitive& p : s.primitives) {
           auto elements = elements_of(p);
           const auto indices = shuffled<GLushort>(elements);
           point_at(elements);
           const GLuint buffer = buffer_of(GL_ELEMENT_ARRAY_BUFFER, 4 + indices.size() * 2, nullptr);
           glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 4, GLsizeiptr(indices.size() * 2), indices.data());
           glDrawElements(mode_of(p), count_of(p), GL_UNSIGNED_SHORT, offset(4));
           glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
           delete_buffer(buffer);
         }
         disable_arrays();
       }},
      {"vertex_array_objects", [](const Scene& s) {
         std::vector<GLuint> objects(s.primitives.size()), buffers(s.primitives.size());
         glGenVertexArrays(GLsizei(objects.size()), objects.data());
         for (std::size_t i = 0; i < objects.size(); ++i) {
           const auto elements = elements_of(s.primitives[i]);
           glBindVertexArray(objects[i]);
           buffers[i] = buffer_of(GL_ARRAY_BUFFER, elements.size() * sizeof(Element), elements.data());
           enable_arrays();
           point_at(offset(0));
         }
         for (std::size_t i = 0; i < objects.size(); ++i) {
           glBindVertexArray(objects[i]);
           glDrawArrays(mode_of(s.primitives[i]), 0, count_of(s.primitives[i]));
         }
         glBindVertexArray(0);
         glBindBuffer(GL_ARRAY_BUFFER, 0);
         glDeleteVertexArrays(GLsizei(objects.size()), objects.data());
         glDeleteBuffers(GLsizei(buffers.size()), buffers.data());
       }},
      {"data", changed_buffer([](GLuint, std::size_t size, const void* data) {
         glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(size), data, GL_DYNAMIC_DRAW);
       })},
      {"sub_data", changed_buffer([](GLuint, std::size_t size, const void* data) {
         glBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(size), data);
       })},
      {"named", changed_buffer([](GLuint name, std::size_t size, const void* data) {
         glBindBuffer(GL_ARRAY_BUFFER, 0);
         // OSMesa does not export it.
         const auto named = PFNGLNAMEDBUFFERSUBDATAPROC(OSMesaGetProcAddress("glNamedBufferSubData"));
         named(name, 0, GLsizeiptr(size), data);
       })},
      {"map", changed_buffer([](GLuint, std::size_t size, const void* data) {
         std::memcpy(glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY), data, size);
         glUnmapBuffer(GL_ARRAY_BUFFER);
       })},
      {"map_range", changed_buffer([](GLuint, std::size_t size, const void* data) {
         void* to = glMapBufferRange(GL_ARRAY_BUFFER, 0, GLsizeiptr(size), GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT);
         std::memcpy(to, data, size);
         glFlushMappedBufferRange(GL_ARRAY_BUFFER, 0, GLsizeiptr(size));
         glUnmapBuffer(GL_ARRAY_BUFFER);
       })},
      {"copied", changed_buffer([](GLuint, std::size_t size, const void* data) {
         const GLuint other = buffer_of(GL_COPY_READ_BUFFER, size, data);
         glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, 0, 0, GLsizeiptr(size));
         delete_buffer(other);
       })},
      {"cleared", changed_buffer([](GLuint name, std::size_t size, const void* data) {
         const GLuint zero = 0;
         glClearBufferData(GL_ARRAY_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
         glInvalidateBufferData(name);
         glBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(size), data);
       })},
      {"deleted", changed_buffer([](GLuint name, std::size_t size, const void* data) {
         delete_buffer(name);
         glBindBuffer(GL_ARRAY_BUFFER, name);
         glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(size), data, GL_STREAM_DRAW);
         point_at(offset(0));
       })},
      {"other_context", changed_buffer([](GLuint name, std::size_t size, const void* data) {
         glFinish();
         make_current(second_context);
         glBindBuffer(GL_ARRAY_BUFFER, name);
         glBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(size), data);
         glBindBuffer(GL_ARRAY_BUFFER, 0);
         glFinish();
         make_current(first_context);
       })},
      {"pixels_packed", changed_buffer([](GLuint name, std::size_t size, const void* data) {
         // The same bytes through a texture.
         glPushAttrib(GL_ALL_ATTRIB_BITS);
         GLuint texture;
         glGenTextures(1, &texture);
         glBindTexture(GL_TEXTURE_2D, texture);
         glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, GLsizei(size / 4), 1, 0, GL_RED, GL_FLOAT, data);
         glBindBuffer(GL_PIXEL_PACK_BUFFER, name);
         glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, nullptr);
         glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
         glDeleteTextures(1, &texture);
         glPopAttrib();
       })},
      {"persistent", changed_buffer([](GLuint, std::size_t size, const void* data) {
         void* to = glMapBufferRange(GL_ARRAY_BUFFER, 0, GLsizeiptr(size),
                                     GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT);
         std::memcpy(to, data, size);
       }, false)},
  });
}

}  // namespace truequad::images

// Which commands set a vertex or a vertex attribute inside Begin/End (GL 2.1 section 2.6.3), and what they take.
#pragma once

#include <optional>
#include <string>

namespace truequad::generate {

struct AttributeCall {
  std::string family;    // Vertex, TexCoord, … : what is set
  int size = 0;          // components; 0 for materials, whose parameter name decides
  std::string type;      // GLfloat …; Packed for the forms of ARB_vertex_type_2_10_10_10_rev
  bool normalized = false;
  bool vector = false;   // values come by pointer
  std::string requires_;  // "Core", or the extension without which the call does nothing
};

// The meaning of a command by its name (without "gl"), or nothing if it sets no attribute. Names are composed as
// GL 2.1 section 2.3 "GL Command Syntax" says: name, number of components, type letters, v, vendor suffix.
std::optional<AttributeCall> attribute_call(const std::string& name);

}  // namespace truequad::generate

// The Khronos registry (gl.xml, "registry.rnc"), reduced to what the doors need: types, enums, commands.
#pragma once

#include <string>
#include <vector>

namespace truequad::generate {

struct Parameter {
  std::string declaration;  // "const GLfloat *v", as C++ takes it
  std::string name;
};

struct Command {
  std::string name;  // without the leading "gl"
  std::string result;
  std::vector<Parameter> parameters;
};

struct Enum {
  std::string name, value;
};

struct Registry {
  std::vector<std::string> types;  // C declarations, in order
  std::vector<Enum> enums;         // each name once
  std::vector<Command> commands;   // each name once, sorted by name
};

// Reads a registry file. On failure `error` says why in one line and the result is empty.
Registry read_registry(const std::string& path, std::string& error);

}  // namespace truequad::generate

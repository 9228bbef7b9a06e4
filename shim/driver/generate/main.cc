// truequad_generate GL_XML DIRECTORY: writes the generated headers of the driver table into DIRECTORY.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

#include "array_commands.h"
#include "attribute_grammar.h"
#include "registry.h"

namespace truequad::generate {
namespace {

std::string declarations(const Command& command) {
  std::string text;
  for (const Parameter& parameter : command.parameters) text += (text.empty() ? "" : ", ") + parameter.declaration;
  return "(" + text + ")";
}

std::string arguments(const Command& command) {
  std::string text;
  for (const Parameter& parameter : command.parameters) text += (text.empty() ? "" : ", ") + parameter.name;
  return "(" + text + ")";
}

void write_types(const Registry& registry, std::ostream& out) {
  out << "#pragma once\n#include <stddef.h>\n#include <stdint.h>\n#define GLAPIENTRY\n"
         "typedef int8_t khronos_int8_t;\ntypedef uint8_t khronos_uint8_t;\ntypedef int16_t khronos_int16_t;\n"
         "typedef uint16_t khronos_uint16_t;\ntypedef int32_t khronos_int32_t;\ntypedef uint32_t khronos_uint32_t;\n"
         "typedef int64_t khronos_int64_t;\ntypedef uint64_t khronos_uint64_t;\ntypedef float khronos_float_t;\n"
         "typedef ptrdiff_t khronos_intptr_t;\ntypedef ptrdiff_t khronos_ssize_t;\n";
  for (const std::string& type : registry.types) out << type << "\n";
}

void write_enums(const Registry& registry, std::ostream& out) {
  out << "#pragma once\n";
  for (const Enum& value : registry.enums) out << "#define " << value.name << " " << value.value << "\n";
}

void write_command(const Command& command, std::ostream& out, const std::string& macro = "TQ_COMMAND") {
  out << macro << "(" << command.name << ", " << command.result << ", " << declarations(command) << ", "
      << arguments(command) << ")\n";
}

// The doors of these are written by hand.
bool has_own_door(const std::string& name) {
  static const std::set<std::string> names = {
      "Begin",    "CallList",   "CallLists",   "Clear",  "DeleteLists", "DepthFunc", "Disable",  "Enable",
      "End",      "EndList",    "GenLists",    "GetBooleanv", "GetDoublev", "GetFloatv", "GetIntegerv", "IsList",
      "ListBase", "NewList",    "PopAttrib", "StencilOp",   "StencilOpSeparate"};
  return names.contains(name) || draws_from_arrays(name);
}

void write_attribute(const std::string& name, const AttributeCall& call, std::ostream& out) {
  out << "TQ_ATTRIBUTE(" << name << ", " << call.family << ", " << call.size << ", " << call.type << ", "
      << call.normalized << ", " << call.vector << ", " << call.requires_ << ")\n";
}

// gl_commands.inc: every command. The others divide it: attribute_calls.inc and attribute_commands.inc (the same
// commands, what they mean and how they are called), array_commands.inc (what changes vertex arrays and buffers), and
// other_calls.inc (the rest, less those with doors of their own).
void write_commands(const Registry& registry, std::ostream& all, std::ostream& attributes,
                    std::ostream& attribute_commands, std::ostream& arrays, std::ostream& others) {
  for (const Command& command : registry.commands) {
    write_command(command, all);
    if (const auto call = attribute_call(command.name)) {
      write_attribute(command.name, *call, attributes);
      write_command(command, attribute_commands);
    } else if (has_own_door(command.name)) {
      continue;
    } else if (const std::string macro = array_macro(command.name); !macro.empty()) {
      write_command(command, arrays, macro);
    } else {
      write_command(command, others);
    }
  }
}

int run(const std::string& registry_path, const std::filesystem::path& directory) {
  std::string error;
  const Registry registry = read_registry(registry_path, error);
  if (!error.empty()) {
    std::fprintf(stderr, "truequad_generate: %s\n", error.c_str());
    return 1;
  }
  std::filesystem::create_directories(directory);
  std::ofstream types(directory / "gl_types.h"), enums(directory / "gl_enums.h"),
      commands(directory / "gl_commands.inc"), attributes(directory / "attribute_calls.inc"),
      attribute_commands(directory / "attribute_commands.inc"), arrays(directory / "array_commands.inc"),
      others(directory / "other_calls.inc");
  write_types(registry, types);
  write_enums(registry, enums);
  write_commands(registry, commands, attributes, attribute_commands, arrays, others);
  for (std::ofstream* file : {&types, &enums, &commands, &attributes, &attribute_commands, &arrays, &others}) {
    file->close();
    if (!*file) {
      std::fprintf(stderr, "truequad_generate: cannot write into %s\n", directory.c_str());
      return 1;
    }
  }
  return 0;
}

}  // namespace
}  // namespace truequad::generate

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: truequad_generate GL_XML DIRECTORY\n");
    return 2;
  }
  return truequad::generate::run(argv[1], argv[2]);
}

// truequad_generate GL_XML DIRECTORY: writes the generated headers of the driver table into DIRECTORY.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

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

void write_commands(const Registry& registry, std::ostream& out) {
  for (const Command& command : registry.commands) {
    out << "TQ_COMMAND(" << command.name << ", " << command.result << ", " << declarations(command) << ", "
        << arguments(command) << ")\n";
  }
}

void write_attributes(const Registry& registry, std::ostream& attributes, std::ostream& others) {
  for (const Command& command : registry.commands) {
    const auto call = attribute_call(command.name);
    if (!call) {
      others << "TQ_COMMAND(" << command.name << ", " << command.result << ", " << declarations(command) << ", "
             << arguments(command) << ")\n";
      continue;
    }
    attributes << "TQ_ATTRIBUTE(" << command.name << ", " << call->family << ", " << call->size << ", " << call->type
               << ", " << call->normalized << ", " << call->vector << ", " << call->requires_ << ", "
               << declarations(command) << ", " << arguments(command) << ")\n";
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
      others(directory / "other_calls.inc");
  write_types(registry, types);
  write_enums(registry, enums);
  write_commands(registry, commands);
  write_attributes(registry, attributes, others);
  for (std::ofstream* file : {&types, &enums, &commands, &attributes, &others}) {
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

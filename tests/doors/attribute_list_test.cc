// The generated list of attribute calls, compared with the Khronos registry read in another, cruder way: by the first
// letters of a name, by the parameters' declarations and by who requires the command. So none is forgotten, and none
// is taken for more or less than it is.
#include <gtest/gtest.h>

#include <map>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

namespace {

struct Row {
  std::string family;
  int size;
  std::string type;
  int normalized, vector;
  std::string requirement;
};

const std::map<std::string, Row>& rows() {
  static const std::map<std::string, Row> kept = {
#define TQ_ATTRIBUTE(name, family, size, type, normalized, vector, requirement) \
  {"gl" #name, {#family, size, #type, normalized, vector, #requirement}},
#include "attribute_calls.inc"
#undef TQ_ATTRIBUTE
  };
  return kept;
}

struct Parameter {
  std::string type, name, length;
  bool pointer;
};

struct Registry {
  std::map<std::string, std::vector<Parameter>> commands;
  std::map<std::string, std::string> alias_of;
  std::map<std::string, std::set<std::string>> extensions;  // of a command
  std::set<std::string> core;                               // in any version of desktop GL
};

std::string all_text(const pugi::xml_node& node) {
  if (node.type() == pugi::node_pcdata) return node.value();
  std::string text;
  for (const pugi::xml_node& child : node.children()) text += all_text(child);
  return text;
}

Registry read() {
  pugi::xml_document document;
  Registry registry;
  if (!document.load_file(TRUEQUAD_GL_XML)) return registry;
  for (const pugi::xpath_node& found : document.select_nodes("/registry/commands/command")) {
    const std::string name = found.node().child("proto").child_value("name");
    std::vector<Parameter> parameters;
    for (const pugi::xml_node& param : found.node().children("param")) {
      parameters.push_back({param.child_value("ptype"), param.child_value("name"), param.attribute("len").value(),
                            all_text(param).find('*') != std::string::npos});
    }
    registry.commands[name] = parameters;
    if (const auto alias = found.node().child("alias")) registry.alias_of[name] = alias.attribute("name").value();
  }
  for (const pugi::xpath_node& found : document.select_nodes("/registry/feature[@api='gl']/require/command")) {
    registry.core.insert(found.node().attribute("name").value());
  }
  for (const pugi::xpath_node& found : document.select_nodes("/registry/extensions/extension/require/command")) {
    const std::string extension = found.node().parent().parent().attribute("name").value();
    registry.extensions[found.node().attribute("name").value()].insert(extension);
  }
  return registry;
}

const Registry& registry() {
  static const Registry kept = read();
  return kept;
}

// GL 2.1 section 2.6.3 "Vertex Specification Commands": what the names of calls that set a vertex or an attribute begin
// with. Longer beginnings first.
const char* const kBeginnings[] = {"glVertexAttrib", "glVertex", "glMultiTexCoord", "glTexCoord", "glSecondaryColor",
                                   "glColor",        "glNormal", "glFogCoord",      "glIndex",    "glEdgeFlag",
                                   "glMaterial"};

// What other calls that begin so have in their names: array set-up, masks, colour tables, fragment shaders; and the
// calls that are barriers because they set several attributes, several vertices or another vertex stream at once.
const char* const kOthers[] = {"Pointer",  "Format", "Array", "Binding",   "Divisor", "Mask",    "Table",
                               "Fragment", "Func",   "Blend", "Parameter", "Weight",  "Stream",  "Attribs",
                               "ColorMaterial", "IndexMaterial", "Vertex3fSUN", "Vertex3fvSUN", "Vertex2fSUN",
                               "Vertex2fvSUN", "Vertex4fSUN", "Vertex4fvSUN"};

bool sets_an_attribute(const std::string& name) {
  bool begins = false;
  for (const char* beginning : kBeginnings) begins |= name.starts_with(beginning);
  for (const char* other : kOthers) begins &= name.find(other) == std::string::npos;
  return begins;
}

TEST(AttributeList, HasEveryCallThatTheRegistryHas) {
  ASSERT_GT(registry().commands.size(), 3000u) << "the registry " << TRUEQUAD_GL_XML << " was not read";
  for (const auto& [name, parameters] : registry().commands) {
    EXPECT_EQ(sets_an_attribute(name), rows().contains(name)) << name;
  }
  for (const auto& [name, row] : rows()) EXPECT_TRUE(registry().commands.contains(name)) << name;
}

TEST(AttributeList, FamilyIsTheBeginningOfTheName) {
  for (const auto& [name, row] : rows()) {
    std::string beginning;
    for (const char* candidate : kBeginnings) {
      if (beginning.empty() && name.starts_with(candidate)) beginning = std::string(candidate).substr(2);
    }
    // VertexAttrib has kinds: I, L and P follow in the name; else NV ends it (NV_vertex_program, NV_half_float).
    if (beginning == "VertexAttrib") {
      const char next = name[std::string("glVertexAttrib").size()];
      if (next == 'I' || next == 'L' || next == 'P') beginning += next;
      if (beginning == "VertexAttrib" && name.ends_with("NV")) beginning += "NV";
    }
    EXPECT_EQ(row.family, beginning) << name;
  }
}

// Parameters in front of the components.
int leading_parameters(const Row& row) {
  if (row.family == "Material") return 2;                                                  // face, pname
  int leading = row.family == "MultiTexCoord" || row.family.starts_with("VertexAttrib");  // unit or index
  if (row.type == "Packed") leading += row.family == "VertexAttribP" ? 2 : 1;              // type, normalized
  return leading;
}

TEST(AttributeList, ComponentsAreThoseOfTheDeclaration) {
  for (const auto& [name, row] : rows()) {
    const std::vector<Parameter>& parameters = registry().commands.at(name);
    const int leading = leading_parameters(row);
    ASSERT_GT(int(parameters.size()), leading) << name;
    const Parameter& first = parameters[leading];
    EXPECT_EQ(bool(row.vector), first.pointer) << name;
    if (row.type == "Packed") {
      EXPECT_EQ(first.type, "GLuint") << name;
      EXPECT_EQ(int(parameters.size()), leading + 1) << name;
      EXPECT_EQ(row.size, name[name.find("P", 2 + row.family.size() - (row.family == "VertexAttribP")) + 1] - '0')
          << name;
      continue;
    }
    EXPECT_EQ(row.type, first.type) << name;
    const int declared = int(parameters.size()) - leading;
    if (row.vector) {
      EXPECT_EQ(declared, 1) << name;
      if (row.family == "Material") {
        EXPECT_EQ(row.size, 0) << name;
      } else if (!first.length.empty()) {
        EXPECT_EQ(std::to_string(row.size), first.length) << name;
      }
    } else if (row.family == "Material") {
      EXPECT_EQ(row.size, 0) << name;
    } else if (row.family == "Vertex" && row.type == "GLfixed") {
      // The registry gives glVertex2xOES one coordinate, glVertex3xOES two and glVertex4xOES three, as the text of
      // OES_fixed_point did; their vector forms have as many as their names say.
      EXPECT_EQ(row.size, declared + 1) << name;
    } else {
      EXPECT_EQ(row.size, declared) << name;
    }
  }
}

// GL 2.1 table 2.4 and section 2.7: integers given as colours, secondary colours and normals mean -1…1 or 0…1, and so do
// VertexAttrib's with an N; every other integer is taken as it is.
TEST(AttributeList, IntegersAreNormalizedAsTheSpecSays) {
  for (const auto& [name, row] : rows()) {
    bool expected = name.find("Attrib4N") != std::string::npos || name.starts_with("glVertexAttrib4ubNV") ||
                    name.starts_with("glVertexAttrib4ubvNV");
    if (row.family == "Color" || row.family == "SecondaryColor" || row.family == "Normal") {
      expected = row.type != "GLfloat" && row.type != "GLdouble" && row.type != "GLhalfNV" && row.type != "GLfixed";
    }
    EXPECT_EQ(bool(row.normalized), expected) << name;
  }
}

// A row that needs no extension is desktop GL itself, or another name of such a command; else the extension has it.
TEST(AttributeList, RequirementsAreTheRegistrys) {
  std::set<std::string> core = registry().core;
  for (bool grown = true; grown;) {
    grown = false;
    for (const auto& [name, target] : registry().alias_of) {
      if (core.contains(name) != core.contains(target)) {
        core.insert(name);
        core.insert(target);
        grown = true;
      }
    }
  }
  for (const auto& [name, row] : rows()) {
    if (row.requirement == "Core") {
      EXPECT_TRUE(core.contains(name)) << name;
      continue;
    }
    // The fixed-point calls of OpenGL ES 1 have no suffix there; desktop GL has them with one.
    const bool listed = registry().extensions.contains(name);
    const auto found = registry().extensions.find(listed ? name : name + "OES");
    ASSERT_NE(found, registry().extensions.end()) << name;
    EXPECT_TRUE(found->second.contains("GL_" + row.requirement)) << name << ' ' << row.requirement;
  }
}

}  // namespace

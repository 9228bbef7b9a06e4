// Reads gl.xml with pugixml; the file's structure is described in the registry's "readme.pdf", sections 6 to 12.
#include "registry.h"

#include <algorithm>
#include <pugixml.hpp>
#include <set>

namespace truequad::generate {
namespace {

// All text below a node in document order; <apientry/> stands for the calling convention.
void append_text(const pugi::xml_node& node, std::string& out) {
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
      out += child.value();
    } else if (std::string(child.name()) == "apientry") {
      out += "GLAPIENTRY";
    } else {
      append_text(child, out);
    }
  }
}

std::string text_of(const pugi::xml_node& node) {
  std::string text;
  append_text(node, text);
  return text;
}

std::string trimmed(std::string text) {
  const auto first = text.find_first_not_of(" \n\t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \n\t") - first + 1);
}

// A parameter that has the name of a C++ keyword gets an underscore.
bool is_keyword(const std::string& name) {
  static const std::set<std::string> keywords = {"class", "default", "delete", "new",   "operator",
                                                 "this",  "template", "union", "export", "private"};
  return keywords.contains(name);
}

Command read_command(const pugi::xml_node& node) {
  Command command;
  const pugi::xml_node proto = node.child("proto");
  const std::string full = proto.child_value("name");
  command.name = full.substr(2);
  const std::string text = text_of(proto);
  command.result = trimmed(text.substr(0, text.rfind(full)));
  for (const pugi::xml_node& param : node.children("param")) {
    Parameter parameter{trimmed(text_of(param)), param.child_value("name")};
    if (is_keyword(parameter.name)) {
      parameter.declaration.insert(parameter.declaration.rfind(parameter.name) + parameter.name.size(), 1, '_');
      parameter.name += "_";
    }
    command.parameters.push_back(std::move(parameter));
  }
  return command;
}

std::string read_type(const pugi::xml_node& node) {
  if (std::string(node.attribute("name").value()) == "khrplatform") return "";
  std::string text = trimmed(text_of(node));
  if (text.starts_with("struct") && !text.ends_with(";")) text += ";";
  return text;
}

}  // namespace

Registry read_registry(const std::string& path, std::string& error) {
  Registry registry;
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_file(path.c_str(), pugi::parse_default | pugi::parse_ws_pcdata);
  if (!parsed) {
    error = path + ": " + parsed.description();
    return registry;
  }
  const pugi::xml_node root = document.child("registry");
  for (const pugi::xml_node& type : root.child("types").children("type")) {
    if (std::string text = read_type(type); !text.empty()) registry.types.push_back(std::move(text));
  }
  std::set<std::string> seen;
  for (const pugi::xml_node& group : root.children("enums")) {
    for (const pugi::xml_node& value : group.children("enum")) {
      const std::string name = value.attribute("name").value();
      if (seen.insert(name).second) registry.enums.push_back({name, value.attribute("value").value()});
    }
  }
  for (const pugi::xml_node& command : root.child("commands").children("command")) {
    if (seen.insert(command.child("proto").child_value("name")).second) {
      registry.commands.push_back(read_command(command));
    }
  }
  // Sorted, so that a name is found by halving.
  std::sort(registry.commands.begin(), registry.commands.end(),
            [](const Command& a, const Command& b) { return a.name < b.name; });
  if (registry.commands.empty()) error = path + ": has no commands";
  return registry;
}

}  // namespace truequad::generate

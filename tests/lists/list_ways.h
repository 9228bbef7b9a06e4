// What the ways of drawing scenes through lists are made of.
#pragma once

#include "ways.h"

namespace truequad::images {

void vertex(const Vertex& v);
void primitive(const Primitive& p);
void primitives(const Scene& scene);

// Another view without texture, which a list that is compiled in it must not keep.
void look_elsewhere();

// "type_NAME": glCallLists with names of every type.
void add_types(std::map<std::string, Way>& ways);

// For states of kChanges: "immediate_STATE" draws without lists in it, "before_STATE" compiles a list, sets the state and calls,
// "within_STATE" compiles in the state and calls after it is left.
void add_changes(std::map<std::string, Way>& ways);

}  // namespace truequad::images

// A GL that draws nothing: it logs its calls, keeps current values, knows what is an error inside and outside of
// Begin/End, and answers queries from a script. Values are computed here in the plainest way, not with the capture's
// own functions, so that the two can be compared.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "capture/rows.h"
#include "capture/slots.h"
#include "driver/driver.h"

namespace truequad::fake {

using Value = std::array<float, 4>;

// Places of current values: the capture's slots, and behind them the attributes of NV_vertex_program.
inline constexpr unsigned kNvAttributes = 64;
inline constexpr unsigned kPlaces = kNvAttributes + 32;
using Values = std::array<Value, kPlaces>;

struct Call {
  unsigned command;
  std::string arguments;  // bytes; pointers as what they point to, where that is known
  bool operator==(const Call&) const = default;
};

struct Primitive {
  GLenum mode;
  std::vector<Values> vertices;
  std::set<GLenum> enabled;  // at its glBegin
};

// What glPushAttrib keeps.
struct Attributes {
  Values current{};
  std::set<GLenum> enabled;
  std::map<unsigned, std::set<GLenum>> unit_enabled;
};

class Gl {
 public:
  Gl();

  // Script.
  std::string version = "2.1 fake";
  std::set<std::string> extensions;  // with GL_
  std::map<GLenum, std::vector<double>> numbers;  // answers of glGet*
  std::set<GLenum> enabled;                       // but those of texture units
  std::map<unsigned, std::set<GLenum>> unit_enabled;
  std::map<GLenum, GLint> queries;  // glGetQueryiv(CURRENT_QUERY)
  std::map<GLenum, const void*> pointers;  // glGetPointerv
  std::map<GLenum, std::map<GLenum, std::vector<float>>> lights;  // glGetLightfv
  unsigned units = 8;
  bool logging = true;  // off: nothing below is kept that would allocate

  // What happened.
  std::vector<Call> log;
  std::vector<Primitive> drawn;
  std::vector<GLenum> seen_errors;   // what glGetError answered
  std::vector<GLenum> all_errors;
  Values current{};
  std::size_t gets = 0;        // queries of any kind
  std::size_t get_errors = 0;  // calls of glGetError
  bool inside = false;
  std::vector<Attributes> attribute_stack;
  unsigned active_unit = 0;

  void error(GLenum code);
  bool extension(const char* name) const { return extensions.contains(std::string("GL_") + name); }
  int version_number() const { return (version[0] - '0') * 10 + (version[2] - '0'); }

  // For the functions in the table.
  void called(unsigned command, const void* arguments, std::size_t size);
  void set(unsigned place, const Value& value);
  void enable(GLenum name, bool on);
  // Material properties that have the current colour (GL 2.1 section 2.14.3).
  bool tracked(unsigned place) const;
  void vertex(const Value& position);
  GLenum flag = GL_NO_ERROR;

 private:
  friend struct Functions;
  GLenum mode_ = 0;
  std::vector<Values> vertices_;
};

// The table's functions act on this one.
Gl& gl();
void reset(Gl fresh = Gl());

// The fake driver; default_driver of the test programs is a copy of it.
const Driver& driver();

// Functions that do what the doors do: a program that calls them runs with truequad.
const Driver& doors();

// Makes a new context of gl() current, as a program would at its start. Forgets what earlier ones left in the thread.
void make_current();

// Calls the entry point of a row with reproducible arguments that depend on `seed`; `wild` allows bad enums and
// indices. `place` chooses texture unit or generic attribute.
void invoke(const Driver& table, RowId row, unsigned seed, unsigned place, bool wild);

}  // namespace truequad::fake

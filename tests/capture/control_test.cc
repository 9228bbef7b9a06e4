// The C control API on the fake driver: what is set holds for the thread's next primitives, what is refused changes nothing.
#include "truequad/control.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "program.h"

namespace truequad::fake {
namespace {

constexpr int kModes[] = {TRUEQUAD_MODE_BILINEAR, TRUEQUAD_MODE_PROJECTIVE, TRUEQUAD_MODE_AUTO, TRUEQUAD_MODE_PAPER,
                          TRUEQUAD_MODE_OFF};

void trapezoid(const Driver& gl, GLenum mode) {
  gl.Begin(mode);
  for (const int i : {0, 1, mode == GL_QUAD_STRIP ? 3 : 2, mode == GL_QUAD_STRIP ? 2 : 3}) kTrapezoid.vertex(gl, i);
  gl.End();
}

truequad_statistics statistics() {
  truequad_statistics all;
  EXPECT_EQ(truequad_read_statistics(&all, sizeof all), 1);
  return all;
}
std::uint64_t reason(const char* name) {
  std::uint64_t count = 0;
  EXPECT_EQ(truequad_read_pass_reason(name, &count), 1) << name;
  return count;
}
std::uint64_t triangles() { return statistics().triangles; }

class Control : public testing::Test {
 protected:
  void SetUp() override {
    reset(Gl());
    make_current();
    delete_thread_memory();
  }
  void TearDown() override {
    truequad_set_mode(TRUEQUAD_MODE_BILINEAR);
    truequad_set_tolerance(0.25);
    for (const GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) truequad_set_primitive(mode, 1);
  }
};

TEST_F(Control, HasAVersion) { EXPECT_EQ(truequad_control_version(), TRUEQUAD_CONTROL_VERSION); }

TEST_F(Control, GivesBackWhatWasSet) {
  for (const int mode : kModes) {
    EXPECT_EQ(truequad_set_mode(mode), 1);
    EXPECT_EQ(truequad_get_mode(), mode);
  }
  for (const double pixels : {0.25, 1e-300, 1e300, 3.0}) {
    EXPECT_EQ(truequad_set_tolerance(pixels), 1);
    EXPECT_EQ(truequad_get_tolerance(), pixels);
  }
  for (const GLenum off : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    EXPECT_EQ(truequad_set_primitive(off, 0), 1);
    for (const GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) EXPECT_EQ(truequad_get_primitive(mode), mode != off);
    EXPECT_EQ(truequad_set_primitive(off, 1), 1);
  }
}

TEST_F(Control, RefusesWhatIsNotAllowedAndChangesNothing) {
  truequad_set_mode(TRUEQUAD_MODE_AUTO);
  truequad_set_tolerance(2);
  truequad_set_primitive(GL_QUAD_STRIP, 0);
  constexpr int kLeast = std::numeric_limits<int>::min(), kMost = std::numeric_limits<int>::max();
  for (const int mode : {-1, 5, kLeast, kMost}) EXPECT_EQ(truequad_set_mode(mode), 0) << mode;
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double pixels : {0.0, -0.0, -1.0, infinity, -infinity, std::nan("")}) {
    EXPECT_EQ(truequad_set_tolerance(pixels), 0) << pixels;
  }
  for (const unsigned primitive : {unsigned(GL_TRIANGLES), unsigned(GL_POINTS), 10u, 15u, 16u, 32u + GL_QUADS, ~0u}) {
    EXPECT_EQ(truequad_set_primitive(primitive, 0), 0) << primitive;
    EXPECT_EQ(truequad_get_primitive(primitive), -1) << primitive;
  }
  for (const int on : {-1, 2, kLeast, kMost}) EXPECT_EQ(truequad_set_primitive(GL_QUADS, on), 0) << on;
  EXPECT_EQ(truequad_get_mode(), TRUEQUAD_MODE_AUTO);
  EXPECT_EQ(truequad_get_tolerance(), 2);
  EXPECT_EQ(truequad_get_primitive(GL_QUADS), 1);
  EXPECT_EQ(truequad_get_primitive(GL_QUAD_STRIP), 0);
  EXPECT_EQ(truequad_get_primitive(GL_POLYGON), 1);

  EXPECT_EQ(truequad_read_statistics(nullptr, sizeof(truequad_statistics)), 0);
  truequad_statistics untouched;
  untouched.quads = 77;
  EXPECT_EQ(truequad_read_statistics(&untouched, 0), 0);
  std::uint64_t count = 77;
  for (const char* name : {"", "no_such_reason", "affin", "affine "}) {
    EXPECT_EQ(truequad_read_pass_reason(name, &count), 0) << name;
  }
  EXPECT_EQ(truequad_read_pass_reason(nullptr, &count), 0);
  EXPECT_EQ(truequad_read_pass_reason("affine", nullptr), 0);
  EXPECT_EQ(count, 77u);
  EXPECT_EQ(untouched.quads, 77u);
}

TEST_F(Control, MakesNoCallOfGl) {
  gl().log.clear();
  truequad_set_mode(TRUEQUAD_MODE_PAPER);
  truequad_set_tolerance(1);
  truequad_set_primitive(GL_QUADS, 0);
  statistics();
  reason("affine");
  EXPECT_TRUE(gl().log.empty());
}

TEST_F(Control, ModeTakesEffectAtTheNextBegin) {
  for (const GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    SCOPED_TRACE(mode);
    const auto draw = [&] { trapezoid(doors(), mode); };
    ASSERT_EQ(growth(corrected, draw), 1u);
    truequad_set_mode(TRUEQUAD_MODE_OFF);
    const std::uint64_t off = reason("mode_off");
    EXPECT_EQ(growth(corrected, draw), 0u);
    EXPECT_EQ(reason("mode_off"), off + 1);
    truequad_set_mode(TRUEQUAD_MODE_PROJECTIVE);
    EXPECT_EQ(growth(triangles, draw), 2u);  // the exact map of a planar quad
    truequad_set_mode(TRUEQUAD_MODE_BILINEAR);
    EXPECT_GT(growth(triangles, draw), 2u);
  }
}

TEST_F(Control, ASettingBetweenBeginAndEndWaits) {
  const auto draw = [](int mode) {
    doors().Begin(GL_QUADS);
    kTrapezoid.draw(doors());
    truequad_set_mode(mode);
    EXPECT_EQ(truequad_get_mode(), mode);
    kTrapezoid.draw(doors());
    doors().End();
  };
  EXPECT_EQ(growth(corrected, [&] { draw(TRUEQUAD_MODE_OFF); }), 2u);
  EXPECT_EQ(growth(corrected, [&] { draw(TRUEQUAD_MODE_BILINEAR); }), 0u);
  EXPECT_EQ(growth(corrected, [&] { draw(TRUEQUAD_MODE_BILINEAR); }), 2u);
}

TEST_F(Control, TolerancesOrderTheCosts) {
  std::uint64_t last = 0;
  for (const double pixels : {8.0, 1.0, 0.25, 0.05}) {
    truequad_set_tolerance(pixels);
    make_current();
    delete_thread_memory();
    const std::uint64_t now = growth(triangles, [] { trapezoid(doors(), GL_QUADS); });
    EXPECT_GT(now, last) << pixels;
    last = now;
  }
}

// What is off reaches the driver as it was called.
TEST_F(Control, PrimitivesAreSwitchedOneByOne) {
  for (const GLenum off : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    truequad_set_primitive(off, 0);
    for (const GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
      SCOPED_TRACE(testing::Message() << off << " off, drawn " << mode);
      const std::uint64_t before = reason("primitive_off");
      EXPECT_EQ(growth(corrected, [&] { trapezoid(doors(), mode); }), mode == off ? 0u : 1u);
      EXPECT_EQ(reason("primitive_off"), before + (mode == off));
    }
    const Program program = [&](const Driver& gl) { trapezoid(gl, off); };
    EXPECT_EQ(through_doors(program).log, natively(program).log);
    make_current();
    truequad_set_primitive(off, 1);
  }
}

TEST_F(Control, ACalledListIsDrawnByTheSettingsOfTheCall) {
  doors().NewList(7, GL_COMPILE);
  trapezoid(doors(), GL_QUADS);
  truequad_set_mode(TRUEQUAD_MODE_OFF);
  doors().EndList();
  const auto call = [] { doors().CallList(7); };
  EXPECT_EQ(growth(corrected, call), 0u);
  truequad_set_mode(TRUEQUAD_MODE_BILINEAR);
  EXPECT_EQ(growth(corrected, call), 1u);
  truequad_set_primitive(GL_QUADS, 0);
  EXPECT_EQ(growth(corrected, call), 0u);
  // Compiled while its quads are off: the driver's own.
  doors().NewList(7, GL_COMPILE);
  trapezoid(doors(), GL_QUADS);
  doors().EndList();
  truequad_set_primitive(GL_QUADS, 1);
  EXPECT_EQ(growth(corrected, call), 0u);
}

TEST_F(Control, EachThreadHasItsOwn) {
  truequad_set_mode(TRUEQUAD_MODE_OFF);
  truequad_set_tolerance(3);
  truequad_set_primitive(GL_QUADS, 0);
  const std::uint64_t before = statistics().corrected;
  std::thread([&] {
    // The environment's, whatever another thread has set.
    EXPECT_EQ(truequad_get_mode(), TRUEQUAD_MODE_BILINEAR);
    EXPECT_EQ(truequad_get_tolerance(), 0.25);
    EXPECT_EQ(truequad_get_primitive(GL_QUADS), 1);
    make_current();
    trapezoid(doors(), GL_QUADS);
    truequad_set_mode(TRUEQUAD_MODE_PAPER);
    EXPECT_EQ(statistics().corrected, before + 1);
    context_made_current(entry, nullptr, nullptr);
  }).join();
  // Its counts stay.
  EXPECT_EQ(statistics().corrected, before + 1);
  EXPECT_EQ(truequad_get_mode(), TRUEQUAD_MODE_OFF);
  make_current();
  EXPECT_EQ(growth(corrected, [] { trapezoid(doors(), GL_QUADS); }), 0u);
}

TEST_F(Control, StatisticsAgreeWithTheCounters) {
  const truequad_statistics before = statistics();
  doors().Begin(GL_QUADS);
  kTrapezoid.draw(doors());
  kSquare.draw(doors());
  doors().End();
  const truequad_statistics after = statistics();
  EXPECT_EQ(after.quads - before.quads, 2u);
  EXPECT_EQ(after.passed - before.passed, 1u);
  EXPECT_EQ(after.corrected - before.corrected, 1u);
  EXPECT_GT(after.triangles - before.triangles, 4u);
  EXPECT_GT(after.bound_px_max, 0);
  for (const std::string_view name : kReasonNames) {
    EXPECT_LE(reason(std::string(name).c_str()), after.passed) << name;
  }
}

// A program compiled with a shorter or a longer structure.
TEST_F(Control, StatisticsKeepToTheSizeThatIsGiven) {
  trapezoid(doors(), GL_QUADS);
  const truequad_statistics all = statistics();
  ASSERT_GT(all.passed + all.corrected, 0u);
  struct {
    truequad_statistics known;
    std::uint64_t later[3];
  } room;
  constexpr unsigned char kMark = 0xA5;
  for (std::size_t size = 1; size <= sizeof room; ++size) {
    std::memset(static_cast<void*>(&room), kMark, sizeof room);
    ASSERT_EQ(truequad_read_statistics(&room.known, size), 1);
    const auto* bytes = reinterpret_cast<const unsigned char*>(&room);
    const std::size_t filled = std::min(size, sizeof all);
    ASSERT_EQ(std::memcmp(bytes, &all, filled), 0) << size;
    for (std::size_t i = filled; i < size; ++i) ASSERT_EQ(bytes[i], 0) << size << " " << i;
    for (std::size_t i = size; i < sizeof room; ++i) ASSERT_EQ(bytes[i], kMark) << size << " " << i;
  }
}

}  // namespace
}  // namespace truequad::fake

// From a trial's number to its sequence: primitives, lists, arrays and state as programs write them, and now and then
// any call at any place.
#include "ops.h"
#include "random.h"
#include "driver/driver.h"

namespace truequad::fuzz {
namespace {

constexpr int kWeights[] = {
#define X(name, weight) weight,
    TQ_STEPS(X)
#undef X
};

class Generator {
 public:
  Generator(std::uint64_t trial, Kind kind) : random_(trial * 0x2545f4914f6cdd1du + 77), kind_(kind) {}

  Sequence make() {
    // Some sequences are of plain calls, some leave out what others are full of, so that what is left meets oftener.
    wild_ = kind_ == Kind::kCovered ? 0 : random_.of({0, 0, 1, 4, 10});
    arrays_ = random_.chance(40);
    various_ = random_.chance(50);
    // In Mesa, calls of a family that grow and shrink again in one primitive leave the longer one's components to the
    // shorter, and a quad that is cut is a primitive of its own: a sequence keeps to one size.
    sizes_ = unsigned(random_.below(3)) * kSize;
    if (kind_ == Kind::kCovered) add(Step::kCover, random_.chance(50));
    const int steps = 3 + random_.below(28);
    for (int i = 0; i < steps && sequence_.size() < 400; ++i) any();
    return std::move(sequence_);
  }

 private:
  void add(Step step, int index = 0, unsigned shape = 0, unsigned warp = 0) {
    sequence_.push_back({step, std::uint16_t(warp | sizes_), index, shape, random_.next()});
  }

  unsigned warp() {
    if (kind_ == Kind::kAffine || random_.chance(35)) return kFlat;
    if (kind_ == Kind::kCovered) return kWarpTexture;
    return unsigned(random_.of({kWarpPosition, kWarpTexture, kWarpTexture, kWarpDepth}));
  }

  void stray() { add(random_step()); }

  Step random_step() {
    // Those behind the lock of arrays are of no use where only flat quads are drawn.
    const unsigned count = kind_ == Kind::kCovered ? unsigned(Step::kDrawIndirect) : unsigned(Step::kCount);
    int total = 0;
    for (unsigned i = 0; i < count; ++i) total += kWeights[i];
    int at = random_.below(total);
    for (unsigned i = 0;; ++i) {
      if ((at -= kWeights[i]) < 0) return Step(i);
    }
  }

  bool allowed(Step step) {
    switch (step) {
      case Step::kPointer: case Step::kClientState: case Step::kDrawArrays: case Step::kDrawElements:
      case Step::kArrayElement: case Step::kInterleaved: case Step::kBuffer: case Step::kMapBuffer:
      case Step::kVertexArray: case Step::kRestart: case Step::kLockArrays: case Step::kDrawIndirect:
      case Step::kFarIndices: case Step::kNowhere:
        return arrays_ && kind_ != Kind::kCovered;
      case Step::kCallList: case Step::kCallLists: case Step::kDeleteLists: case Step::kGenLists: case Step::kListBase:
      case Step::kErrors: case Step::kGet: case Step::kDigest: case Step::kAttribute: return true;
      case Step::kBegin: case Step::kEnd: case Step::kVertex: case Step::kTexCoord: case Step::kNewList: case Step::kEndList:
        return wild_ > 0;
      default: return kind_ != Kind::kCovered;
    }
  }

  void any() {
    if (random_.below(100) < wild_) return stray();
    const int choice = random_.below(100);
    if (choice < 38) return primitive();
    if (choice < 52 && depth_ < 2) return list();
    if (choice < 60 && arrays_ && kind_ != Kind::kCovered) return arrays();
    for (int i = 0; i < 20; ++i) {
      const Step step = random_step();
      // Mesa knows the current values that a list sets as it is executed some calls later.
      if (depth_ > 0 && step == Step::kDigest) continue;
      if (allowed(step)) return add(step, depth_ > 0, 0, step == Step::kNest ? warp() : 0u);
    }
  }

  void list() {
    ++depth_;
    const int name = random_.below(6);
    add(Step::kNewList, name, 0, unsigned(random_.chance(30)));
    const int steps = random_.below(7);
    if (random_.chance(12)) vertices_only();
    else for (int i = 0; i < steps; ++i) any();
    --depth_;
    add(Step::kEndList);
    if (random_.chance(70)) add(Step::kCallList, name + 1);
  }

  // What a list may have that is called between glBegin and glEnd.
  void vertices_only() {
    const unsigned shape = unsigned(random_.next());
    const unsigned kind = warp();
    const int from = random_.below(4), count = 1 + random_.below(6);
    for (int i = 0; i < count; ++i) vertex(GL_QUADS, shape, from + i, kind);
  }

  void vertex(GLenum mode, unsigned shape, int i, unsigned warp) {
    // What is first set in the midst of a primitive that is compiled Mesa's lists lose, or give to other vertices.
    const unsigned kind = warp | (mode == GL_QUAD_STRIP ? kStrip : 0u) | (various_ ? kVarious : 0u) | (depth_ > 0 ? kOneSlot : 0u) |
                          (kind_ == Kind::kCovered ? kExact : 0u);
    if (!random_.chance(skip_texture_)) add(Step::kTexCoord, i, shape, kind);
    if (depth_ > 0 && coloured_) add(Step::kAttribute, 0, 0, kOneSlot);
    if (depth_ == 0 && various_ && kind_ != Kind::kCovered && random_.chance(30)) add(random_.chance(85) ? Step::kAttribute : Step::kMaterial);
    add(Step::kVertex, i, shape, kind);
  }

  void primitive() {
    GLenum mode = random_.of<GLenum>({GL_QUADS, GL_QUADS, GL_QUADS, GL_QUADS, GL_QUAD_STRIP, GL_QUAD_STRIP, GL_POLYGON, GL_POLYGON,
                              GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_LINES, GL_POINTS});
    if (depth_ == 0 && random_.chance(wild_)) mode = GLenum(random_.below(16));
    if (kind_ == Kind::kCovered && mode <= GL_LINE_STRIP) mode = GL_QUADS;
    skip_texture_ = kind_ == Kind::kCovered ? 0 : random_.of({0, 0, 0, 100, kind_ == Kind::kBent ? 30 : 0});
    // It even crashes at glEndList if a list was called before.
    if (depth_ > 0 && skip_texture_ < 100) skip_texture_ = 0;
    coloured_ = kind_ != Kind::kCovered && random_.chance(30);
    add(Step::kBegin, int(mode));
    int count = 4 * (1 + random_.below(3));
    if (mode == GL_QUAD_STRIP) count = 2 + 2 * random_.below(5);
    if (mode == GL_POLYGON) count = random_.chance(75) ? 4 : 1 + random_.below(7);
    // What is set in a primitive of a list whose last vertices draw nothing Mesa loses, or gives memory that was never written.
    if (depth_ > 0) {
      if (mode == GL_QUAD_STRIP || mode == GL_POLYGON) count = count < 4 ? 4 : count;
      else if (mode != GL_QUADS) count = 12;
    } else if (random_.chance(8)) {
      count = random_.below(count + 2);
    }
    unsigned shape = 0, kind = 0;
    for (int i = 0; i < count; ++i) {
      if (i == 0 || (i % 4 == 0 && mode != GL_QUAD_STRIP && mode != GL_POLYGON)) shape = unsigned(random_.next());
      if (i % 4 == 0) kind = warp();
      // Mesa crashes at glEndList after a call that is no attribute in a primitive that is compiled.
      if (depth_ == 0 && random_.below(200) < wild_) stray();
      if (depth_ == 0 && wild_ > 0 && random_.chance(2)) add(Step::kCallList, random_.below(7));
      vertex(mode, shape, i, kind);
    }
    if (various_ && depth_ == 0 && kind_ != Kind::kCovered && random_.chance(20)) add(Step::kAttribute);
    if (depth_ > 0 || random_.below(300) >= wild_) add(Step::kEnd);
  }

  void arrays() {
    const int pointers = 1 + random_.below(3);
    if (random_.chance(30)) add(Step::kBuffer);
    for (int i = 0; i < pointers; ++i) add(Step::kPointer, i == 0 ? 0 : -1, 0, 1);
    const int draws = 1 + random_.below(3);
    for (int i = 0; i < draws; ++i) add(random_.chance(50) ? Step::kDrawArrays : Step::kDrawElements, depth_ > 0);
  }

  Random random_;
  Kind kind_;
  Sequence sequence_;
  int wild_ = 0, depth_ = 0, skip_texture_ = 0;
  bool arrays_ = false, various_ = false, coloured_ = false;
  unsigned sizes_ = 0;
};

}  // namespace

Sequence generate(std::uint64_t trial, Kind kind) { return Generator(trial, kind).make(); }

}  // namespace truequad::fuzz

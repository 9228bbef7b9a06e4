// Queries, selection and feedback, evaluators, rectangles, pixels, programs, contexts.
#include "execute.h"

namespace truequad::fuzz {

float feedback_buffer[256];
GLuint selection_buffer[64];

namespace {

void get(Random& random, bool in_list) {
  static GLdouble doubles[16];
  static GLint ints[16];
  static GLboolean booleans[16];
  for (int i = 0; i < 16; ++i) doubles[i] = -77, ints[i] = -77, booleans[i] = 77;
  const GLenum what = in_list ? pick(random, GL_LIST_INDEX, GL_LIST_MODE, GL_LIST_BASE, GL_RENDER_MODE, GL_MAX_LIST_NESTING) : pick(random, GL_LIST_INDEX, GL_LIST_MODE, GL_LIST_BASE, GL_CURRENT_COLOR, GL_CURRENT_TEXTURE_COORDS, GL_CURRENT_NORMAL,
                           GL_MODELVIEW_MATRIX, GL_MODELVIEW_STACK_DEPTH, GL_TEXTURE_2D, GL_RENDER_MODE, GL_MAX_LIST_NESTING,
                           GL_CURRENT_SECONDARY_COLOR, GL_EDGE_FLAG, GL_CURRENT_INDEX, GL_ATTRIB_STACK_DEPTH, GL_FEEDBACK_BUFFER_SIZE);
  switch (random.below(3)) {
    case 0: GL(GetDoublev, what, doubles); break;
    case 1: GL(GetIntegerv, what, ints); break;
    default: GL(GetBooleanv, what, booleans);
  }
  record("Get %x: %.9g %.9g %.9g %.9g, %d %d %d %d, %d", what, doubles[0], doubles[1], doubles[2], doubles[3], ints[0], ints[1],
         ints[2], ints[3], booleans[0]);
}

void render_mode(Random& random) {
  switch (random.below(4)) {
    case 0: return GL(FeedbackBuffer, random.of({256, 16, 0, -1}), pick(random, GL_2D, GL_3D, GL_3D_COLOR_TEXTURE, GL_4D_COLOR_TEXTURE), feedback_buffer);
    case 1: return GL(SelectBuffer, random.of({64, 4, 0}), selection_buffer);
    case 2: record("RenderMode: %d", GL(RenderMode, pick(random, GL_RENDER))); return;
    default: record("RenderMode: %d", GL(RenderMode, pick(random, GL_RENDER, GL_SELECT, GL_FEEDBACK))); return;
  }
}

void names(Random& random) {
  switch (random.below(5)) {
    case 0: return GL(InitNames);
    case 1: return GL(PushName, GLuint(random.below(5)));
    case 2: return GL(LoadName, GLuint(random.below(5)));
    case 3: return GL(PopName);
    default: return GL(PassThrough, float(random.below(5)));
  }
}

void evaluator(Random& random) {
  static const GLfloat points[4 * 3] = {2, 2, 0, 20, 2, 0, 2, 20, 0, 20, 20, 0};
  static const GLfloat textures[4 * 2] = {0, 0, 8, 0, 0, 8, 8, 8};
  switch (random.below(8)) {
    case 0: return GL(Map2f, GL_MAP2_VERTEX_3, 0.0f, 1.0f, 3, 2, 0.0f, 1.0f, 6, random.of({2, 2, 0}), points);
    case 1: return GL(Map2f, GL_MAP2_TEXTURE_COORD_2, 0.0f, 1.0f, 2, 2, 0.0f, 1.0f, 4, 2, textures);
    case 2: return GL(Map1f, GL_MAP1_VERTEX_3, 0.0f, 1.0f, 3, 4, points);
    case 3: return GL(MapGrid2f, random.of({2, 1, 0}), 0.0f, 1.0f, 2, 0.0f, 1.0f);
    case 4: return GL(EvalMesh2, pick(random, GL_FILL, GL_LINE, GL_POINT), 0, 2, 0, 2);
    case 5: return GL(EvalCoord2f, float(random.below(2)), float(random.below(2)));
    case 6: return GL(EvalPoint2, random.below(3), random.below(3));
    default: return GL(EvalCoord1f, float(random.real(0, 1)));
  }
}

void rectangle(Random& random) {
  const int x = random.below(20), y = random.below(20), z = x + 2 + random.below(9), w = y + 2 + random.below(9);
  static GLint low[2], high[2];
  switch (random.below(4)) {
    case 0: return GL(Rectf, float(x), float(y), float(z), float(w));
    case 1: return GL(Recti, x, y, z, w);
    case 2: low[0] = x, low[1] = y, high[0] = z, high[1] = w; return GL(Rectiv, low, high);
    default: return GL(Rectd, double(z), double(y), double(x), double(w));
  }
}

void pixels(Random& random, Player& player) {
  static const GLubyte bitmap[8] = {0xaa, 0x55, 0xff, 0x81, 0xaa, 0x55, 0xff, 0x81};
  const int what = random.below(4);
  // The raster position takes the current values with it.
  if (what == 0 || what == 3) settle_values(player);
  switch (what) {
    case 0: return GL(RasterPos2f, float(random.below(30)), float(random.below(30)));
    case 1: return GL(Bitmap, 8, 2, 0.0f, 0.0f, 4.0f, 1.0f, bitmap);
    case 2: return GL(CopyPixels, 0, 0, 4, 4, pick(random, GL_COLOR, GL_DEPTH));
    default: return GL(WindowPos2i, random.below(30), random.below(30));
  }
}

void query(Random& random) {
  static GLuint result;
  const GLenum target = pick(random, GL_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED);
  switch (random.below(4)) {
    case 0: case 1: return GL(BeginQuery, target, GLuint(1 + random.below(2)));
    case 2: return GL(EndQuery, target);
    default:
      result = 77;
      GL(GetQueryObjectuiv, GLuint(1 + random.below(2)), GL_QUERY_RESULT, &result);
      record("query: %u", result);
  }
}

void program(Random& random, Player& player) {
  switch (random.below(4)) {
    case 0:
      player.programs = true;
      return GL(Enable, pick(random, GL_VERTEX_PROGRAM_ARB, GL_FRAGMENT_PROGRAM_ARB));
    case 1: case 2: return GL(Disable, pick(random, GL_VERTEX_PROGRAM_ARB, GL_FRAGMENT_PROGRAM_ARB));
    default: return GL(UseProgram, GLuint(random.chance(70) ? 0 : 9));
  }
}

}  // namespace

void execute_other(const Op& op, Player& player) {
  Random random(op.seed);
  switch (op.step) {
    case Step::kErrors: return record_errors();
    case Step::kDigest: return record_state();
    case Step::kGet: return get(random, op.index != 0);
    case Step::kRenderMode: return render_mode(random);
    case Step::kNames: return names(random);
    case Step::kEvaluator: return evaluator(random);
    case Step::kRect:
      settle_values(player);
      return rectangle(random);
    case Step::kClear: return GL(Clear, random.of<GLbitfield>({GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT,
                                                              GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, 0x10}));
    case Step::kPixels: return pixels(random, player);
    case Step::kQuery: return query(random);
    case Step::kProgram: return program(random, player);
    default:
      // Another context would see the first part of a list that is split before it is ended.
      if (player.listing) return;
      player.context ^= 1;
      make_current(player.context);
  }
}

}  // namespace truequad::fuzz

// Matrices, enables, texture, lighting, rasterisation, attribute stacks.
#include "execute.h"

namespace truequad::fuzz {
namespace {

void matrix(Random& random) {
  switch (random.below(12)) {
    case 0: return GL(MatrixMode, pick(random, GL_MODELVIEW, GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE));
    case 1: return GL(PushMatrix);
    case 2: case 3: return GL(PopMatrix);
    case 4: return GL(Translatef, float(random.below(5) - 2), float(random.below(5) - 2), 0.0f);
    case 5: return GL(Rotatef, float(random.of({5, -5, 90})), 0.0f, 0.0f, 1.0f);
    case 6: return GL(Scaled, random.of({1.0, 0.5, 1.25}), random.of({1.0, 0.75}), 1.0);
    case 7: {
      static const GLfloat m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5f, 0.25f, 0, 1};
      return GL(MultMatrixf, m);
    }
    case 8: {
      static const GLfloat m[16] = {1, 0, 0, 0.002f, 0, 1, 0, 0.004f, 0, 0, 1, 0, 0, 0, 0, 1};
      return GL(MultMatrixf, m);
    }
    case 9: return random.chance(20) ? GL(LoadIdentity) : GL(PushMatrix);
    case 10: return GL(ActiveTexture, GL_TEXTURE0 + GLuint(random.chance(5) ? 77 : random.below(kUnits)));
    default: return GL(MatrixMode, pick(random, GL_MODELVIEW));
  }
}

void enable(Random& random) {
  const GLenum what = pick(random, GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D, GL_LIGHTING, GL_LIGHT0, GL_LIGHT1,
                           GL_COLOR_MATERIAL, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_Q, GL_FOG, GL_BLEND, GL_DEPTH_TEST,
                           GL_STENCIL_TEST, GL_ALPHA_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_NORMALIZE, GL_POLYGON_OFFSET_FILL,
                           GL_POLYGON_STIPPLE, GL_POLYGON_SMOOTH, GL_COLOR_SUM, GL_COLOR_LOGIC_OP, GL_CLIP_PLANE0, GL_AUTO_NORMAL,
                           GL_MAP2_VERTEX_3, GL_MAP1_VERTEX_3, GL_MAP2_TEXTURE_COORD_2, GL_DITHER, GL_RESCALE_NORMAL, GL_LINE_SMOOTH,
                           GL_VERTEX_PROGRAM_TWO_SIDE, GL_RASTERIZER_DISCARD);
  if (random.chance(what == GL_TEXTURE_2D ? 70 : 50)) GL(Enable, what);
  else GL(Disable, what);
}

void texture_generation(Random& random) {
  const GLenum coordinate = pick(random, GL_S, GL_T, GL_R, GL_Q);
  static const GLfloat plane[4] = {0.5f, 0.25f, 0, 1};
  if (random.chance(30)) return GL(TexGenfv, coordinate, pick(random, GL_OBJECT_PLANE, GL_EYE_PLANE), plane);
  GL(TexGeni, coordinate, GL_TEXTURE_GEN_MODE, GLint(pick(random, GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP)));
}

void texture(Random& random) {
  switch (random.below(4)) {
    case 0: return GL(BindTexture, pick(random, GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_1D), GLuint(random.below(4)));
    case 1: return GL(TexEnvi, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GLint(pick(random, GL_MODULATE, GL_REPLACE, GL_DECAL, GL_ADD)));
    case 2: return GL(TexParameteri, GL_TEXTURE_2D, pick(random, GL_TEXTURE_WRAP_S, GL_TEXTURE_MIN_FILTER),
                      GLint(pick(random, GL_REPEAT, GL_CLAMP, GL_NEAREST, GL_LINEAR)));
    default: return GL(ActiveTexture, GL_TEXTURE0 + GLuint(random.below(kUnits)));
  }
}

void lighting(Random& random) {
  static GLfloat four[4];
  for (GLfloat& x : four) x = float(random.real(0, 1));
  switch (random.below(5)) {
    case 0: return GL(Lightfv, GL_LIGHT0 + GLuint(random.below(2)), pick(random, GL_POSITION, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT), four);
    case 1: return GL(LightModeli, pick(random, GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHT_MODEL_LOCAL_VIEWER), random.below(2));
    case 2: return GL(LightModeli, GL_LIGHT_MODEL_COLOR_CONTROL, GLint(pick(random, GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR)));
    case 3: return GL(ColorMaterial, pick(random, GL_FRONT_AND_BACK, GL_FRONT), pick(random, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_EMISSION));
    default: return GL(Lightf, GL_LIGHT0, pick(random, GL_SPOT_CUTOFF, GL_LINEAR_ATTENUATION), random.of({180.0f, 30.0f, 0.5f, -1.0f}));
  }
}

void raster(Random& random, const Player& player) {
  const auto compare = [&] { return pick(random, GL_LESS, GL_LEQUAL, GL_EQUAL, GL_ALWAYS, GL_NEVER, GL_GREATER, GL_NOTEQUAL); };
  const auto side = [&] { return pick(random, GL_FRONT, GL_BACK, GL_FRONT_AND_BACK); };
  const auto operation = [&] { return pick(random, GL_KEEP, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_ZERO); };
  switch (random.below(20)) {
    case 0: case 1: {
      // In Mesa this is called before the rest of a primitive that is executed in pieces (README.md).
      const GLenum model = pick(random, GL_FLAT, GL_SMOOTH);
      if (!(player.compiled && player.executed && player.colours_grew)) GL(ShadeModel, model);
      return;
    }
    case 2: return GL(PolygonMode, side(), pick(random, GL_FILL, GL_LINE, GL_POINT));
    case 3: return GL(PolygonMode, GL_FRONT_AND_BACK, GL_FILL);
    case 4: return GL(DepthFunc, compare());
    case 5: return GL(DepthMask, GLboolean(random.chance(80)));
    case 6: return GL(StencilFunc, compare(), random.below(4), 255u);
    case 7: return GL(StencilOp, operation(), operation(), operation());
    case 8: return GL(StencilOpSeparate, side(), operation(), operation(), operation());
    case 9: return GL(BlendFunc, pick(random, GL_ONE, GL_SRC_ALPHA), pick(random, GL_ZERO, GL_ONE, GL_ONE_MINUS_SRC_ALPHA));
    case 10: {
      const bool all = random.chance(60);
      return GL(ColorMask, GLboolean(all), GLboolean(1), GLboolean(1), GLboolean(all));
    }
    case 11: return GL(CullFace, side());
    case 12: return GL(FrontFace, pick(random, GL_CW, GL_CCW));
    case 13: return GL(AlphaFunc, compare(), 0.5f);
    case 14: return GL(Scissor, random.below(9), random.below(9), random.chance(3) ? -1 : 16 + random.below(16), 28);
    case 15: return GL(Viewport, random.below(3), 0, random.chance(3) ? -1 : random.of({kCanvas, kCanvas, kCanvas, 20, 0}), kCanvas);
    case 16: return GL(ProvokingVertex, pick(random, GL_FIRST_VERTEX_CONVENTION, GL_LAST_VERTEX_CONVENTION));
    case 17: return GL(Fogi, GL_FOG_MODE, GLint(pick(random, GL_LINEAR, GL_EXP)));
    case 18: return GL(ClampColor, pick(random, GL_CLAMP_VERTEX_COLOR, GL_CLAMP_FRAGMENT_COLOR), pick(random, GL_TRUE, GL_FALSE, GL_FIXED_ONLY));
    default: return GL(LineWidth, random.of({1.0f, 2.0f, 0.0f}));
  }
}

// Softpipe walks along edges in single precision: whether a pixel whose centre is on an edge belongs to a triangle depends on
// the third corner as well. By so much of a pixel no edge or diagonal of a shape comes nearer than 0.0007 px to a centre.
void cover(bool count) {
  GL(MatrixMode, GL_PROJECTION);
  GL(Translated, 64 / 512.0, 31 / 512.0, 0.0);
  GL(MatrixMode, GL_MODELVIEW);
  if (!count) return;
  GL(Enable, GL_STENCIL_TEST);
  GL(StencilFunc, GL_ALWAYS, 0, 255u);
  GL(StencilOp, GL_KEEP, GL_KEEP, GL_INCR);
}

GLbitfield attribute_bits(Random& random) {
  if (random.chance(30)) return GL_ALL_ATTRIB_BITS;
  return random.of<GLbitfield>({GL_CURRENT_BIT, GL_CURRENT_BIT, GL_ENABLE_BIT, GL_LIGHTING_BIT, GL_TEXTURE_BIT, GL_LIST_BIT,
                                GL_POLYGON_BIT, GL_TRANSFORM_BIT, GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_COLOR_BUFFER_BIT, 0});
}

}  // namespace

void execute_state(const Op& op, Player& player) {
  Random random(op.seed);
  switch (op.step) {
    case Step::kMatrix: return matrix(random);
    case Step::kEnable: return enable(random);
    case Step::kTexGen: return texture_generation(random);
    case Step::kTexture: return texture(random);
    case Step::kLighting: return lighting(random);
    case Step::kRaster: return raster(random, player);
    case Step::kCover: return cover(op.index != 0);
    case Step::kPushAttrib: return random.chance(75) ? GL(PushAttrib, attribute_bits(random)) : GL(PushClientAttrib, GL_ALL_ATTRIB_BITS);
    default: return random.chance(75) ? GL(PopAttrib) : GL(PopClientAttrib);
  }
}

}  // namespace truequad::fuzz

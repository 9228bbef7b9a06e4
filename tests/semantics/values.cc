#include "values.h"

namespace truequad::semantics {
namespace {

template <typename... Names>
void append(std::vector<GLfloat>& values, int size, Names... names) {
  for (const GLenum name : {GLenum(names)...}) {
    GLfloat value[16] = {};
    glGetFloatv(name, value);
    values.insert(values.end(), value, value + size);
  }
}

}  // namespace

std::vector<GLfloat> current_values() {
  std::vector<GLfloat> values;
  append(values, 4, GL_CURRENT_COLOR, GL_CURRENT_SECONDARY_COLOR, GL_CURRENT_RASTER_COLOR,
         GL_CURRENT_RASTER_POSITION, GL_CURRENT_RASTER_SECONDARY_COLOR);
  append(values, 3, GL_CURRENT_NORMAL);
  append(values, 1, GL_CURRENT_FOG_COORD, GL_CURRENT_INDEX, GL_EDGE_FLAG, GL_CURRENT_RASTER_DISTANCE,
         GL_CURRENT_RASTER_POSITION_VALID);
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (GLenum unit = 0; unit < 8; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    append(values, 4, GL_CURRENT_TEXTURE_COORDS, GL_CURRENT_RASTER_TEXTURE_COORDS);
  }
  glActiveTexture(GLenum(active));
  for (const GLenum face : {GL_FRONT, GL_BACK}) {
    for (const GLenum name :
         {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES}) {
      GLfloat value[4] = {};
      glGetMaterialfv(face, name, value);
      values.insert(values.end(), value, value + 4);
    }
  }
  for (GLuint attribute = 1; attribute < 16; ++attribute) {
    GLfloat value[4] = {};
    glGetVertexAttribfv(attribute, GL_CURRENT_VERTEX_ATTRIB, value);
    values.insert(values.end(), value, value + 4);
  }
  return values;
}

std::vector<GLfloat> other_state() {
  std::vector<GLfloat> values;
  append(values, 16, GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX);
  append(values, 4, GL_VIEWPORT, GL_SCISSOR_BOX, GL_COLOR_WRITEMASK, GL_COLOR_CLEAR_VALUE, GL_BLEND_COLOR);
  append(values, 2, GL_DEPTH_RANGE, GL_POLYGON_MODE);
  append(values, 1, GL_MATRIX_MODE, GL_ACTIVE_TEXTURE, GL_CLIENT_ACTIVE_TEXTURE, GL_MODELVIEW_STACK_DEPTH,
         GL_PROJECTION_STACK_DEPTH, GL_TEXTURE_STACK_DEPTH, GL_ATTRIB_STACK_DEPTH,
         GL_CLIENT_ATTRIB_STACK_DEPTH, GL_NAME_STACK_DEPTH, GL_LIST_INDEX, GL_LIST_MODE, GL_LIST_BASE,
         GL_RENDER_MODE, GL_SHADE_MODEL, GL_CULL_FACE_MODE, GL_FRONT_FACE, GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK,
         GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_WRITEMASK, GL_STENCIL_FAIL, GL_STENCIL_PASS_DEPTH_FAIL,
         GL_STENCIL_PASS_DEPTH_PASS, GL_ALPHA_TEST_FUNC, GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB,
         GL_BLEND_EQUATION_RGB, GL_LOGIC_OP_MODE, GL_POLYGON_OFFSET_FACTOR, GL_POLYGON_OFFSET_UNITS,
         GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D, GL_ARRAY_BUFFER_BINDING,
         GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING, GL_CURRENT_PROGRAM, GL_DRAW_BUFFER,
         GL_READ_BUFFER, GL_PROVOKING_VERTEX, GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT, GL_FOG_COORD_SRC,
         GL_COLOR_MATERIAL_FACE, GL_COLOR_MATERIAL_PARAMETER, GL_DRAW_FRAMEBUFFER_BINDING, GL_LINE_WIDTH,
         GL_POINT_SIZE);
  constexpr GLenum kSwitches[] = {GL_ALPHA_TEST,
                                  GL_BLEND,
                                  GL_COLOR_LOGIC_OP,
                                  GL_COLOR_MATERIAL,
                                  GL_COLOR_SUM,
                                  GL_CULL_FACE,
                                  GL_DEPTH_TEST,
                                  GL_DITHER,
                                  GL_FOG,
                                  GL_LIGHTING,
                                  GL_LIGHT0,
                                  GL_NORMALIZE,
                                  GL_POLYGON_OFFSET_FILL,
                                  GL_POLYGON_SMOOTH,
                                  GL_POLYGON_STIPPLE,
                                  GL_RESCALE_NORMAL,
                                  GL_SCISSOR_TEST,
                                  GL_STENCIL_TEST,
                                  GL_MULTISAMPLE,
                                  GL_CLIP_PLANE0,
                                  GL_VERTEX_ARRAY,
                                  GL_TEXTURE_COORD_ARRAY,
                                  GL_COLOR_ARRAY,
                                  GL_NORMAL_ARRAY,
                                  GL_EDGE_FLAG_ARRAY};
  for (const GLenum name : kSwitches) values.push_back(glIsEnabled(name));
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (GLenum unit = 0; unit < 4; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (const GLenum name : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_GEN_S}) {
      values.push_back(glIsEnabled(name));
    }
    append(values, 1, GL_TEXTURE_BINDING_2D);
  }
  glActiveTexture(GLenum(active));
  return values;
}

std::vector<GLenum> all_errors() {
  std::vector<GLenum> errors;
  while (const GLenum error = glGetError()) errors.push_back(error);
  return errors;
}

}  // namespace truequad::semantics

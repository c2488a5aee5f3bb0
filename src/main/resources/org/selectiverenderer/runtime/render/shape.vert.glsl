// Shapes: to clip coordinates, and to the eye's for lighting.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in vec2 texCoord;

// 0-3 columns of the local-to-clip matrix, 4-6 rows of local-to-eye, 7-9 rows of the normals' matrix.
uniform vec4 object[10];
// Columns of the texture transform, and the size of points in pixels.
uniform vec3 texture_[3];
uniform float pointSize;

#ifdef LIT
out vec3 eyeNormal;
#endif
#ifdef EYE_POSITION
out vec3 eyePosition;
#endif
#ifdef COLORS
out vec4 vertexColor;
#endif
#ifdef TEXTURE
out vec2 coordinate;
#endif

void main() {
  vec4 local = vec4(position, 1.0);
  gl_Position =
      object[0] * position.x + object[1] * position.y + object[2] * position.z + object[3];
#ifdef POINTS
  gl_PointSize = pointSize;
#endif
#ifdef LIT
  eyeNormal =
      vec3(dot(object[7].xyz, normal), dot(object[8].xyz, normal), dot(object[9].xyz, normal));
#endif
#ifdef EYE_POSITION
  eyePosition = vec3(dot(object[4], local), dot(object[5], local), dot(object[6], local));
#endif
#ifdef COLORS
  vertexColor = color;
#endif
#ifdef TEXTURE
  coordinate = (texture_[0] * texCoord.x + texture_[1] * texCoord.y + texture_[2]).xy;
#endif
}

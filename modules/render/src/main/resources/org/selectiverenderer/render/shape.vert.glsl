// Shapes: to clip coordinates, and to the eye's for lighting, which is done here or by pixel.
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
#ifdef LIT_BY_VERTEX
#include light.glsl
// Not clamped here: what is too bright is cut off by pixel, after interpolation.
out vec3 frontDiffuse;
#ifdef HIGHLIGHT_APART
out vec3 frontHighlight;
#endif
#ifdef TWO_SIDED
out vec3 backDiffuse;
#ifdef HIGHLIGHT_APART
out vec3 backHighlight;
#endif
#endif
#else
out vec3 eyeNormal;
#ifdef EYE_POSITION
out vec3 eyePosition;
#endif
#endif
#endif
#ifdef COLORS
out vec4 vertexColor;
#endif
#ifdef TEXTURE
out vec2 coordinate;
#endif
#ifdef DETAIL
#include coordinate.glsl
#endif
#if defined(LINES) || defined(SIZED)
uniform vec4 stroke[2];
#endif
#ifdef FOG
out vec3 fogPlace;
#endif
#ifdef FOG_DEPTH
layout(location = FOG_DEPTH) in float fogDepth;
#endif
#if defined(PLANES) && defined(LINES)
out vec3 cutPlace;  // Lines are cut where their rectangles are made.
#elif defined(PLANES)
#include clip.glsl
#endif
#if defined(PATTERN) || defined(ENDED)
out float along;
#endif

#ifdef LIT_BY_VERTEX
// What the pixels need of the light: all of it together where the colour is the same everywhere. What
// an image sends out is added there.
#ifdef GLOW
#define SENT vec3(0.0)
#else
#define SENT material[1].rgb
#endif
vec3 diffuseOf(Light light) {
#ifdef TINTED
  return SENT + color.rgb * light.diffuse + light.highlight;
#elif defined(WHOLE_BY_VERTEX)
  return SENT + material[0].rgb * light.diffuse + light.highlight;
#else
  return light.diffuse;
#endif
}
#endif

void main() {
  vec4 local = vec4(position, 1.0);
  gl_Position =
      object[0] * position.x + object[1] * position.y + object[2] * position.z + object[3];
#ifdef POINTS
  gl_PointSize = pointSize;
#endif
#if defined(FOG) || defined(PLANES) || defined(ATTENUATED)
  vec3 seenAt = vec3(dot(object[4], local), dot(object[5], local), dot(object[6], local));
#endif
#ifdef SIZED
  gl_PointSize = stroke[0].x;
#endif
#ifdef ATTENUATED
  float r = length(seenAt);
  gl_PointSize = clamp(
      stroke[0].x / max(1.0, stroke[1].x + stroke[1].y * r + stroke[1].z * r * r),
      stroke[0].y,
      stroke[0].z);
#endif
#ifdef FOG_DEPTH
  fogPlace = vec3(0.0, 0.0, fogDepth);  // As far away as that.
#elif defined(FOG)
  fogPlace = seenAt;
#endif
#if defined(PLANES) && defined(LINES)
  cutPlace = seenAt;
#elif defined(PLANES)
  cutOff(seenAt);
#endif
#if defined(PATTERN) || defined(ENDED)
  along = texCoord.x;
#endif
#ifdef LIT
  vec3 across =
      vec3(dot(object[7].xyz, normal), dot(object[8].xyz, normal), dot(object[9].xyz, normal));
  vec3 place = vec3(0.0);
#ifdef EYE_POSITION
  place = vec3(dot(object[4], local), dot(object[5], local), dot(object[6], local));
#endif
#ifdef LIT_BY_VERTEX
  vec3 n = normalize(across);
  Light front = lightAt(place, n);
  frontDiffuse = diffuseOf(front);
#ifdef HIGHLIGHT_APART
  frontHighlight = front.highlight;
#endif
#ifdef TWO_SIDED
  Light back = lightAt(place, -n);
  backDiffuse = diffuseOf(back);
#ifdef HIGHLIGHT_APART
  backHighlight = back.highlight;
#endif
#endif
#else
  eyeNormal = across;
#ifdef EYE_POSITION
  eyePosition = place;
#endif
#endif
#endif
#ifdef COLORS
  vertexColor = color;
#endif
#ifdef TEXTURE
  coordinate = (texture_[0] * texCoord.x + texture_[1] * texCoord.y + texture_[2]).xy;
#endif
#ifdef DETAIL
  passCoordinates();
#endif
}

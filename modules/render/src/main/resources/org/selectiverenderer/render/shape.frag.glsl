// Shapes: their colour, texture and light, which arrives computed where the vertex shader did that.

#ifdef LIT
#ifndef DETAIL
#include light.glsl
#endif
#ifdef LIT_BY_VERTEX
in vec3 frontDiffuse;
#ifdef HIGHLIGHT_APART
in vec3 frontHighlight;
#endif
#ifdef TWO_SIDED
in vec3 backDiffuse;
#ifdef HIGHLIGHT_APART
in vec3 backHighlight;
#endif
#endif
#else
in vec3 eyeNormal;
#ifdef EYE_POSITION
in vec3 eyePosition;
#endif
#endif
#elif !defined(DETAIL)
uniform vec4 material[3];
#endif
#ifdef COLORS
in vec4 vertexColor;
#endif
#ifdef TEXTURE
uniform sampler2D image;
in vec2 coordinate;
#endif

#if defined(LINES) || defined(HATCHED)
uniform vec4 stroke[2];
#endif
#ifdef LINES
#include line.glsl
#endif
#ifdef HATCHED
#include hatch.glsl
#endif
#ifdef FOG
#include fog.glsl
#endif

out vec4 pixel;

#ifdef DETAIL
#include texture.glsl
#include material.glsl
#elif defined(LIT)
// The light on the side that is seen.
Light seenLight() {
#ifdef LIT_BY_VERTEX
  Light light = Light(frontDiffuse, vec3(0.0));
#ifdef HIGHLIGHT_APART
  light.highlight = frontHighlight;
#endif
#ifdef TWO_SIDED
  light.diffuse = gl_FrontFacing ? frontDiffuse : backDiffuse;
#ifdef HIGHLIGHT_APART
  light.highlight = gl_FrontFacing ? frontHighlight : backHighlight;
#endif
#endif
  return light;
#else
#ifdef FLAT
  vec3 n = normalize(cross(dFdx(eyePosition), dFdy(eyePosition)));  // Towards the eye.
#else
  vec3 n = normalize(eyeNormal);
#endif
#if defined(TWO_SIDED) && !defined(FLAT)
  n = gl_FrontFacing ? n : -n;
#endif
#ifdef EYE_POSITION
  return lightAt(eyePosition, n);
#else
  return lightAt(vec3(0.0), n);
#endif
#endif
}
#endif

void main() {
#ifdef LINES
  if (!onStroke()) {
    discard;
  }
#endif
#ifdef DETAIL
  pixel = detailed();
#else
  vec3 sent = material[1].rgb;
#ifdef GLOW
  sent *= texture(image, coordinate).rgb;
#endif
#ifdef LIT
  vec4 base = material[0];
#else
  vec4 base = vec4(sent, material[0].a);
#endif
#ifdef COLORS
  // A Color leaves the material's opacity, a ColorRGBA has its own (X3D 4.0, 11.4.2, 11.4.3).
  base = vec4(vertexColor.rgb, vertexColor.a * base.a);
#endif
#if defined(TEXTURE) && !defined(GLOW)
  vec4 texel = texture(image, coordinate);
#ifdef TINT
  base *= texel;
#else
  base = vec4(texel.rgb, base.a * texel.a);
#endif
#ifdef ALPHA_TEST
  if (texel.a < 0.5) {
    discard;
  }
#endif
#endif
#ifdef LIT
  Light light = seenLight();
#if defined(WHOLE_BY_VERTEX) && defined(GLOW)
  pixel = vec4(sent + light.diffuse, base.a);
#elif defined(WHOLE_BY_VERTEX)
  pixel = vec4(light.diffuse, base.a);
#else
  pixel = vec4(sent + base.rgb * light.diffuse + light.highlight, base.a);
#endif
#else
  pixel = base;
#endif
#endif
#ifdef HATCHED
  bool hatch = onHatch(gl_FragCoord.xy);
  pixel.rgb = hatch ? stroke[0].rgb : pixel.rgb;
#ifdef HOLLOW
  if (!hatch) {
    discard;
  }
#endif
#elif defined(HOLLOW)
  discard;
#endif
#ifdef FOG
  pixel.rgb = mix(fog.rgb, pixel.rgb, leftInFog());
#endif
#ifdef OPAQUE
  pixel.a = 1.0;
#endif
}

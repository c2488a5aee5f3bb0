// The colour of a surface that has several textures, a back of its own or a physical material: what
// its textures make of its colours, then light as for any other (X3D 4.0, 17.2.2).

// 0 metallic, roughness, normal scale, occlusion strength; 1 the factor of a MultiTexture; 2 least
// opacity.
uniform vec4 detail[3];
uniform vec4 material[3];
#ifdef BACK_MATERIAL
uniform vec4 backMaterial[3];
#endif

// The material where the pixel is, as material[] has it: textures multiply it.
vec4 baseHere;
vec4 glowHere;
vec4 shineHere;
#define AMBIENT_HERE glowHere.a
#define SPECULAR_HERE shineHere.rgb
#define EXPONENT_HERE shineHere.a
vec3 ambientTint = vec3(1.0);
#ifdef PHYSICAL
float roughHere;
float metalHere;

// Physical colours are counted with as light, images and screens hold them as sRGB does; its curve
// is near a power (17.2.2.6).
vec3 linear(vec3 image) {
  return pow(image, vec3(2.2));
}

vec3 encoded(vec3 light) {
  return pow(max(light, 0.0), vec3(1.0 / 2.2));
}
#endif

#ifdef LIT
#include light.glsl
#endif

#if defined(NORMAL_TEXEL) && defined(TANGENTS)
in vec3 firstAxis;
in vec3 secondAxis;

// Turns a unit normal as a texture says whose axes are given.
vec3 bumped(vec3 n, vec3 texel, vec2 st) {
  vec3 local = (texel * 2.0 - 1.0) * vec3(detail[0].z, detail[0].z, 1.0);
  vec3 s = firstAxis * inversesqrt(max(dot(firstAxis, firstAxis), 1e-30));
  vec3 t = secondAxis * inversesqrt(max(dot(secondAxis, secondAxis), 1e-30));
  return normalize(s * local.x + t * local.y + n * local.z);
}
#elif defined(NORMAL_TEXEL)
// Turns a unit normal as a texture says whose s and t grow along the surface; the directions in
// which they do come from how both change from pixel to pixel (C. Schueler, Normal Mapping Without
// Precomputed Tangents, ShaderX 5, 2006).
vec3 bumped(vec3 n, vec3 texel, vec2 st) {
  vec3 across = dFdx(seenAt);
  vec3 up = dFdy(seenAt);
  vec2 stAcross = dFdx(st);
  vec2 stUp = dFdy(st);
  vec3 a = cross(up, n);
  vec3 b = cross(n, across);
  vec3 s = a * stAcross.x + b * stUp.x;
  vec3 t = a * stAcross.y + b * stUp.y;
  float longest = max(dot(s, s), dot(t, t));
  if (longest <= 0.0) {
    return n;
  }
  vec3 local = (texel * 2.0 - 1.0) * vec3(detail[0].z, detail[0].z, 1.0);
  return normalize((s * local.x + t * local.y) * inversesqrt(longest) + n * local.z);
}
#endif

#ifdef STAGES
#include stage.glsl
#endif

vec4 detailed() {
  baseHere = material[0];
  glowHere = material[1];
  shineHere = material[2];
#ifdef BACK_MATERIAL
  if (!gl_FrontFacing) {
    baseHere = backMaterial[0];
    glowHere = backMaterial[1];
    shineHere = backMaterial[2];
  }
#endif
#ifndef LIT
  baseHere.rgb = glowHere.rgb;
#endif
#ifdef COLORS
  baseHere = vec4(vertexColor.rgb, vertexColor.a * baseHere.a);
#endif
  // What the textures leave of the surface.
  float cover = 1.0;
#ifdef MAIN_TEXEL
  vec4 main_ = MAIN_TEXEL;
  cover *= main_.a;
#ifdef TINT
  baseHere *= main_;
#else
  baseHere = vec4(main_.rgb, baseHere.a * main_.a);
#endif
#endif
#ifdef DIFFUSE_TEXEL
  vec4 diffuse_ = DIFFUSE_TEXEL;
  cover *= diffuse_.a;
#ifdef PHYSICAL
  diffuse_.rgb = linear(diffuse_.rgb);
#endif
  baseHere *= diffuse_;
#endif
#ifdef STAGES
  vec4 plain = baseHere;
  STAGES
  cover *= plain.a > 0.0 ? baseHere.a / plain.a : 0.0;
#endif
#ifdef EMISSIVE_TEXEL
  vec3 glow_ = EMISSIVE_TEXEL.rgb;
#ifdef PHYSICAL
  glow_ = linear(glow_);
#endif
  glowHere.rgb *= glow_;
#endif
#ifdef SPECULAR_TEXEL
  shineHere.rgb *= SPECULAR_TEXEL.rgb;
#endif
#ifdef SHININESS_TEXEL
  shineHere.a *= SHININESS_TEXEL.a;
#endif
#ifdef AMBIENT_TEXEL
  ambientTint = AMBIENT_TEXEL.rgb;
#endif

#ifdef LIT
#ifdef FLAT
  vec3 n = normalize(cross(dFdx(seenAt), dFdy(seenAt)));  // Towards the eye.
#else
  vec3 n = normalize(seenNormal);
#ifdef TWO_SIDED
  n = gl_FrontFacing ? n : -n;
#endif
#endif
#if defined(NORMAL_TEXEL) && !defined(FLAT)
  n = bumped(n, NORMAL_TEXEL.rgb, NORMAL_PLACE.st);
#endif
#ifdef PHYSICAL
  roughHere = detail[0].y;
  metalHere = detail[0].x;
#ifdef METALLIC_ROUGHNESS_TEXEL
  vec4 both = METALLIC_ROUGHNESS_TEXEL;
  roughHere *= both.g;
  metalHere *= both.b;
#endif
#endif
  Light light = lightAt(seenAt, n);
  vec4 color = vec4(glowHere.rgb + baseHere.rgb * light.diffuse + light.highlight, baseHere.a);
#else
  vec4 color = baseHere;
#endif
#ifdef OCCLUSION_TEXEL
  color.rgb *= mix(1.0, OCCLUSION_TEXEL.r, detail[0].w);
#endif
#ifdef PHYSICAL
  color.rgb = encoded(color.rgb);
#endif
#ifdef CUT_OUT
  if (cover < 0.5) {
    discard;
  }
#endif
#ifdef MASK
  if (color.a < detail[2].x) {
    discard;
  }
#endif
  return color;
}

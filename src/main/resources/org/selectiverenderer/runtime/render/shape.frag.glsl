// Shapes: X3D 4.0, 17.2.2, per pixel and in the eye's coordinates, where the eye is the origin.

// 0 diffuse, opacity; 1 emissive, ambient intensity; 2 specular, exponent.
uniform vec4 material[3];
#ifdef LIT
// Five per light. 0 position, 1, or direction towards the light, 0; 1 colour, ambient intensity;
// 2 attenuation, radius; 3 beam's axis, intensity; 4 cut-off angle, 1 / (beam width - cut-off).
#if LIGHTS > 0
uniform vec4 lights[5 * LIGHTS];
#endif
in vec3 eyeNormal;
#endif
#ifdef EYE_POSITION
in vec3 eyePosition;
#endif
#ifdef COLORS
in vec4 vertexColor;
#endif
#ifdef TEXTURE
uniform sampler2D image;
in vec2 coordinate;
#endif

out vec4 pixel;

#ifdef LIT
// What one light adds (X3D 4.0, 17.2.2); n and v are unit vectors.
vec3 lit(vec4 place, vec4 color, vec4 reach, vec4 axis, vec4 beam, vec3 diffuse, vec3 n, vec3 v) {
  vec3 l = place.xyz;
  float factor = 1.0;
#ifdef POSITIONAL
  vec3 towards = place.xyz - eyePosition * place.w;
  float distance = length(towards);
  l = towards / max(distance, 1e-9);
  float fall = reach.x + distance * (reach.y + distance * reach.z);
  factor = mix(1.0, step(distance, reach.w) / max(fall, 1.0), place.w);
#ifdef SPOT
  float angle = acos(clamp(dot(-l, axis.xyz), -1.0, 1.0));
  factor *= clamp((angle - beam.x) * beam.y, 0.0, 1.0);
#endif
#endif
  vec3 reflected = diffuse * (color.a * material[1].a + axis.w * max(dot(n, l), 0.0));
#ifdef SPECULAR
  // The standard's dot product is 0 where it would be negative; 0 to the power 0 is avoided.
  float highlight = pow(max(dot(n, normalize(l + v)), 1e-6), material[2].a);
  reflected += material[2].rgb * (axis.w * highlight);
#endif
  return factor * color.rgb * reflected;
}
#endif

void main() {
#ifdef LIT
  vec4 base = material[0];
#else
  vec4 base = vec4(material[1].rgb, material[0].a);
#endif
#ifdef COLORS
  base = vertexColor;
#endif
#ifdef TEXTURE
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
  vec3 n = normalize(eyeNormal);
#ifdef TWO_SIDED
  n = gl_FrontFacing ? n : -n;
#endif
#ifdef SPECULAR
  vec3 v = normalize(-eyePosition);
#endif
#ifndef SPECULAR
  vec3 v = vec3(0.0);
#endif
  vec3 sum = material[1].rgb;
  // Written out light by light: constant indices are much cheaper than a loop's on software GL.
#define LIGHT(i) \
  sum += lit(lights[5 * i], lights[5 * i + 1], lights[5 * i + 2], lights[5 * i + 3], \
      lights[5 * i + 4], base.rgb, n, v);
  EACH_LIGHT
  pixel = vec4(sum, base.a);
#else
  pixel = base;
#endif
#ifdef OPAQUE
  pixel.a = 1.0;
#endif
}

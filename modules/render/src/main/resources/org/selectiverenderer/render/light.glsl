// The light model of X3D 4.0, 17.2.2, in the eye's coordinates, where the eye is the origin. One
// text for both shaders: light by vertex and light by pixel cannot differ but by interpolation.

// 0 diffuse, opacity; 1 emissive, ambient intensity; 2 specular, exponent.
#ifndef DETAIL
uniform vec4 material[3];
#define AMBIENT_HERE material[1].a
#define SPECULAR_HERE material[2].rgb
#define EXPONENT_HERE material[2].a
#endif
// Five per light. 0 position, or direction towards the light; 1 colour, ambient intensity;
// 2 attenuation, radius; 3 beam's axis, intensity; 4 cut-off angle, 1 / (beam width - cut-off).
#if LIGHTS > 0
uniform vec4 lights[5 * LIGHTS];
#endif

// What lights a place: what its diffuse colour is to be multiplied by, and what shines on top.
struct Light {
  vec3 diffuse;
  vec3 highlight;
};

#ifdef ENVIRONMENT
#include environment.glsl
#endif

#ifdef PHYSICAL
#include physical.glsl
#else
// Adds light that arrives from the direction l; l, n and v are unit vectors.
void arrive(inout Light sum, vec4 color, float intensity, float factor, vec3 l, vec3 n, vec3 v) {
  vec3 arriving = factor * color.rgb;
#ifdef AMBIENT_TEXEL
  sum.diffuse += arriving * color.a * AMBIENT_HERE * (ambientTint - 1.0);
#endif
  sum.diffuse += arriving * (color.a * AMBIENT_HERE + intensity * max(dot(n, l), 0.0));
#ifdef SPECULAR
  // The standard's dot product is 0 where it would be negative; 0 to the power 0 is avoided.
  float shine = pow(max(dot(n, normalize(l + v)), 1e-6), EXPONENT_HERE);
  sum.highlight += arriving * (intensity * shine);
#endif
}
#endif

// What attenuation and radius leave at a distance.
float fall(vec4 reach, float distance) {
  float divisor = reach.x + distance * (reach.y + distance * reach.z);
  return step(distance, reach.w) / max(divisor, 1.0);
}

// The arc cosine to 7e-5 (Abramowitz and Stegun 1964, 4.4.45): its exact form costs more than all
// the rest of a spot light on a processor.
float arcCosine(float x) {
  float a = min(abs(x), 1.0);
  float arc = sqrt(1.0 - a) * (1.5707288 + a * (-0.2121144 + a * (0.0742610 - 0.0187293 * a)));
  return x < 0.0 ? 3.14159265 - arc : arc;
}

void positional(inout Light sum, int i, bool spot, vec3 place, vec3 n, vec3 v) {
#if LIGHTS > 0
  vec3 towards = lights[i].xyz - place;
  float distance = length(towards);
  vec3 l = towards / max(distance, 1e-9);
  float factor = fall(lights[i + 2], distance);
  if (spot) {
    float angle = arcCosine(dot(-l, lights[i + 3].xyz));
    factor *= clamp((angle - lights[i + 4].x) * lights[i + 4].y, 0.0, 1.0);
  }
  arrive(sum, lights[i + 1], lights[i + 3].w, factor, l, n, v);
#endif
}

// The light at a place whose unit normal is n.
Light lightAt(vec3 place, vec3 n) {
  Light sum = Light(vec3(0.0), vec3(0.0));
#if defined(SPECULAR) || defined(PHYSICAL)
  vec3 v = normalize(-place);
#else
  vec3 v = vec3(0.0);
#endif
  // Written out light by light and kind by kind: constant indices are much cheaper than a loop's on
  // software GL, and no light pays for what only another kind needs.
#define DIRECTIONAL(i) \
  arrive(sum, lights[5 * i + 1], lights[5 * i + 3].w, 1.0, lights[5 * i].xyz, n, v);
#define POINT(i) positional(sum, 5 * i, false, place, n, v);
#define SPOT(i) positional(sum, 5 * i, true, place, n, v);
  EACH_LIGHT
#if defined(ENVIRONMENT) && defined(PHYSICAL)
  sum.highlight += surrounded(n, v);
#elif defined(ENVIRONMENT)
  // The other materials count with colours as images and screens hold them.
  sum.diffuse += pow(allAround(toEnvironment(n)), vec3(1.0 / 2.2));
#endif
#ifdef SPECULAR
  sum.highlight *= SPECULAR_HERE;
#endif
  return sum;
}

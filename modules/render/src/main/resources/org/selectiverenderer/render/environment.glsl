// Light from all around (draft of X3D 4.1, EnvironmentLight): nine coefficients of what a white matt
// surface throws back, by its normal; three rows that lead from the eye's coordinates to the
// light's; the colour of what is mirrored, and how many smaller versions its image has.
uniform vec4 environment[13];
#ifdef ENVIRONMENT_IMAGE
uniform samplerCube environmentImage;
#endif

vec3 toEnvironment(vec3 direction) {
  return normalize(
      vec3(
          dot(environment[9].xyz, direction),
          dot(environment[10].xyz, direction),
          dot(environment[11].xyz, direction)));
}

// The spherical harmonics of R. Ramamoorthi and P. Hanrahan (SIGGRAPH 2001).
vec3 allAround(vec3 n) {
  vec3 sum =
      0.282095 * environment[0].rgb
      + 0.488603 * (n.y * environment[1].rgb + n.z * environment[2].rgb + n.x * environment[3].rgb)
      + 1.092548
          * (n.x * n.y * environment[4].rgb
              + n.y * n.z * environment[5].rgb
              + n.x * n.z * environment[7].rgb)
      + 0.315392 * (3.0 * n.z * n.z - 1.0) * environment[6].rgb
      + 0.546274 * (n.x * n.x - n.y * n.y) * environment[8].rgb;
  return max(sum, 0.0);
}

#ifdef PHYSICAL
// What a physical surface throws back. A rough one mirrors smaller versions of the image, and the
// roughest nearly what a matt one sees; how much is mirrored is B. Karis's approximation (Physically Based Shading on Mobile, 2014).
vec3 surrounded(vec3 n, vec3 v) {
  vec3 least = mix(vec3(0.04), baseHere.rgb, metalHere);
  float nv = clamp(abs(dot(n, v)), 1e-3, 1.0);
  vec4 r = roughHere * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float bend = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
  vec3 mirrors = least * (r.z - 1.04 * bend) + max(r.w + 1.04 * bend, 0.0);
  vec3 towards = toEnvironment(reflect(-v, n));
#ifdef ENVIRONMENT_IMAGE
  vec3 image = textureLod(environmentImage, towards, roughHere * environment[12].a).rgb;
  vec3 sharp = pow(image, vec3(2.2)) * environment[12].rgb;
  vec3 seen = mix(sharp, allAround(towards), smoothstep(0.4, 1.0, roughHere));
#else
  vec3 seen = allAround(towards);
#endif
  vec3 matt = (1.0 - least) * (1.0 - metalHere) * baseHere.rgb;
  return matt * allAround(toEnvironment(n)) + mirrors * seen;
}
#endif

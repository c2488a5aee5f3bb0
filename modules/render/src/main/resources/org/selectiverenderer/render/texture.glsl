// Textures of surfaces that have more than a plain image (X3D 4.0, 18, 33 and 34). The program is
// made for its textures: SAMPLERS declares them, NAME_TEXEL looks up the one that is for NAME.
in vec3 seenAt;
in vec3 seenNormal;
in vec3 localAt;
in vec3 localNormal;
in vec4 set0;
MORE_VARYINGS
#if UNITS > 0
uniform mat4 unit[UNITS];
#endif
SAMPLERS
#ifdef TURNED
// From the eye's coordinates to the world's: a cube stands still in the world.
uniform mat3 toWorld;
#endif

// Coordinates that are generated (18.4.8), from unit normals.
vec4 sphereOf(vec3 n) {
  return vec4(n.xy * 0.5 + 0.5, 0.0, 1.0);
}

vec3 mirrored() {
  return reflect(normalize(seenAt), normalize(seenNormal));
}

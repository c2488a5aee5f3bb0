// How a MultiTexture's textures are blended (X3D 4.0, 18.4.3, table 18.2): a is the texture's
// colour, b what is there, d the surface's own colour, f the factor. As a single texture does, they
// make the diffuse colour, which is then lit.
vec4 REPLACE(vec4 a, vec4 b, vec4 d, vec4 f) { return a; }
vec4 SELECTARG1(vec4 a, vec4 b, vec4 d, vec4 f) { return a; }
vec4 SELECTARG2(vec4 a, vec4 b, vec4 d, vec4 f) { return b; }
vec4 MODULATE(vec4 a, vec4 b, vec4 d, vec4 f) { return a * b; }
vec4 MODULATE2X(vec4 a, vec4 b, vec4 d, vec4 f) { return 2.0 * a * b; }
vec4 MODULATE4X(vec4 a, vec4 b, vec4 d, vec4 f) { return 4.0 * a * b; }
vec4 ADD(vec4 a, vec4 b, vec4 d, vec4 f) { return a + b; }
vec4 ADDSIGNED(vec4 a, vec4 b, vec4 d, vec4 f) { return a + b - 0.5; }
vec4 ADDSIGNED2X(vec4 a, vec4 b, vec4 d, vec4 f) { return 2.0 * (a + b - 0.5); }
vec4 SUBTRACT(vec4 a, vec4 b, vec4 d, vec4 f) { return a - b; }
vec4 ADDSMOOTH(vec4 a, vec4 b, vec4 d, vec4 f) { return a + (1.0 - a) * b; }
vec4 BLENDDIFFUSEALPHA(vec4 a, vec4 b, vec4 d, vec4 f) { return mix(b, a, d.a); }
vec4 BLENDTEXTUREALPHA(vec4 a, vec4 b, vec4 d, vec4 f) { return mix(b, a, a.a); }
vec4 BLENDFACTORALPHA(vec4 a, vec4 b, vec4 d, vec4 f) { return mix(b, a, f.a); }
vec4 BLENDCURRENTALPHA(vec4 a, vec4 b, vec4 d, vec4 f) { return mix(b, a, b.a); }
vec4 MODULATEALPHA_ADDCOLOR(vec4 a, vec4 b, vec4 d, vec4 f) { return a + a.a * b; }
vec4 MODULATEINVALPHA_ADDCOLOR(vec4 a, vec4 b, vec4 d, vec4 f) { return a + (1.0 - a.a) * b; }
vec4 MODULATEINVCOLOR_ADDALPHA(vec4 a, vec4 b, vec4 d, vec4 f) { return (1.0 - a) * b + a.a; }
vec4 DOTPRODUCT3(vec4 a, vec4 b, vec4 d, vec4 f) {
  return vec4(4.0 * dot(a.rgb - 0.5, b.rgb - 0.5));
}

vec4 staged(vec4 color, vec4 alpha) {
  return clamp(vec4(color.rgb, alpha.a), 0.0, 1.0);
}

vec4 complement(vec4 color) {
  return vec4(1.0 - color.rgb, color.a);
}

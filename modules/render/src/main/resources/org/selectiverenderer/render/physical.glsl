// Light on a physical material: the metallic-roughness model of glTF 2.0 (appendix B), which X3D
// 4.0, 17.2.2.6 shares: microfacets after GGX (Trowbridge and Reitz), their shadows after Smith, and
// Fresnel's law after Schlick. Lights have no ambient part in it.
void arrive(inout Light sum, vec4 color, float intensity, float factor, vec3 l, vec3 n, vec3 v) {
  vec3 arriving = factor * color.rgb;
  vec3 h = normalize(l + v);
  float nl = max(dot(n, l), 0.0);
  float nv = max(abs(dot(n, v)), 1e-3);
  float nh = max(dot(n, h), 0.0);
  float vh = max(dot(v, h), 0.0);
  float alpha = max(roughHere * roughHere, 2e-3);
  float square = alpha * alpha;
  float d = nh * nh * (square - 1.0) + 1.0;
  float spread = square / (d * d);
  float shadow =
      nl * sqrt(nv * nv * (1.0 - square) + square) + nv * sqrt(nl * nl * (1.0 - square) + square);
  vec3 least = mix(vec3(0.04), baseHere.rgb, metalHere);
  vec3 fresnel = least + (1.0 - least) * pow(1.0 - vh, 5.0);
  vec3 scattered = (1.0 - fresnel) * (1.0 - metalHere) * baseHere.rgb;
  float thrown = shadow > 0.0 ? 0.5 * spread / shadow : 0.0;
  sum.highlight += arriving * (intensity * nl / 3.14159265) * (scattered + fresnel * thrown);
}

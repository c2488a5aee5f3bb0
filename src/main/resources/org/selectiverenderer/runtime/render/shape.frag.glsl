// Shapes: X3D 4.0, 17.2.2, per pixel and in the eye's coordinates, where the eye is the origin.

// 0 diffuse, opacity; 1 emissive, ambient intensity; 2 specular, exponent.
uniform vec4 material[3];
#ifdef LIT
// Five per light. 0 position, 1, or direction towards the light, 0; 1 colour, ambient intensity;
// 2 attenuation, radius; 3 beam's axis, intensity; 4 cut-off angle, 1 / (beam width - cut-off).
uniform vec4 lights[5 * MAX_LIGHTS];
uniform int lightCount;
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
  vec3 sum = material[1].rgb;
  for (int i = 0; i < lightCount; i++) {
    vec4 place = lights[5 * i];
    vec4 color = lights[5 * i + 1];
    vec4 axis = lights[5 * i + 3];
    vec3 l = place.xyz;
    float factor = 1.0;
#ifdef POSITIONAL
    vec4 reach = lights[5 * i + 2];
    vec3 towards = place.xyz - eyePosition * place.w;
    float distance = length(towards);
    l = towards / max(distance, 1e-9);
    float fall = reach.x + distance * (reach.y + distance * reach.z);
    float near = step(distance, reach.w) / max(fall, 1.0);
    factor = mix(1.0, near, place.w);
#ifdef SPOT
    vec4 beam = lights[5 * i + 4];
    float angle = acos(clamp(dot(-l, axis.xyz), -1.0, 1.0));
    factor *= clamp((angle - beam.x) * beam.y, 0.0, 1.0);
#endif
#endif
    vec3 reflected = base.rgb * (color.a * material[1].a + axis.w * max(dot(n, l), 0.0));
#ifdef SPECULAR
    // The dot product of the standard is 0 where it would be negative; 0 to the power 0 is avoided.
    float highlight = pow(max(dot(n, normalize(l + v)), 1e-6), material[2].a);
    reflected += material[2].rgb * (axis.w * highlight);
#endif
    sum += factor * color.rgb * reflected;
  }
  pixel = vec4(sum, base.a);
#else
  pixel = base;
#endif
#ifdef OPAQUE
  pixel.a = 1.0;
#endif
}

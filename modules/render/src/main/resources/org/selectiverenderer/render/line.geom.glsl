// Lines that are wide or have a pattern: each becomes a rectangle in the picture. What comes from
// the vertices has an underscore after its name, which shape.vert.glsl is compiled with here.
layout(lines) in;
#ifdef ENDED
layout(triangle_strip, max_vertices = 10) out;
#else
layout(triangle_strip, max_vertices = 4) out;
#endif

// Width of the line, width and height of the picture in pixels, and the pattern's sixteen bits, or
// the line's type.
uniform vec4 stroke[2];

#ifdef LIT
in vec3 eyeNormal_[];
out vec3 eyeNormal;
#ifdef EYE_POSITION
in vec3 eyePosition_[];
out vec3 eyePosition;
#endif
#endif
#ifdef COLORS
in vec4 vertexColor_[];
out vec4 vertexColor;
#endif
#ifdef FOG
in vec3 fogPlace_[];
out vec3 fogPlace;
#endif
#ifdef PLANES
in vec3 cutPlace_[];
#include clip.glsl
#endif
#ifdef PATTERN
in float along_[];
noperspective out float pattern;
#ifdef BREAK
noperspective out float across;
#endif
#else
// From the beginning along and across the line in pixels, and how long it is.
noperspective out vec2 onLine;
flat out float lineLength;
#ifdef ENDED
// 1 at the last point of a line, -1 at its first.
in float along_[];
#endif
#endif

// A corner of the rectangle at that part of the line, so many pixels beside it.
void corner(float part, vec4 place, vec2 beside) {
  gl_Position = place;
  gl_Position.xy += 2.0 * beside / stroke[0].yz * place.w;
#ifdef LIT
  eyeNormal = mix(eyeNormal_[0], eyeNormal_[1], part);
#ifdef EYE_POSITION
  eyePosition = mix(eyePosition_[0], eyePosition_[1], part);
#endif
#endif
#ifdef COLORS
  vertexColor = mix(vertexColor_[0], vertexColor_[1], part);
#endif
#ifdef FOG
  fogPlace = mix(fogPlace_[0], fogPlace_[1], part);
#endif
#ifdef PLANES
  cutOff(mix(cutPlace_[0], cutPlace_[1], part));
#endif
}

#ifdef ENDED
// An arrow's head whose tip is there. Length and half its breadth in pixels: of wide lines, wider.
void head(float part, vec4 tip, vec2 ahead) {
  float size = max(9.0, 4.0 * stroke[0].x);
  vec2 side = vec2(-ahead.y, ahead.x) * 0.4 * size;
  onLine = vec2(0.0);
  lineLength = 1.0;
  corner(part, tip, vec2(0.0));
  EmitVertex();
  corner(part, tip, side - ahead * size);
  EmitVertex();
  corner(part, tip, -side - ahead * size);
  EmitVertex();
  EndPrimitive();
}

// A round dot, three times as wide as the line: a line without length, seen larger.
void dot(float part, vec4 middle) {
  float size = max(3.5, 1.5 * stroke[0].x);
  for (int i = 0; i < 4; i++) {
    vec2 at = vec2((i & 1) == 1 ? 1.0 : -1.0, (i & 2) == 0 ? -1.0 : 1.0);
    onLine = at * 0.5 * stroke[0].x;
    lineLength = 0.0;
    corner(part, middle, at * size);
    EmitVertex();
  }
  EndPrimitive();
}
#endif

void main() {
  vec4 a = gl_in[0].gl_Position;
  vec4 b = gl_in[1].gl_Position;
  // What lies before the near plane has no place in the picture.
  float fromNear = a.z + a.w;
  float toNear = b.z + b.w;
  if (fromNear <= 0.0 && toNear <= 0.0) {
    return;
  }
  float cut = fromNear / (fromNear - toNear);
  float from = fromNear < 0.0 ? cut : 0.0;
  float to = toNear < 0.0 ? cut : 1.0;
  vec4 p = mix(a, b, from);
  vec4 q = mix(a, b, to);
  vec2 line = (q.xy / q.w - p.xy / p.w) * 0.5 * stroke[0].yz;
  float size = length(line);
  vec2 ahead = size > 1e-6 ? line / size : vec2(1.0, 0.0);
  vec2 side = vec2(-ahead.y, ahead.x) * 0.5 * stroke[0].x;
#ifdef PATTERN
  // Units of the pattern per length along the line: a power of two, the same for all stretches of a
  // line that are seen at about the same size, so that the pattern goes on around corners.
  float start = mix(along_[0], along_[1], from);
  float end = mix(along_[0], along_[1], to);
  float unit = max(1.0, 0.5 * stroke[0].x);
  float scale = exp2(round(log2(max(size, 1e-6) / unit / max(end - start, 1e-12))));
  vec2 cap = vec2(0.0);
#ifdef BREAK
  float half_ = 0.5 * stroke[0].x + 5.0 * unit;
  side = vec2(-ahead.y, ahead.x) * half_;
#endif
#else
  vec2 cap = ahead * 0.5 * stroke[0].x;
#endif
  vec2 fromCap = -cap;
  vec2 toCap = cap;
#ifdef ENDED
  // Under an arrow's head the line ends, so that the head has a sharp tip.
  int type = int(stroke[0].w);
  bool first = along_[0] < 0.0 && from == 0.0;
  bool last = along_[1] > 0.0 && to == 1.0;
  vec2 under = -ahead * min(0.5 * max(9.0, 4.0 * stroke[0].x), size);
  toCap = last && type != 7 ? under : toCap;
  fromCap = first && type == 8 ? -under : fromCap;
  if (last && type == 7) {
    dot(to, q);
  } else if (last) {
    head(to, q, ahead);
  }
  if (first && type == 8) {
    head(from, p, -ahead);
  }
#endif
  for (int i = 0; i < 4; i++) {
    bool far = (i & 1) == 1;
    float beside = (i & 2) == 0 ? -1.0 : 1.0;
#ifdef PATTERN
    pattern = (far ? end : start) * scale;
#ifdef BREAK
    across = beside * half_;
#endif
#else
    onLine = vec2(far ? size + 0.5 * stroke[0].x : -0.5 * stroke[0].x, beside * 0.5 * stroke[0].x);
    lineLength = size;
#endif
    corner(far ? to : from, far ? q : p, beside * side + (far ? toCap : fromCap));
    EmitVertex();
  }
  EndPrimitive();
}

// Which pixels of a line's rectangle are the line's own: see line.geom.glsl.
#ifdef PATTERN
noperspective in float pattern;
#ifdef BREAK
noperspective in float across;
#endif
#else
noperspective in vec2 onLine;
flat in float lineLength;
#endif

#ifdef BREAK
// How far a break line lies beside the straight one, in pixels, and how steep it is there:
// freehand (14) or straight with zigzags (15).
vec2 breakAt(float at) {
  if (int(stroke[0].w) == 14) {
    return vec2(
        2.5 * sin(at * 0.16) + 1.2 * sin(at * 0.41 + 1.0),
        0.4 * cos(at * 0.16) + 0.492 * cos(at * 0.41 + 1.0));
  }
  float part = mod(at, 48.0) - 36.0;
  if (part < 0.0) {
    return vec2(0.0);
  }
  return part < 3.0 ? vec2(1.6 * part, 1.6)
      : part < 9.0 ? vec2(1.6 * (6.0 - part), -1.6)
      : vec2(1.6 * (part - 12.0), 1.6);
}
#endif

bool onStroke() {
#ifdef BREAK
  float unit = max(1.0, 0.5 * stroke[0].x);
  vec2 wave = breakAt(pattern);
  return abs(across - wave.x * unit) <= 0.5 * stroke[0].x * sqrt(1.0 + wave.y * wave.y);
#elif defined(PATTERN)
  int bit = int(floor(mod(pattern, 16.0)));
  return (int(stroke[0].w) >> bit & 1) == 1;
#else
  float beyond = max(max(-onLine.x, onLine.x - lineLength), 0.0);
  return beyond * beyond + onLine.y * onLine.y <= 0.25 * stroke[0].x * stroke[0].x
      || beyond == 0.0;
#endif
}

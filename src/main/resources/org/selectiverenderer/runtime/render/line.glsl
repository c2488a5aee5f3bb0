// Which pixels of a line's rectangle are the line's own: see line.geom.glsl.
#ifdef PATTERN
noperspective in float pattern;
#else
noperspective in vec2 onLine;
flat in float lineLength;
#endif

bool onStroke() {
#ifdef PATTERN
  int bit = int(floor(mod(pattern, 16.0)));
  return (int(stroke[0].w) >> bit & 1) == 1;
#else
  float beyond = max(max(-onLine.x, onLine.x - lineLength), 0.0);
  return beyond * beyond + onLine.y * onLine.y <= 0.25 * stroke[0].x * stroke[0].x
      || beyond == 0.0;
#endif
}

// Lines over areas, in pixels of the picture (X3D 4.0, 12.4.3). stroke[0] is the hatch's colour and
// its style: 1 horizontal, 2 vertical, 3 rising, 4 falling, 5 both upright, 6 both slanting.
const float HATCH_PERIOD = 8.0;

bool hatchLine(float across) {
  return mod(across, HATCH_PERIOD) < 1.0;
}

bool onHatch(vec2 at) {
  const float SLANT = 0.70710678;
  int style = int(stroke[0].w);
  bool level = (style == 1 || style == 5) && hatchLine(at.y);
  bool upright = (style == 2 || style == 5) && hatchLine(at.x);
  bool rising = (style == 3 || style == 6) && hatchLine((at.y - at.x) * SLANT);
  bool falling = (style == 4 || style == 6) && hatchLine((at.y + at.x) * SLANT);
  return level || upright || rising || falling;
}

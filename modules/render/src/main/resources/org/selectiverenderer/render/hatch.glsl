// Lines over areas, in pixels of the picture (X3D 4.0, 12.4.3). stroke[0] is the hatch's colour and
// its style. The styles from 7 on are section linings of materials, which the International
// Register of Graphical Items (ISO/IEC 9973) names; their measures are our own.
const float HATCH_PERIOD = 8.0;

bool every(float across, float period, float thick) {
  return mod(across, period) < thick;
}

bool hatchLine(float across) {
  return every(across, HATCH_PERIOD, 1.0);
}

// A number 0..1 of a cell that looks like chance.
float chance(vec2 cell) {
  return fract(sin(dot(cell, vec2(12.9898, 78.233))) * 43758.5453);
}

bool onHatch(vec2 at) {
  const float SLANT = 0.70710678;
  float u = (at.y - at.x) * SLANT; // Across lines that rise to the right.
  float v = (at.y + at.x) * SLANT; // Along them.
  switch (int(stroke[0].w)) {
    case 1: // Horizontal
      return hatchLine(at.y);
    case 2: // Vertical
      return hatchLine(at.x);
    case 4: // Falling
      return hatchLine(v);
    case 5: // Both upright
      return hatchLine(at.y) || hatchLine(at.x);
    case 6: // Both slanting
      return hatchLine(u) || hatchLine(v);
    case 8: // Steel: pairs of lines
      return every(u, 12.0, 1.0) || every(u - 4.0, 12.0, 1.0);
    case 9: // Bronze, brass, copper: whole and dashed lines in turn
      return every(u, 12.0, 1.0) || every(u - 6.0, 12.0, 1.0) && every(v, 9.0, 6.0);
    case 10: // White metal, zinc, lead: a narrow cross
      return every(u, 6.0, 1.0) || every(v, 6.0, 1.0);
    case 11: // Magnesium, aluminium: lines, and dashes across every other gap
      return hatchLine(u) || hatchLine(v) && every(u, 2.0 * HATCH_PERIOD, HATCH_PERIOD);
    case 12: // Rubber, plastic, electrical insulation: thick and thin lines in turn
      return every(u, 12.0, 3.0) || every(u - 7.0, 12.0, 1.0);
    case 13: // Cork, felt, fabric, leather, fibre: wavy lines
      return every(u + 1.5 * sin(v * 0.7), HATCH_PERIOD, 1.3);
    case 14: // Thermal insulation: rows of zigzag
      return every(at.y - abs(mod(at.x, 12.0) - 6.0), 12.0, 1.4);
    case 15: // Titanium, refractory material: two whole lines and a dashed one
      return every(u, 15.0, 1.0)
          || every(u - 5.0, 15.0, 1.0)
          || every(u - 10.0, 15.0, 1.0) && every(v, 8.0, 5.0);
    case 16: // Marble, slate, porcelain, glass: lines with gaps, shifted from one to the next
      return hatchLine(u) && every(v + 7.0 * floor(u / HATCH_PERIOD), 16.0, 10.0);
    case 17: { // Earth: tufts of three strokes, lying and standing in turn
      vec2 cell = floor(at / 12.0);
      vec2 in12 = mod(at, 12.0);
      bool standing = mod(cell.x + cell.y, 2.0) >= 1.0;
      float across = standing ? in12.x : in12.y;
      float along = standing ? in12.y : in12.x;
      return along < 9.0 && every(across, 4.0, 1.0);
    }
    case 18: { // Sand: dots anywhere
      vec2 cell = floor(at / 4.0);
      vec2 dot = floor(vec2(chance(cell), chance(cell + 17.0)) * 4.0);
      return chance(cell + 5.0) < 0.6 && floor(mod(at, 4.0)) == dot;
    }
    case 19: // Dots in rows
      return every(at.x, HATCH_PERIOD, 2.0) && every(at.y, HATCH_PERIOD, 2.0);
    default: // 3, rising; 7, iron and any material, looks the same
      return hatchLine(u);
  }
}

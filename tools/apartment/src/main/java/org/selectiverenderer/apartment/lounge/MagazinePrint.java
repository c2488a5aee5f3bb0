package org.selectiverenderer.apartment.lounge;

import org.joml.Vector3d;

/** The print layout of the open magazine, in x and z of the flat sheet, metres from its middle. */
final class MagazinePrint {

  private MagazinePrint() {}

  /** Returns whether a point lies in the picture, which fills the left page up to a margin. */
  static boolean isPicture(Vector3d p) {
    return within(p, -0.192, -0.018, -0.124, 0.09);
  }

  static boolean isFloor(Vector3d p) {
    return isPicture(p) && p.z > 0.03 && !isSofa(p) && !isLamp(p);
  }

  static boolean isWall(Vector3d p) {
    return isPicture(p) && p.z <= 0.03 && !isSofa(p) && !isLamp(p);
  }

  /** Returns whether a point lies in the printed sofa: a back, a seat, two arms. */
  static boolean isSofa(Vector3d p) {
    return within(p, -0.13, -0.036, -0.018, 0.012)
        || within(p, -0.145, -0.024, 0.012, 0.052)
        || within(p, -0.145, -0.13, -0.003, 0.012)
        || within(p, -0.036, -0.024, -0.003, 0.012);
  }

  /** Returns whether a point lies in the printed lamp or the picture on the wall. */
  static boolean isLamp(Vector3d p) {
    return within(p, -0.182, -0.154, -0.075, -0.045)
        || within(p, -0.1705, -0.1645, -0.045, 0.045)
        || within(p, -0.11, -0.056, -0.095, -0.05);
  }

  static boolean isTitle(Vector3d p) {
    return within(p, 0.02, 0.19, -0.124, -0.092);
  }

  static boolean isType(Vector3d p) {
    return isTitle(p) || isText(p) || isPhotograph(p);
  }

  /**
   * Returns whether a point lies in the text: two columns of lines, the last line of each paragraph
   * short.
   */
  static boolean isText(Vector3d p) {
    int row = (int) Math.floor((p.z + 0.08) / 0.002 + 1e-6);
    int line = row / 5;
    if (row < 0 || row % 5 > 1 || line > 11) {
      return false;
    }
    double left = line % 6 == 5 ? 0.06 : 0.1;
    double right = line % 6 == 3 ? 0.15 : 0.19;
    return within(p, 0.02, left, -0.08, 0.05) || within(p, 0.112, right, -0.08, 0.05);
  }

  static boolean isPhotograph(Vector3d p) {
    return within(p, 0.02, 0.19, 0.05, 0.122);
  }

  private static boolean within(Vector3d p, double x0, double x1, double z0, double z1) {
    return p.x > x0 && p.x < x1 && p.z > z0 && p.z < z1;
  }
}

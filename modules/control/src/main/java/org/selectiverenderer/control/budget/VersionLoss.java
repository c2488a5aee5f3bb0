package org.selectiverenderer.control.budget;

/**
 * What a version of an object loses in the picture, and how much that matters: the loss is the area
 * of the picture that is wrong, times the weight of the object.
 *
 * <p>A smooth surface that is approximated as well as possible by <i>n</i> triangles is off by a
 * share of its size that falls with 1/<i>n</i> (Gruber, "Asymptotic estimates for best and stepwise
 * approximation of convex bodies", Forum Mathematicum 1993; L. Fejes Toth before him). In the
 * picture the error is a band of that width along the object's outline, so its area is the area
 * that the object covers, times 1/<i>n</i>. A box in place of a chair of 10,000 triangles therefore
 * loses much, and half of the chair's triangles hardly anything. Whether a certain simplification
 * is as good as that is not known here: only the triangles are counted.
 */
public final class VersionLoss {
  /** The share that counts of an object that is fully expected where it is. */
  private static final double CONSISTENT = 0.1;

  /** The share that counts of an object out of view, which may come into it at any moment. */
  private static final double OUT_OF_VIEW = 1.0 / 4;

  /** The smallest angle that the eye resolves where it looks: a cycle of 1/48 of a degree. */
  private static final double SHARPEST = 1.0 / 48;

  /** By how many degrees that angle grows with each degree away from there. */
  private static final double BLUR = 0.022;

  private VersionLoss() {}

  /**
   * Returns the share of the object's area in the picture that is wrong: 1 for a version without
   * triangles, 0 in the limit of infinitely many.
   *
   * @param triangles at least 0
   */
  public static double ofTriangles(long triangles) {
    return 1.0 / (1 + triangles);
  }

  /**
   * Returns how much an object's consistency with the active schemas lets its losses count: all of
   * them if it is inconsistent, a tenth if it is fully consistent, in proportion between (thesis
   * 4.2.1 and 7.2).
   *
   * @param degree from 0, inconsistent, to 1
   */
  public static double weightOfConsistency(double degree) {
    return 1 - (1 - CONSISTENT) * degree;
  }

  /**
   * Returns the size of a sphere around the object as the viewer sees it: its solid angle as a
   * share of that of a sphere around the viewer. The solid angle is that of the disc, which is
   * exact for a small or distant sphere.
   *
   * @param radius of the sphere, at least 0
   * @param distance of its middle from the eye, in the same unit
   */
  public static double sizeInView(double radius, double distance) {
    return 0.25 * Math.min(1, radius * radius / (distance * distance));
  }

  /**
   * Returns how much it counts whether an object is in view.
   *
   * @param inView whether some of it may be
   */
  public static double weightOfView(boolean inView) {
    return inView ? 1 : OUT_OF_VIEW;
  }

  /**
   * Returns how much less counts what is away from where the eyes look: the finest detail that the
   * eye resolves grows in proportion to the eccentricity (Guenter et al., "Foveated 3D graphics",
   * ACM Transactions on Graphics 31, 2012).
   *
   * @param eccentricity degrees between the gaze and the nearest of the object, at least 0
   */
  public static double weightOfGaze(double eccentricity) {
    return SHARPEST / (SHARPEST + BLUR * eccentricity);
  }
}

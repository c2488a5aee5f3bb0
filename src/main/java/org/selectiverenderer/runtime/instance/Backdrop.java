package org.selectiverenderer.runtime.instance;

/**
 * What is seen behind everything: sky and ground gradients of the bound Background (X3D 4.0,
 * 24.4.1).
 *
 * @param skyColor r, g, b triples, the first at the zenith
 * @param skyAngle radians from the zenith of the second and later sky colours
 * @param groundColor r, g, b triples, the first at the nadir; empty when there is no ground
 * @param groundAngle radians from the nadir of the second and later ground colours
 * @param transparency 0..1
 */
public record Backdrop(
    float[] skyColor,
    float[] skyAngle,
    float[] groundColor,
    float[] groundAngle,
    float transparency) {

  /** The standard's default: black. */
  public static final Backdrop BLACK =
      new Backdrop(new float[3], new float[0], new float[0], new float[0], 0);

  /** Whether one colour fills it. */
  public boolean plain() {
    return skyColor.length == 3 && groundColor.length == 0;
  }
}

package org.selectiverenderer.runtime.instance;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;

/**
 * What is seen behind everything: sky and ground gradients of the bound background (X3D 4.0,
 * 24.4.1), and before them the pictures of a cube around the viewer (24.2.1).
 *
 * @param skyColor r, g, b triples, the first at the zenith
 * @param skyAngle radians from the zenith of the second and later sky colours
 * @param groundColor r, g, b triples, the first at the nadir; empty when there is no ground
 * @param groundAngle radians from the nadir of the second and later ground colours
 * @param transparency 0..1
 * @param pictures of the sides that have one
 * @param turn takes the background's directions to the world's
 */
public record Backdrop(
    float[] skyColor,
    float[] skyAngle,
    float[] groundColor,
    float[] groundAngle,
    float transparency,
    Map<Side, Texture.Image> pictures,
    Quaterniondc turn) {

  /** The sides of the cube; the front lies along -Z, the top along +Y. */
  public enum Side {
    FRONT,
    BACK,
    LEFT,
    RIGHT,
    TOP,
    BOTTOM;

    /** The field of a Background that names its picture. */
    public String urlField() {
      return name().toLowerCase(Locale.ROOT) + "Url";
    }

    /** The field of a TextureBackground that holds its texture. */
    public String textureField() {
      return name().toLowerCase(Locale.ROOT) + "Texture";
    }
  }

  /** The standard's default: black. */
  public static final Backdrop BLACK =
      new Backdrop(new float[3], new float[0], new float[0], new float[0], 0);

  /** Without pictures, and upright in the world. */
  public Backdrop(
      float[] skyColor,
      float[] skyAngle,
      float[] groundColor,
      float[] groundAngle,
      float transparency) {
    this(
        skyColor,
        skyAngle,
        groundColor,
        groundAngle,
        transparency,
        new EnumMap<>(Side.class),
        new Quaterniond());
  }

  /** Whether one colour fills it, but for the pictures. */
  public boolean plain() {
    return skyColor.length == 3 && groundColor.length == 0;
  }
}

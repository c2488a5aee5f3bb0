package org.selectiverenderer.browser.instance;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;

/**
 * The bound background, drawn behind everything else: sky and ground gradients (X3D 4.0, 24.4.1),
 * and in front of them the images of a cube around the viewer (24.2.1).
 *
 * @param skyColor the sky colours as r, g, b triples, the first at the zenith
 * @param skyAngle the angles of the second and later sky colours from the zenith, in radians
 * @param groundColor the ground colours as r, g, b triples, the first at the nadir; empty if there
 *     is no ground
 * @param groundAngle the angles of the second and later ground colours from the nadir, in radians
 * @param transparency the transparency, 0..1
 * @param pictures the images of the cube's sides that have one
 * @param turn the rotation from the background's coordinates to the world
 */
public record Background(
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

    /** Returns the field of a Background that holds the url of this side's image. */
    public String urlField() {
      return name().toLowerCase(Locale.ROOT) + "Url";
    }

    /** Returns the field of a TextureBackground that holds this side's texture. */
    public String textureField() {
      return name().toLowerCase(Locale.ROOT) + "Texture";
    }
  }

  /** The standard's default: black. */
  public static final Background BLACK =
      new Background(new float[3], new float[0], new float[0], new float[0], 0);

  /** Makes a background without images, upright in the world. */
  public Background(
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

  /** Returns whether the gradients are a single colour. */
  public boolean plain() {
    return skyColor.length == 3 && groundColor.length == 0;
  }
}

package org.selectiverenderer.render.gpu;

import java.util.ArrayList;
import java.util.List;

/**
 * The effects of a shader program besides colour and lighting: strokes and hatches, fog, clip
 * planes, environment light. Programs of scenes without them do not contain their code.
 *
 * @param fogDepth the index of the fog depth attribute (FogCoordinate) after the texture
 *     coordinates; -1 where the fog depth is the distance from the eye
 * @param planes the number of clip planes, at most {@link #MAX_PLANES}
 * @param around the environment light
 */
public record ShaderEffects(
    StrokeStyle stroke, Mist mist, int fogDepth, int planes, Around around) {
  /**
   * The most clip planes of a shape: the number that every OpenGL 3.3 has; further ones are
   * ignored.
   */
  public static final int MAX_PLANES = 8;

  /** No effects. */
  public static final ShaderEffects NONE =
      new ShaderEffects(StrokeStyle.PLAIN, Mist.CLEAR, -1, 0, Around.DARK);

  /** The function by which fog increases with distance. */
  public enum Mist {
    CLEAR,
    LINEAR,
    EXPONENTIAL
  }

  /** The kind of environment light (EnvironmentLight). */
  public enum Around {
    DARK,
    /** Diffuse light without a reflected image. */
    SMOOTH,
    IMAGE
  }

  List<String> defines() {
    List<String> defines = new ArrayList<>(stroke.defines());
    if (mist != Mist.CLEAR) {
      defines.add("FOG");
    }
    if (mist != Mist.CLEAR && fogDepth >= 0) {
      defines.add("FOG_DEPTH " + (4 + fogDepth));
    }
    if (mist == Mist.EXPONENTIAL) {
      defines.add("EXPONENTIAL");
    }
    if (planes > 0) {
      defines.add("PLANES " + planes);
    }
    if (around != Around.DARK) {
      defines.add("ENVIRONMENT");
    }
    if (around == Around.IMAGE) {
      defines.add("ENVIRONMENT_IMAGE");
    }
    return defines;
  }
}

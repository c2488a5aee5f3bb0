package org.selectiverenderer.runtime.render.gpu;

import java.util.ArrayList;
import java.util.List;

/**
 * What a program does beside colour and light: lines and hatches, fog, planes that cut. Programs of
 * scenes without them know nothing of it.
 *
 * @param fogDepth where vertices say how deep in fog they are, counted from the first attribute
 *     after the texture coordinates; -1 where that is how far they are from the eye
 * @param planes that cut, at most {@link #MAX_PLANES}
 * @param around light from all around
 */
public record Scenery(StrokeForm stroke, Mist mist, int fogDepth, int planes, Around around) {
  /** Planes that can cut one shape, as many as every OpenGL 3.3 has; those beyond do not cut. */
  public static final int MAX_PLANES = 8;

  /** Nothing of all that. */
  public static final Scenery NONE = new Scenery(StrokeForm.PLAIN, Mist.CLEAR, -1, 0, Around.DARK);

  /** How fog thickens with distance. */
  public enum Mist {
    CLEAR,
    LINEAR,
    EXPONENTIAL
  }

  /** Light from all around. */
  public enum Around {
    DARK,
    /** Without an image that is mirrored. */
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

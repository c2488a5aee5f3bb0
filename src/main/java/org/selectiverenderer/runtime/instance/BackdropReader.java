package org.selectiverenderer.runtime.instance;

import java.util.Arrays;
import org.selectiverenderer.runtime.scene.Node;

/** Reads a Background or TextureBackground node (X3D 4.0, 24.2.1); its images are left out. */
public final class BackdropReader {
  private BackdropReader() {}

  /**
   * The gradients of a background. Angles without a colour and colours without an angle are left
   * out.
   */
  public static Backdrop read(Node background) {
    float[] sky = background.floats("skyColor");
    float[] ground = background.floats("groundColor");
    float[] skyAngle = background.floats("skyAngle");
    float[] groundAngle = background.floats("groundAngle");
    int skyBands = Math.min(sky.length / 3 - 1, skyAngle.length);
    int groundBands = Math.min(ground.length / 3 - 1, groundAngle.length);
    return new Backdrop(
        skyBands < 0 ? Backdrop.BLACK.skyColor() : Arrays.copyOf(sky, 3 * (skyBands + 1)),
        Arrays.copyOf(skyAngle, Math.max(0, skyBands)),
        groundBands < 0 ? new float[0] : Arrays.copyOf(ground, 3 * (groundBands + 1)),
        Arrays.copyOf(groundAngle, Math.max(0, groundBands)),
        background.number("transparency"));
  }
}

package org.selectiverenderer.hmd;

import org.selectiverenderer.runtime.camera.MirrorSide;

/**
 * How a scene is shown in a headset.
 *
 * @param seated whether the user sits: his eyes are as high as the scene says; else as high above
 *     its floor as they really are
 * @param size how large he is in the scene: 2 for one who finds everything half as large
 * @param turnStep radians that a controller's stick turns by at once; 0 to turn as long as it is
 *     pushed
 * @param mirror what of his pictures is shown on the desk
 * @param layout what the runtime tells of the eyes, in each frame anew
 */
public record HeadsetShown(
    boolean seated, double size, double turnStep, MirrorSide mirror, HeadsetLayout layout) {
  /** Standing, as large as one is, turning by steps of 30 degrees. */
  public static HeadsetShown standing() {
    return new HeadsetShown(false, 1, Math.toRadians(30), MirrorSide.BOTH, new HeadsetLayout(1));
  }
}

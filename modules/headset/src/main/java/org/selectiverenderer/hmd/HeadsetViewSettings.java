package org.selectiverenderer.hmd;

import org.selectiverenderer.browser.camera.MirroredEye;

/**
 * Options for showing a scene in a headset.
 *
 * @param seated whether the user sits, with the eyes at the scene's avatar height; otherwise the
 *     eyes are as high above the scene's floor as in reality
 * @param size the size of the user relative to the scene: with 2 everything appears half as large
 * @param turnStep the angle in radians by which a push of the controller's stick turns at once
 *     (snap turn); 0 for smooth turning
 * @param mirror which eyes the mirror window on the desktop shows
 * @param layout the layout of the eyes, which the runtime updates in each frame
 */
public record HeadsetViewSettings(
    boolean seated, double size, double turnStep, MirroredEye mirror, HeadsetLayout layout) {
  /** Returns the options of a standing user at true scale who turns by steps of 30 degrees. */
  public static HeadsetViewSettings standing() {
    return new HeadsetViewSettings(
        false, 1, Math.toRadians(30), MirroredEye.BOTH, new HeadsetLayout(1));
  }
}

package org.selectiverenderer.experiment.headlog;

/**
 * Where the eyes look in a frame, as the eye tracker of a headset tells it, and what is there.
 *
 * @param tracked whether the eye tracker sees the eyes; where it does not, as in a blink, the rest
 *     is unknown
 * @param yaw degrees from straight ahead of the head, positive to the left; NaN when unknown
 * @param pitch degrees above straight ahead of the head; NaN when unknown
 * @param object that the eyes look at, by the name that {@link SceneObjects} gives it; empty for
 *     none
 * @param distance of its surface, in the scene's unit; NaN for none
 * @param version the choice that its Switch shows, -1 when no Switch holds it
 */
public record EyeSample(
    boolean tracked, double yaw, double pitch, String object, double distance, int version) {
  /** The eye tracker does not see the eyes. */
  public static final EyeSample LOST =
      new EyeSample(false, Double.NaN, Double.NaN, "", Double.NaN, -1);
}

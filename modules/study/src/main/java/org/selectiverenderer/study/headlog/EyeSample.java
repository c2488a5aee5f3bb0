package org.selectiverenderer.study.headlog;

/**
 * The gaze of a frame: the direction that the eye tracker of a headset reports, and the object that
 * it hits.
 *
 * @param tracked whether the eye tracker sees the eyes; if not, as in a blink, the rest is unknown
 * @param yaw degrees from straight ahead of the head, positive to the left; NaN when unknown
 * @param pitch degrees above straight ahead of the head; NaN when unknown
 * @param object name of the object that the gaze hits; empty for none
 * @param distance from the eyes to the object's surface along the gaze, in the scene's unit; NaN
 *     for none
 * @param version whichChoice of the object's Switch; -1 if no Switch holds it
 */
public record EyeSample(
    boolean tracked, double yaw, double pitch, String object, double distance, int version) {
  /** A sample in which the eye tracker does not see the eyes. */
  public static final EyeSample LOST =
      new EyeSample(false, Double.NaN, Double.NaN, "", Double.NaN, -1);
}

package org.selectiverenderer.openxr;

/**
 * The status of a headset; immutable.
 *
 * @param runtime name and version of the runtime; empty before the first
 * @param headset name of the headset; empty before the first
 * @param visible whether the user sees the scene
 * @param lost whether the runtime was lost and is being looked for
 * @param rate frame rate of the headset in frames per second; 0 before the first frame
 * @param frames number of frames due so far
 * @param missed number of frames that were not ready in time
 * @param leadMs milliseconds from the prediction of a pose to its display time; 0 if unknown
 */
public record XrHeadsetStatus(
    String runtime,
    String headset,
    boolean visible,
    boolean lost,
    double rate,
    long frames,
    long missed,
    double leadMs) {
  /** The status before the first frame. */
  public static final XrHeadsetStatus NONE = new XrHeadsetStatus("", "", false, false, 0, 0, 0, 0);
}

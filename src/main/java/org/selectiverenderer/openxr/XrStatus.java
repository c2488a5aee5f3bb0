package org.selectiverenderer.openxr;

/**
 * How a headset does; a value for any thread.
 *
 * @param runtime name and version; empty while there is none
 * @param headset its name; empty while there is none
 * @param visible whether the user sees the scene
 * @param lost whether the runtime is gone and being looked for
 * @param rate frames per second at which the headset wants them; 0 before the first
 * @param frames due so far
 * @param missed frames that were not ready in time
 * @param leadMs milliseconds from the pose's being asked for to the time that it was predicted for;
 *     0 when unknown
 */
public record XrStatus(
    String runtime,
    String headset,
    boolean visible,
    boolean lost,
    double rate,
    long frames,
    long missed,
    double leadMs) {
  /** Nothing is known yet. */
  public static final XrStatus NONE = new XrStatus("", "", false, false, 0, 0, 0, 0);
}

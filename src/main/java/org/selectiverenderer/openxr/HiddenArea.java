package org.selectiverenderer.openxr;

/**
 * The part of an eye's picture that its lens does not show ({@code XR_KHR_visibility_mask}).
 *
 * @param corners x, y of each, as tangents of angles from the eye's axis; not written to
 * @param triangles three numbers of corners each; not written to
 */
@SuppressWarnings("ArrayRecordComponent")
public record HiddenArea(float[] corners, int[] triangles) {
  /** All is seen. */
  public static final HiddenArea NONE = new HiddenArea(new float[0], new int[0]);

  /** Whether there is none. */
  public boolean isEmpty() {
    return triangles.length == 0;
  }
}

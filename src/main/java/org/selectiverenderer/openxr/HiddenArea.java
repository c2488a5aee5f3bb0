package org.selectiverenderer.openxr;

/**
 * The part of an eye's picture that its lens does not show ({@code XR_KHR_visibility_mask}).
 *
 * @param corners x and y of each corner of triangles, six numbers each: tangents of angles from the
 *     eye's axis, right and up; not written to
 */
@SuppressWarnings("ArrayRecordComponent")
public record HiddenArea(float[] corners) {
  /** All is seen. */
  public static final HiddenArea NONE = new HiddenArea(new float[0]);
}

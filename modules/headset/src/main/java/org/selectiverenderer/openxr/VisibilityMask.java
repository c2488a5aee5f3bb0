package org.selectiverenderer.openxr;

/**
 * The visibility mask of an eye: the part of its picture that the lens hides ({@code
 * XR_KHR_visibility_mask}).
 *
 * @param corners triangles of six numbers each, x and y of the corners: tangents of angles from the
 *     eye's axis to the right and up; must not be modified
 */
@SuppressWarnings("ArrayRecordComponent")
public record VisibilityMask(float[] corners) {
  /** A mask that hides nothing. */
  public static final VisibilityMask NONE = new VisibilityMask(new float[0]);
}

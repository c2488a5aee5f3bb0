package org.selectiverenderer.browser.camera;

/**
 * The hidden area mesh of a view: triangles over pixels that a headset's lens does not show. They
 * stay black and are not shaded.
 *
 * @param corners x and y of the triangles' corners, six numbers per triangle, from -1 (left,
 *     bottom) to 1 (right, top) of the view; not to be changed
 */
@SuppressWarnings("ArrayRecordComponent")
public record HiddenAreaMesh(float[] corners) {
  /** No hidden area. */
  public static final HiddenAreaMesh NONE = new HiddenAreaMesh(new float[0]);
}

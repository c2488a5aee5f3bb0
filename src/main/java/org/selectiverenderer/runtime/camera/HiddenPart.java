package org.selectiverenderer.runtime.camera;

/**
 * The part of a view that nobody sees, as behind the edge of a lens: black, and not worth drawing.
 *
 * @param corners x and y of each corner of triangles, six numbers each, from -1 (left, bottom) to 1
 *     (right, top) of the view; not written to
 */
@SuppressWarnings("ArrayRecordComponent")
public record HiddenPart(float[] corners) {
  /** All is seen. */
  public static final HiddenPart NONE = new HiddenPart(new float[0]);
}

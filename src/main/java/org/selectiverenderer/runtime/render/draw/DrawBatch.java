package org.selectiverenderer.runtime.render.draw;

import org.joml.Matrix4dc;

/**
 * Shapes that lie in one pair of buffers and are drawn by one call. Between frames it is a value;
 * within one, {@link Culler} strings its visible items together here.
 */
final class DrawBatch {
  private final Matrix4dc place;
  private final boolean tinted;

  /** First and last of its items found visible, by their numbers; -1 for none. */
  int first = -1;

  int last = -1;

  /** The least distance of these items from an eye, as {@link Culler} writes distances. */
  int nearest = Integer.MAX_VALUE;

  /**
   * @param place from the coordinates in its buffers to the world: a translation
   * @param tinted whether its vertices have the diffuse colours of its shapes
   */
  DrawBatch(Matrix4dc place, boolean tinted) {
    this.place = place;
    this.tinted = tinted;
  }

  boolean tinted() {
    return tinted;
  }

  Matrix4dc place() {
    return place;
  }

  /** Ends the frame's list of visible items. */
  void forget() {
    first = -1;
    last = -1;
    nearest = Integer.MAX_VALUE;
  }
}

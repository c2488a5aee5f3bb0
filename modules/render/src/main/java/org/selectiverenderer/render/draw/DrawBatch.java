package org.selectiverenderer.render.draw;

import org.joml.Matrix4dc;

/**
 * Shapes whose vertices lie in one pair of buffers, so that the visible ones are drawn by one call.
 * While a frame is culled, {@link Culler} keeps the linked list of the batch's visible items here.
 */
final class DrawBatch {
  private final Matrix4dc place;
  private final boolean tinted;

  /** Indices of the first and last visible item found so far; -1 for none. */
  int first = -1;

  int last = -1;

  /** The least distance of these items from an eye, in {@link Culler}'s sortable form. */
  int nearest = Integer.MAX_VALUE;

  /**
   * @param place the translation from the coordinates in its buffers to the world
   * @param tinted whether its vertices store the diffuse colours of its shapes
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

  /** Empties the list of visible items. */
  void forget() {
    first = -1;
    last = -1;
    nearest = Integer.MAX_VALUE;
  }
}

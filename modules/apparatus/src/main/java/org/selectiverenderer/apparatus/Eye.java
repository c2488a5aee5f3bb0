package org.selectiverenderer.apparatus;

/** The left or the right eye. */
public enum Eye {
  LEFT(-1),
  RIGHT(1);

  private final int side;

  Eye(int side) {
    this.side = side;
  }

  /** Returns the side along the head's X axis: -1 or 1. */
  public int side() {
    return side;
  }
}

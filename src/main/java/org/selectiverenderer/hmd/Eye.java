package org.selectiverenderer.hmd;

/** One of the two. */
enum Eye {
  LEFT(-1),
  RIGHT(1);

  private final int side;

  Eye(int side) {
    this.side = side;
  }

  /** Where it lies along the head's X axis: -1 or 1. */
  public int side() {
    return side;
  }
}

package org.selectiverenderer.render.draw;

/** The triangles that a frame may make ready ahead of need, by the time that earlier ones took. */
final class UploadBudget {
  /**
   * The time of a frame that the upload of deferred shapes may take, in nanoseconds; and likewise
   * for shapes that are near, but that no eye has seen.
   */
  private static final double DEFERRED = 5e6;

  private static final double AHEAD = DEFERRED / 4;

  /** The triangles that are uploaded in such a time at first and at most. */
  static final int PORTION = 20_000;

  /** The measured time of making a triangle ready, in nanoseconds. */
  private double perTriangle = DEFERRED / PORTION;

  /** Returns the triangles of deferred shapes for one frame. */
  long deferred() {
    return portion(DEFERRED);
  }

  /** Returns the triangles of shapes that are near for one frame. */
  long ahead() {
    return portion(AHEAD);
  }

  private long portion(double time) {
    return Math.max(1, Math.min(PORTION, Math.round(time / perTriangle)));
  }

  /** Notes how long some triangles took, in nanoseconds. */
  void took(long triangles, long time) {
    if (triangles > 0) {
      double now = time / (double) triangles;
      perTriangle += (now - perTriangle) / 4; // One frame that was interrupted tells little.
    }
  }
}

package org.selectiverenderer.x3d.tessellate;

/** Checks which faces of an index stream can be drawn, and reports the others once per node. */
final class FaceValidator {
  private final int[] stream;
  private final CoordinatePoints points;
  private final int least;
  private int outOfRange;
  private int firstOutOfRange;
  private int notFinite;
  private int tooShort;

  /**
   * Creates a check of an index stream.
   *
   * @param least the fewest points that make a face (3) or a line (2)
   */
  FaceValidator(int[] stream, CoordinatePoints points, int least) {
    this.stream = stream;
    this.points = points;
    this.least = least;
  }

  /** Returns whether the face of stream positions {@code from} up to {@code to} can be drawn. */
  boolean accepts(int from, int to) {
    if (to - from < least) {
      tooShort++;
      return false;
    }
    for (int i = from; i < to; i++) {
      if (!inRange(stream[i])) {
        return false;
      }
    }
    return true;
  }

  /** Returns whether a triangle of three stream positions can be drawn. */
  boolean accepts(int a, int b, int c) {
    return inRange(stream[a]) && inRange(stream[b]) && inRange(stream[c]);
  }

  private boolean inRange(int index) {
    if (index < 0 || index >= points.count()) {
      if (outOfRange++ == 0) {
        firstOutOfRange = index;
      }
      return false;
    }
    boolean[] bad = points.bad();
    if (bad != null && bad[index]) {
      notFinite++;
      return false;
    }
    return true;
  }

  /**
   * Reports the refused faces.
   *
   * @param what the noun for one of them, for example {@code face}
   */
  void report(TessellationContext job, String what) {
    if (outOfRange > 0) {
      job.problem(
          "refers to point index "
              + firstOutOfRange
              + ", but the number of points is "
              + points.count()
              + "; "
              + counted(outOfRange, what)
              + " left out");
    }
    if (notFinite > 0) {
      job.problem("has points that are not finite; " + counted(notFinite, what) + " left out");
    }
    if (tooShort > 0) {
      job.problem(
          "has a "
              + what
              + " with fewer than "
              + least
              + " points; "
              + counted(tooShort, what)
              + " left out");
    }
  }

  private static String counted(int count, String what) {
    return count == 1 ? "1 " + what + " is" : count + " " + what + "s are";
  }
}

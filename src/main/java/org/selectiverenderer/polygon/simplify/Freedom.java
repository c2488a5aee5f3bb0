package org.selectiverenderer.polygon.simplify;

/** What a reduction may do to a model's structure, from the least that serves to the most. */
enum Freedom {
  /** Edges where materials, colours or texture coordinates change stay edges. */
  KEEP_SEAMS,
  /** Any edge may go, and so may small pieces. */
  ANY_EDGE,
  /** Pieces near each other may grow together first. */
  ANY_SURFACE
}

package org.selectiverenderer.polygon.simplify;

/** What a reduction may do to a model's structure, from the least that serves to the most. */
enum Freedom {
  /** Edges where materials, colours or texture coordinates change stay edges. */
  KEEP_SEAMS,
  /** Any edge may go. */
  ANY_EDGE,
  /** A piece may go as a whole when that is less of an error. */
  ANY_PIECE,
  /** The smallest pieces go before anything else. */
  FEWER_PIECES,
  /** Pieces near each other grow together first. */
  ANY_SURFACE
}

package org.selectiverenderer.models.simplify;

/**
 * How far a simplification must preserve the topology of a model, from the strictest level to the
 * loosest.
 */
enum TopologyConstraint {
  /** Edges where materials, colours or texture coordinates change are preserved. */
  KEEP_SEAMS,
  /** Any edge may collapse. */
  ANY_EDGE,
  /** A connected component may vanish as a whole where that causes less error. */
  ANY_PIECE,
  /** The smallest connected components are removed first. */
  FEWER_PIECES,
  /** Vertices near each other are clustered first, across components. */
  ANY_SURFACE
}

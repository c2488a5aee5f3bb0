package org.selectiverenderer.runtime.collide;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Numbered pieces of something that a point with a radius cannot pass. */
interface Barrier {
  int size();

  /** Writes the point of a piece that is nearest to p. */
  void nearest(int piece, Vector3dc p, Vector3d out);

  /** Whether the way from one point straight to another leads through a piece. */
  boolean crossed(int piece, Vector3dc from, Vector3dc to);

  /** Hears that a piece held the point up. */
  void touched(int piece);
}

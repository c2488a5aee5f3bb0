package org.selectiverenderer.browser.collision;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A set of obstacles for a moving sphere; each obstacle is a triangle or a segment with an index.
 */
interface ObstacleSet {
  int size();

  /** Writes the point of an obstacle that is nearest to p. */
  void nearest(int piece, Vector3dc p, Vector3d out);

  /** Returns whether the straight way from one point to another passes through an obstacle. */
  boolean crossed(int piece, Vector3dc from, Vector3dc to);

  /** Is told that an obstacle stopped the sphere. */
  void touched(int piece);
}

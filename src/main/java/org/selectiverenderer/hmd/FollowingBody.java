package org.selectiverenderer.hmd;

import org.joml.Vector3dc;
import org.selectiverenderer.runtime.viewer.Viewer;

/** The body under a tracked head, which stands in the scene: walls hold it up. */
@FunctionalInterface
public interface FollowingBody {
  /**
   * Moves the body after its head, as far as walls let it.
   *
   * @param viewer stands where the body's own eyes are, and is moved
   * @param way in the world
   * @return whether the body can walk now; one that cannot stays
   */
  boolean follow(Viewer viewer, Vector3dc way);
}

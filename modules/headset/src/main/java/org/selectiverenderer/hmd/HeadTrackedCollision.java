package org.selectiverenderer.hmd;

import org.joml.Vector3dc;
import org.selectiverenderer.browser.viewer.Viewer;

/** Moves the body under a tracked head, with collision detection: walls stop it. */
@FunctionalInterface
public interface HeadTrackedCollision {
  /**
   * Moves the body after its head, as far as walls allow.
   *
   * @param viewer the viewer at the position of the body's eyes, which is moved
   * @param way the desired translation in the world
   * @return whether the body can walk now; otherwise it stays
   */
  boolean follow(Viewer viewer, Vector3dc way);
}

package org.selectiverenderer.runtime.nodes.group;

import org.joml.Vector3dc;
import org.selectiverenderer.runtime.scene.Cascade;

/** A group whose look depends on where the viewer is: LOD, Billboard. */
public interface ViewerDependent {
  /**
   * Adapts to the viewer, once per frame.
   *
   * @param viewer the eye in the coordinates in which the node's fields are given
   * @param up the viewer's up in the same coordinates, of any length
   * @return what changed
   */
  GroupingNode.Effect view(Vector3dc viewer, Vector3dc up, Cascade cascade);
}

package org.selectiverenderer.browser.nodes.group;

import org.joml.Vector3dc;
import org.selectiverenderer.browser.scene.EventCascade;

/** A group that depends on the viewer's position: LOD, Billboard. */
public interface ViewerDependentNode {
  /**
   * Adapts the group to the viewer; called once per frame.
   *
   * @param viewer the eye in the coordinates in which the node's fields are given
   * @param up the viewer's up in the same coordinates, of any length
   * @return the effect on the group's instances
   */
  GroupingNode.Effect view(Vector3dc viewer, Vector3dc up, EventCascade cascade);
}

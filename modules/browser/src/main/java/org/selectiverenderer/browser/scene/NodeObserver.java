package org.selectiverenderer.browser.scene;

/**
 * Is notified at once that a field of a node has a new value, before routes and listeners. For
 * structures that must stay consistent with the scene, such as the instance tree; an observer must
 * not change fields.
 */
@FunctionalInterface
public interface NodeObserver {
  void changed(Node node, int field);

  /**
   * Is called when a node changes that lies in an observed node and was made when it was first
   * asked for ({@link Node#partsDeferred}). An observer that wants to hear of such nodes begins to
   * observe them now, and hears of this change too.
   *
   * @param node the observed node
   */
  default void partChanges(Node node) {}
}

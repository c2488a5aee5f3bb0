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
   * Is notified that a node in an observed one changes whose nodes were deferred: an observer that
   * wants to hear of the nodes in it begins now to observe them, and hears of this change.
   */
  default void partChanges(Node node) {}
}

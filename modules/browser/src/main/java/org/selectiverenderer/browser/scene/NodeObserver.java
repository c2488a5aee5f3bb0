package org.selectiverenderer.browser.scene;

/**
 * Is notified at once that a field of a node has a new value, before routes and listeners. For
 * structures that must stay consistent with the scene, such as the instance tree; an observer must
 * not change fields.
 */
@FunctionalInterface
public interface NodeObserver {
  void changed(Node node, int field);
}

package org.selectiverenderer.runtime.scene;

/**
 * Hears at once that a field of a node has a new value, before routes and listeners do. For what
 * must stay true to the scene (the instance tree); it may mark things, not change fields.
 */
@FunctionalInterface
public interface NodeObserver {
  void changed(Node node, int field);
}

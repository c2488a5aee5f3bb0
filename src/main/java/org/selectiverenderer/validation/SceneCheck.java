package org.selectiverenderer.validation;

/** Looks at a scene with all that it inlines. Without state: one object serves all threads. */
public interface SceneCheck {
  /** Looks at a scene, and adds what it finds. */
  void check(SceneView scene, Findings findings);
}

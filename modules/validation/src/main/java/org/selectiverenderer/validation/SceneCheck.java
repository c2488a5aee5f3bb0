package org.selectiverenderer.validation;

/**
 * A check of a scene with all that it inlines. Implementations are stateless: one instance serves
 * all threads.
 */
public interface SceneCheck {
  /** Checks a scene and adds the findings. */
  void check(SceneContext scene, FindingCollector findings);
}

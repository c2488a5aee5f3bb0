package org.selectiverenderer.validation;

import java.util.List;

/**
 * A check of all scenes of a run together, after they have been checked one by one. Implementations
 * are stateless.
 */
public interface CrossSceneCheck {
  /** Checks all scenes of a run and adds the findings. */
  void check(List<SceneContext> scenes, Settings settings, FindingCollector findings);

  /**
   * The settings of a run.
   *
   * @param file name in reports of the file that the settings were read from
   */
  record Settings(ValidationSettings values, String file) {}
}

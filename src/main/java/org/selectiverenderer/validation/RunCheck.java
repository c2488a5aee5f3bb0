package org.selectiverenderer.validation;

import java.util.List;

/** Looks at all scenes of a run, after they have been checked one by one. Without state. */
public interface RunCheck {
  /** Looks at all scenes of a run, and adds what it finds. */
  void check(List<SceneView> scenes, Settings settings, Findings findings);

  /**
   * The settings of a run.
   *
   * @param file as reports name the file that they were read from
   */
  record Settings(ValidationSettings values, String file) {}
}

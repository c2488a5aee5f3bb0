package org.selectiverenderer.browser.script;

import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.RunningSceneLoader;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Scene;

/** The services of the world that scripts run in. */
public interface ScriptHost {
  EventCascade cascade();

  /** Returns the receiver of errors and of what scripts print. */
  ProblemCollector problems();

  /** Returns the scene that is shown. */
  Scene scene();

  /** Returns the loader of the files that scripts name, within the limits of the scene. */
  RunningSceneLoader files();

  /** Replaces the scene that is shown from the next frame on. */
  void show(LoadedScene scene);

  /** Follows URLs with the next frame, as an Anchor beside the Script would. */
  void follow(ScriptNode script, String[] urls);
}

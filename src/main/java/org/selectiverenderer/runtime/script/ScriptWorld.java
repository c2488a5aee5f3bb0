package org.selectiverenderer.runtime.script;

import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.loading.LiveFiles;
import org.selectiverenderer.runtime.loading.LoadedScene;
import org.selectiverenderer.runtime.nodes.script.ScriptNode;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Scene;

/** What scripts may ask of the world that they run in. */
public interface ScriptWorld {
  Cascade cascade();

  /** Hears what goes wrong, and what scripts print. */
  Problems problems();

  /** The scene that is shown. */
  Scene scene();

  /** Reads what scripts name, within the bounds of the scene. */
  LiveFiles files();

  /** Shows another scene from the next frame on. */
  void show(LoadedScene scene);

  /** Goes where an Anchor with these urls that stood beside the Script leads, next frame. */
  void follow(ScriptNode script, String[] urls);
}

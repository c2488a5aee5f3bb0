package org.selectiverenderer.radiosity.output;

import java.util.IdentityHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * Numbers the files that bodies are written to: one for each instance of an Inline that holds
 * bodies, and the scene's own, in the order of their first bodies.
 */
final class OutputFileIndex {
  /** The number of a file without bodies of its own. */
  static final int NONE = -1;

  private final int[] ofBody;
  private final Map<GroupInstance, Integer> inlines = new IdentityHashMap<>();
  private int scene = NONE;
  private int count;

  private OutputFileIndex(RadiosityScene lit) {
    ofBody = new int[lit.bodies().size()];
    for (int i = 0; i < ofBody.length; i++) {
      ofBody[i] = number(lit.bodies().get(i));
    }
  }

  /** Numbers the files of a scene's bodies. */
  static OutputFileIndex of(RadiosityScene scene) {
    return new OutputFileIndex(scene);
  }

  private int number(Body body) {
    GroupInstance group = body.shape().parent();
    while (group != null && !(group.node() instanceof InlineNode)) {
      group = group.parent();
    }
    if (group == null) {
      scene = scene == NONE ? count++ : scene;
      return scene;
    }
    Integer known = inlines.get(group);
    if (known == null) {
      known = count++;
      inlines.put(group, known);
    }
    return known;
  }

  /** Returns the number of the file of each body. */
  int[] ofBodies() {
    return ofBody.clone();
  }

  int of(int body) {
    return ofBody[body];
  }

  /**
   * Returns the number of the file of an Inline's instance, or of the scene's own file.
   *
   * @param inline the Inline's instance; null for the scene
   */
  int at(@Nullable GroupInstance inline) {
    return inline == null ? scene : inlines.getOrDefault(inline, NONE);
  }
}

package org.selectiverenderer.radiosity.output;

import java.util.IdentityHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.runtime.instance.GroupInstance;
import org.selectiverenderer.runtime.nodes.group.InlineNode;

/**
 * The files that bodies are written to: one for each place of an Inline that holds some, and the
 * scene's own, by numbers in the order of their first bodies.
 */
final class FilePlaces {
  /** What has no number: no body is in that file itself. */
  static final int NONE = -1;

  private final int[] ofBody;
  private final Map<GroupInstance, Integer> inlines = new IdentityHashMap<>();
  private int scene = NONE;
  private int count;

  private FilePlaces(LightScene lit) {
    ofBody = new int[lit.bodies().size()];
    for (int i = 0; i < ofBody.length; i++) {
      ofBody[i] = number(lit.bodies().get(i));
    }
  }

  /** The files of a scene's bodies. */
  public static FilePlaces of(LightScene scene) {
    return new FilePlaces(scene);
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

  /** The number of the file of each body. */
  public int[] ofBodies() {
    return ofBody.clone();
  }

  int of(int body) {
    return ofBody[body];
  }

  /**
   * The number of the file of a place of an Inline, or of the scene's own.
   *
   * @param inline null for the scene
   */
  int at(@Nullable GroupInstance inline) {
    return inline == null ? scene : inlines.getOrDefault(inline, NONE);
  }
}

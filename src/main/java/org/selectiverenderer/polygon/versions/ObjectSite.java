package org.selectiverenderer.polygon.versions;

import java.util.List;
import org.selectiverenderer.x3d.SceneElement;

/**
 * Where an object stands in a scene.
 *
 * @param name of the object, which its files take
 */
sealed interface ObjectSite {
  String name();

  /**
   * An object without versions.
   *
   * @param elements what its versions take the place of, in document order; at least one
   */
  record Whole(String name, List<SceneElement> elements) implements ObjectSite {}

  /**
   * An object with versions.
   *
   * @param inlines the Inlines of its Switch, version 1 first
   */
  record Versioned(String name, SceneElement choice, List<SceneElement> inlines)
      implements ObjectSite {}
}

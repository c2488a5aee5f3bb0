package org.selectiverenderer.enricher.source;

import java.awt.Component;
import java.awt.Container;
import org.jspecify.annotations.Nullable;

/** Components by the names that they have for tests. */
final class NamedComponents {
  private NamedComponents() {}

  static Component find(Container in, String name) {
    Component found = search(in, name);
    if (found == null) {
      throw new AssertionError("nothing is called " + name);
    }
    return found;
  }

  private static @Nullable Component search(Container in, String name) {
    for (Component each : in.getComponents()) {
      Component found =
          name.equals(each.getName())
              ? each
              : each instanceof Container more ? search(more, name) : null;
      if (found != null) {
        return found;
      }
    }
    return null;
  }
}

package org.selectiverenderer.walkthrough.transition;

import java.util.List;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;

/**
 * One of the places of an object that changes its version.
 *
 * @param tree the layer's instances
 * @param group the instance of its Switch
 * @param shown what is drawn of the version that is shown; nothing if none is
 * @param other what is to be drawn instead
 */
record ShownObject(
    InstanceTree tree, GroupInstance group, VersionSurface shown, VersionSurface other) {
  /** Returns the version whose pixels count: the one that is shown, if anything of it is drawn. */
  VersionSurface counted() {
    return shown.isEmpty() ? other : shown;
  }

  /** Returns both versions. */
  List<VersionSurface> versions() {
    return List.of(shown, other);
  }

  /** Returns whether a shape is a part of the object, in whatever version. */
  boolean has(ShapeInstance shape) {
    for (Instance at = shape; at != null; at = at.parent()) {
      if (at == group) {
        return true;
      }
    }
    return false;
  }
}

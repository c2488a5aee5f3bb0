package org.selectiverenderer.browser.nodes.group;

import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** LOD: shows one of its children by the viewer's distance (X3D 4.0, 23.4.3). */
public final class LodNode extends GroupingNode implements ViewerDependentNode {
  private final int levelChanged;
  private final int center;
  private final int range;
  private int level;

  public LodNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    levelChanged = type.indexOf("level_changed");
    center = type.indexOf("center");
    range = type.indexOf("range");
  }

  @Override
  public boolean shows(int child) {
    return visible() && child == Math.min(level, children().size() - 1);
  }

  /**
   * Chooses the level: the number of {@code range} values that the distance reaches. Without ranges
   * the most detailed level is shown.
   */
  @Override
  public Effect view(Vector3dc viewer, Vector3dc up, EventCascade cascade) {
    float[] c = (float[]) value(center);
    double distance = viewer.distance(c[0], c[1], c[2]);
    int next = 0;
    for (float limit : (float[]) value(range)) {
      if (distance >= limit) {
        next++;
      }
    }
    if (next == level) {
      return Effect.NONE;
    }
    level = next;
    cascade.emit(this, levelChanged, next);
    return Effect.CHOICE;
  }
}

package org.selectiverenderer.runtime.nodes.group;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** Says what the viewer bumps into: its children, a proxy, or nothing (X3D 4.0, 23.4.2). */
public final class CollisionNode extends GroupingNode {
  private final int enabled;
  private final int isActive;
  private final int collideTime;

  public CollisionNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    enabled = type.indexOf("enabled");
    isActive = type.indexOf("isActive");
    collideTime = type.indexOf("collideTime");
  }

  /** Whether the viewer collides with the children or the proxy at all. */
  public boolean enabled() {
    return (Boolean) value(enabled);
  }

  /**
   * Tells it, once per frame, whether the viewer bumps into its geometry: sends {@code isActive}
   * when that changes, and before it {@code collideTime} when it begins.
   */
  public void collide(boolean colliding, Cascade cascade) {
    boolean now = colliding && enabled();
    if (now == (Boolean) value(isActive)) {
      return;
    }
    if (now) {
      emit(collideTime, cascade.time(), cascade);
    }
    emit(isActive, now, cascade);
  }

  /** What stands for the children in collisions; it is not drawn. */
  public Optional<Node> proxy() {
    return Optional.ofNullable(node("proxy"));
  }
}

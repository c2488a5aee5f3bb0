package org.selectiverenderer.browser.nodes.group;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Collision: selects the geometry that the viewer collides with: its children, a proxy, or none
 * (X3D 4.0, 23.4.2).
 */
public final class CollisionNode extends GroupingNode {
  private final int enabled;
  private final int isActive;
  private final int collideTime;

  public CollisionNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    enabled = type.indexOf("enabled");
    isActive = type.indexOf("isActive");
    collideTime = type.indexOf("collideTime");
  }

  /** Returns whether the viewer collides with the children or the proxy. */
  public boolean enabled() {
    return (Boolean) value(enabled);
  }

  /**
   * Notes, once per frame, whether the viewer collides with the node's geometry: sends {@code
   * isActive} if that has changed, and before it {@code collideTime} if a collision begins.
   */
  public void collide(boolean colliding, EventCascade cascade) {
    boolean now = colliding && enabled();
    if (now == (Boolean) value(isActive)) {
      return;
    }
    if (now) {
      emit(collideTime, cascade.time(), cascade);
    }
    emit(isActive, now, cascade);
  }

  /** Returns the geometry that replaces the children in collisions; it is not drawn. */
  public Optional<Node> proxy() {
    return Optional.ofNullable(node("proxy"));
  }
}

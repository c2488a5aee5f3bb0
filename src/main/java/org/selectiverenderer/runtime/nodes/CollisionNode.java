package org.selectiverenderer.runtime.nodes;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeType;

/** Says what the viewer bumps into: its children, a proxy, or nothing (X3D 4.0, 23.4.2). */
public final class CollisionNode extends GroupingNode {
  public CollisionNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
  }

  /** Whether the viewer collides with the children or the proxy at all. */
  public boolean enabled() {
    return bool("enabled");
  }

  /** What stands for the children in collisions; it is not drawn. */
  public Optional<Node> proxy() {
    return Optional.ofNullable(node("proxy"));
  }
}

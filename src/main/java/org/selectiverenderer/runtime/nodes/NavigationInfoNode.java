package org.selectiverenderer.runtime.nodes;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeType;

/**
 * How the viewer moves and what it is like (X3D 4.0, 23.4.4). Lengths are in the node's local
 * coordinates; sizes that the file leaves out are the standard's defaults.
 */
public final class NavigationInfoNode extends BindableNode {
  private static final float[] AVATAR = {0.25f, 1.6f, 0.75f};

  public NavigationInfoNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
  }

  /** Ways to move, the first that is known is meant: WALK, FLY, EXAMINE, LOOKAT, NONE, ANY ... */
  public List<String> types() {
    return List.of(strings("type"));
  }

  /** How near the viewer gets to geometry before it collides. */
  public float collisionDistance() {
    return avatar(0);
  }

  /** The eye's height above the ground. */
  public float height() {
    return avatar(1);
  }

  /** The height of the tallest thing that the viewer steps over. */
  public float stepHeight() {
    return avatar(2);
  }

  private float avatar(int index) {
    float[] size = floats("avatarSize");
    return index < size.length ? size[index] : AVATAR[index];
  }

  /** Metres per second. */
  public float speed() {
    return number("speed");
  }

  public boolean headlight() {
    return bool("headlight");
  }

  /** How far one sees; 0 is without limit. */
  public float visibilityLimit() {
    return number("visibilityLimit");
  }

  /** How the viewer gets to a viewpoint, the first that is known is meant. */
  public List<String> transitionTypes() {
    return List.of(strings("transitionType"));
  }

  /** Seconds to get to a viewpoint. */
  public double transitionTime() {
    return (Double) value("transitionTime");
  }
}

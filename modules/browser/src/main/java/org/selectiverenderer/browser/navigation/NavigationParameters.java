package org.selectiverenderer.browser.navigation;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * The navigation parameters of a NavigationInfo node (X3D 4.0, 23.4.4), in the bound viewpoint's
 * unit of length.
 *
 * @param modes the navigation types in the author's order of preference, at least one
 * @param radius the collision distance; above 0
 * @param height the height of the eye above the ground; above 0
 * @param step the height of the tallest obstacle that is stepped over; not negative, below {@code
 *     height}
 * @param speed the speed per second, not negative
 */
public record NavigationParameters(
    List<NavigationMode> modes, double radius, double height, double step, double speed) {

  /**
   * The default for scenes without a NavigationInfo: WALK with the standard's default avatar size.
   */
  public static final NavigationParameters WALKING =
      new NavigationParameters(
          List.of(NavigationMode.WALK, NavigationMode.ANY), 0.25, 1.6, 0.75, 1);

  public NavigationParameters {
    modes = modes.isEmpty() ? List.of(NavigationMode.ANY) : List.copyOf(modes);
    height = height > 0 && height < Double.POSITIVE_INFINITY ? height : 1.6;
    // A viewer without extent would see through walls that it touches.
    radius = Math.max(radius > 0 && radius < Double.POSITIVE_INFINITY ? radius : 0, height / 100);
    step = step > 0 ? Math.min(step, 0.95 * height) : 0;
    speed = speed > 0 && speed < Double.POSITIVE_INFINITY ? speed : 0;
  }

  /** Reads a NavigationInfo node. Values missing in avatarSize get the standard's defaults. */
  public static NavigationParameters of(NodeView navigationInfo) {
    float[] size = navigationInfo.floats("avatarSize");
    List<NavigationMode> modes = new ArrayList<>();
    for (String type : navigationInfo.strings("type")) {
      for (NavigationMode mode : NavigationMode.values()) {
        if (mode.name().equals(type)) {
          modes.add(mode);
        }
      }
    }
    return new NavigationParameters(
        modes,
        size.length > 0 ? size[0] : WALKING.radius,
        size.length > 1 ? size[1] : WALKING.height,
        size.length > 2 ? size[2] : WALKING.step,
        navigationInfo.number("speed"));
  }

  /** Returns the initial mode: the author's first one, or WALK if that is ANY. */
  public NavigationMode initial() {
    return modes.get(0) == NavigationMode.ANY ? NavigationMode.WALK : modes.get(0);
  }

  /** Returns whether the user may change to a mode. */
  public boolean allows(NavigationMode mode) {
    return modes.contains(mode) || modes.contains(NavigationMode.ANY);
  }
}

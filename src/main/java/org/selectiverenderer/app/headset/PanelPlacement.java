package org.selectiverenderer.app.headset;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.hmd.HeadsetLayout;

/**
 * The placement of a text panel in the world: upright before the head, at a comfortable distance.
 * The panel stays in place while the head turns, so that it looks like an object, and follows when
 * the user has turned or moved away from it.
 */
public final class PanelPlacement {
  /** The distance of a panel in metres, about the focal distance of headsets. */
  public static final double DISTANCE = 2;

  private static final double TURNED = Math.toRadians(50);
  private static final double GONE = 0.6;

  private final World world;
  private final HeadsetLayout layout;
  private @Nullable Vector3d stood;
  private double heading;

  /**
   * @param layout gives the scale of the user in the world
   */
  public PanelPlacement(World world, HeadsetLayout layout) {
    this.world = world;
    this.layout = layout;
  }

  /**
   * Returns the transformation from a page's plane to the world.
   *
   * @param width width of the page in its units
   * @param height height of the page in its units
   * @param metres the size of one unit of the page in metres
   */
  public Matrix4dc of(double width, double height, double metres) {
    double scale = layout.unitsPerMetre(world);
    Vector3d head = new Vector3d(world.viewer().position());
    Vector3d ahead = world.viewer().orientation().transform(new Vector3d(0, 0, -1));
    boolean level = Math.hypot(ahead.x, ahead.z) > 0.1;
    double now = level ? Math.atan2(-ahead.x, -ahead.z) : heading;
    Vector3d from = stood;
    if (from == null
        || Math.abs(Math.IEEEremainder(now - heading, 2 * Math.PI)) > TURNED
        || from.distance(head) > GONE * scale) {
      from = head;
      stood = head;
      heading = now;
    }
    double unit = metres * scale;
    return new Matrix4d()
        .translate(from)
        .rotateY(heading)
        .translate(0, 0, -DISTANCE * scale)
        .scale(unit, -unit, unit)
        .translate(-width / 2, -height / 2, 0);
  }
}

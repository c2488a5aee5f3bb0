package org.selectiverenderer.app.headset;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.hmd.HeadsetLayout;
import org.selectiverenderer.runtime.World;

/**
 * Where something to read stands in the world: upright before the head, at a distance that eyes
 * rest at. It stays there while the head turns, so that it can be looked at as a thing, and comes
 * along when the user has turned or gone away from it.
 */
public final class PanelPlace {
  /** Metres; headsets are focused at about as far. */
  public static final double DISTANCE = 2;

  private static final double TURNED = Math.toRadians(50);
  private static final double GONE = 0.6;

  private final World world;
  private final HeadsetLayout layout;
  private @Nullable Vector3d stood;
  private double heading;

  /**
   * @param layout knows how large the user is in the world
   */
  public PanelPlace(World world, HeadsetLayout layout) {
    this.world = world;
    this.layout = layout;
  }

  /**
   * Takes a page's plane to the world.
   *
   * @param width of the page in its units
   * @param height of the page in its units
   * @param metres for one of its units
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

package org.selectiverenderer.app.headset;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.hmd.HeadsetLayout;
import org.selectiverenderer.openxr.SpacePose;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.camera.Mark;
import org.selectiverenderer.runtime.camera.Panel;

/**
 * A ray in the world from a hand of the user of a headset, by which he points at a page.
 *
 * @param from in the world
 * @param way in which it goes, a unit vector
 * @param metre in the scene's unit of length
 * @param eye of the user in the world
 */
public record PanelPointer(Vector3dc from, Vector3dc way, double metre, Vector3dc eye) {
  /** Metres that a ray is drawn where it hits nothing. */
  private static final double REACH = 4;

  /** Millimetres. */
  private static final double THICK = 5;

  private static final double THIN = 3;
  private static final int COLOUR = 0xC0FFD24A;
  private static final int FAINT = 0x60FFFFFF;

  /**
   * The ray of a hand.
   *
   * @param layout knows how large the user is in the world
   * @param hand where it is and points, in the frame of the head
   */
  public static PanelPointer of(World world, HeadsetLayout layout, SpacePose hand) {
    double metre = layout.unitsPerMetre(world);
    Vector3dc head = world.viewer().position();
    Vector3d from =
        world
            .viewer()
            .orientation()
            .transform(hand.position().mul(metre, new Vector3d()))
            .add(head);
    Vector3d way =
        world
            .viewer()
            .orientation()
            .transform(hand.orientation().transform(new Vector3d(0, 0, -1)));
    return new PanelPointer(from, way, metre, new Vector3d(head));
  }

  /**
   * Where it meets the plane of a page, from its front.
   *
   * @param place takes the page's plane to the world
   * @return in the page's units; empty for nowhere
   */
  public Optional<Vector2d> on(Matrix4dc place) {
    Matrix4d back = place.invert(new Matrix4d());
    Vector3d start = back.transformPosition(from, new Vector3d());
    Vector3d along = back.transformDirection(way, new Vector3d());
    if (start.z <= 0 || along.z >= 0) {
      return Optional.empty();
    }
    double t = -start.z / along.z;
    return Optional.of(new Vector2d(start.x + t * along.x, start.y + t * along.y));
  }

  /**
   * The ray to be seen: a band that shows its broad side to the user.
   *
   * @param end where it ends in the world; empty where it hits nothing
   */
  public Panel drawn(Optional<Vector3d> end) {
    double unit = metre / 1000;
    double length = end.map(from::distance).orElse(REACH * metre) / unit;
    Vector3d across = eye.sub(from, new Vector3d()).cross(way);
    if (across.length() < 1e-9 * metre) {
      way.orthogonalizeUnit(new Vector3d(0, 1, 0), across); // It begins in the eye.
    }
    across.normalize();
    Vector3d front = way.cross(across, new Vector3d());
    Matrix4d place =
        new Matrix4d(
            unit * way.x(),
            unit * way.y(),
            unit * way.z(),
            0,
            unit * across.x,
            unit * across.y,
            unit * across.z,
            0,
            unit * front.x,
            unit * front.y,
            unit * front.z,
            0,
            from.x(),
            from.y(),
            from.z(),
            1);
    double[] band = {0, -THICK / 2, length, -THIN / 2, length, THIN / 2, 0, THICK / 2};
    return new Panel(List.of(new Mark.Area(band, end.isPresent() ? COLOUR : FAINT)), place);
  }
}

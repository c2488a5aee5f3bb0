package org.selectiverenderer.app.headset;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.hmd.HeadsetLayout;
import org.selectiverenderer.openxr.XrPose;

/**
 * A ray from the hand of a headset's user, by which the user points at a panel.
 *
 * @param from origin of the ray in world coordinates
 * @param way direction of the ray, a unit vector in world coordinates
 * @param metre a metre in the scene's unit of length
 * @param eye position of the user's eye in world coordinates
 */
public record PanelPointerRay(Vector3dc from, Vector3dc way, double metre, Vector3dc eye) {
  /** The length in metres at which a ray is drawn where it hits nothing. */
  private static final double REACH = 4;

  /** Width of the drawn ray at the hand in millimetres; {@code THIN} is the width at its end. */
  private static final double THICK = 5;

  private static final double THIN = 3;
  private static final int COLOUR = 0xC0FFD24A;
  private static final int FAINT = 0x60FFFFFF;

  /**
   * Creates the ray of a hand.
   *
   * @param layout gives the scale of the user in the world
   * @param hand pose of the hand in head coordinates
   */
  public static PanelPointerRay of(World world, HeadsetLayout layout, XrPose hand) {
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
    return new PanelPointerRay(from, way, metre, new Vector3d(head));
  }

  /**
   * Intersects the ray with the plane of a page, from the page's front.
   *
   * @param place the transformation from the page's plane to the world
   * @return the intersection in the page's units; empty if there is none
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
   * Returns the drawn ray: a band whose broad side faces the user.
   *
   * @param end end of the ray in world coordinates; empty where it hits nothing
   */
  public WorldSpacePanel drawn(Optional<Vector3d> end) {
    double unit = metre / 1000;
    double length = end.map(from::distance).orElse(REACH * metre) / unit;
    Vector3d across = eye.sub(from, new Vector3d()).cross(way);
    if (across.length() < 1e-9 * metre) {
      way.orthogonalizeUnit(new Vector3d(0, 1, 0), across); // The ray begins in the eye.
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
    return new WorldSpacePanel(
        List.of(new Primitive2D.Area(band, end.isPresent() ? COLOUR : FAINT)), place);
  }
}

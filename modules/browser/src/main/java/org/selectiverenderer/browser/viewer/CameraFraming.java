package org.selectiverenderer.browser.viewer;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * The viewer pose from which a whole bounding box is in view (X3D 4.0, 23.3.5 {@code viewAll},
 * 23.4.4 {@code LOOKAT}): on the line from the box's centre to the present eye, looking at the
 * centre.
 *
 * @param centre the centre of the box, in the world
 * @param pose upright, aimed at the centre
 * @param extent the extent of an orthographic view from there that contains the box
 */
public record CameraFraming(Vector3d centre, Pose pose, OrthographicExtent extent) {
  /** Factor of the distance, relative to that at which the box just fills the picture. */
  private static final double ROOM = 1.1;

  /** Smallest distance from a box, however small it is. */
  private static final double NEAREST = 1e-3;

  /**
   * Computes the pose for a box.
   *
   * @param box the bounding box, not empty
   * @param from the present pose; its field of view is kept
   * @param upright the rotation from coordinates whose +Y is up to the world
   */
  public static CameraFraming of(BoundingBox box, Pose from, Quaterniondc upright) {
    Vector3d centre = box.min().add(box.max()).mul(0.5);
    Quaterniond orientation = aim(new Vector3d(centre).sub(from.position()), from, upright);
    double distance = distance(box, orientation, from.fieldOfView());
    Vector3d eye = orientation.transform(new Vector3d(0, 0, distance)).add(centre);
    Vector3d half = half(box, orientation).mul(ROOM).max(new Vector3d(NEAREST));
    return new CameraFraming(
        centre,
        new Pose(eye, orientation, from.fieldOfView()),
        new OrthographicExtent(-half.x, -half.y, half.x, half.y));
  }

  /**
   * Returns the upright orientation that looks in a direction; the present one if the direction has
   * no length.
   */
  private static Quaterniond aim(Vector3d to, Pose from, Quaterniondc upright) {
    Vector3d front = upright.transformInverse(to.normalize(new Vector3d()));
    if (!(to.length() > NEAREST) || !front.isFinite()) {
      return new Quaterniond(from.orientation());
    }
    Quaterniond before = upright.conjugate(new Quaterniond()).mul(from.orientation());
    double level = Math.hypot(front.x, front.z);
    double yaw = level > 1e-6 ? Math.atan2(-front.x, -front.z) : YawPitch.of(before).yaw();
    YawPitch heading = new YawPitch(yaw, Math.atan2(front.y, level));
    return upright.mul(heading.orientation(), new Quaterniond());
  }

  /**
   * Returns the distance from a box's centre at which the whole box is in view.
   *
   * @param orientation the rotation from the viewer's frame, looking along -Z, to the world
   * @param fieldOfView the smaller viewing angle in radians
   */
  public static double distance(BoundingBox box, Quaterniondc orientation, double fieldOfView) {
    double slope = Math.tan(fieldOfView / 2);
    double distance = NEAREST;
    for (int corner = 0; corner < 8; corner++) {
      Vector3d at = corner(box, corner, orientation);
      distance = Math.max(distance, at.z + Math.max(Math.abs(at.x), Math.abs(at.y)) / slope);
    }
    return ROOM * distance;
  }

  /** Returns half the extent of the box to the right, up and towards the eye. */
  private static Vector3d half(BoundingBox box, Quaterniondc orientation) {
    Vector3d half = new Vector3d();
    for (int corner = 0; corner < 8; corner++) {
      half.max(corner(box, corner, orientation));
    }
    return half;
  }

  /** Returns a corner relative to the centre of the box, in the viewer's frame. */
  private static Vector3d corner(BoundingBox box, int corner, Quaterniondc orientation) {
    Vector3d middle = box.min().add(box.max()).mul(0.5);
    return orientation.transformInverse(box.corner(corner).sub(middle));
  }
}

package org.selectiverenderer.enricher.preview;

import java.util.stream.DoubleStream;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.browser.viewer.CameraFraming;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * An unobstructed view of a box: a direction from which walls and furniture hide little of it. The
 * present direction is kept where half of the box is seen; else the search goes round to both sides
 * and then from higher up, so that the camera turns no further than it must.
 */
final class UnobstructedView {
  /** Degrees up, after the present pitch; level last, as it sees only the edges of what is flat. */
  private static final double[] PITCHES = {-25, -50, -80, 0};

  private static final int YAW_STEP = 30;

  /** Share of the box that has to be seen. */
  private static final double ENOUGH = 0.5;

  /** Share of the half size at which points of the box are looked at, away from its faces. */
  private static final double INNER = 0.6;

  /** Share of the box's size by which hits may lie outside of it. */
  private static final double MARGIN = 0.02;

  private final PreviewScene scene;
  private final BoundingBox box;
  private final BoundingBox own;
  private final Vector3d centre;
  private final Pose present;

  /** Makes a view of a box from about the direction of a pose. */
  UnobstructedView(PreviewScene scene, BoundingBox box, Pose present) {
    this.scene = scene;
    this.box = box;
    this.present = present;
    own = box.grown(MARGIN * box.extent());
    centre = box.min().add(box.max()).mul(0.5);
  }

  /** Returns the orientation to look in, the present one if none is better. */
  Quaterniondc orientation() {
    double most = seen(present.orientation());
    if (most >= ENOUGH) {
      return present.orientation();
    }
    Vector3d forward = present.orientation().transform(new Vector3d(0, 0, -1));
    double yaw = Math.atan2(-forward.x, -forward.z);
    Quaterniondc best = present.orientation();
    double tilt = Math.asin(Math.max(-1, Math.min(1, forward.y)));
    double[] pitches =
        DoubleStream.concat(DoubleStream.of(tilt), DoubleStream.of(PITCHES).map(Math::toRadians))
            .toArray();
    for (double pitch : pitches) {
      for (int turn = 0; turn <= 180; turn += YAW_STEP) {
        for (int side = -1; side <= 1; side += 2) {
          Quaterniond other =
              new Quaterniond().rotationYXZ(yaw + Math.toRadians(side * turn), pitch, 0);
          double seen = seen(other);
          if (seen >= ENOUGH) {
            return other;
          }
          if (seen > most) {
            most = seen;
            best = other;
          }
        }
      }
    }
    return best;
  }

  /** Returns the share of the box's points that nothing hides from the camera that frames it. */
  private double seen(Quaterniondc orientation) {
    Vector3d eye =
        orientation
            .transform(
                new Vector3d(0, 0, CameraFraming.distance(box, orientation, present.fieldOfView())))
            .add(centre);
    int clear = clear(eye, centre) ? 1 : 0;
    for (int corner = 0; corner < 8; corner++) {
      Vector3d point = box.corner(corner).sub(centre).mul(INNER).add(centre);
      clear += clear(eye, point) ? 1 : 0;
    }
    return clear / 9.0;
  }

  private boolean clear(Vector3d eye, Vector3d point) {
    Vector3d way = point.sub(eye, new Vector3d());
    double length = way.length();
    return length == 0
        || scene
            .hit(eye, way.div(length))
            .filter(hit -> hit.distance() < length && !within(eye, way, hit))
            .isEmpty();
  }

  private boolean within(Vector3d eye, Vector3d way, RayCaster.Hit hit) {
    return own.contains(eye.fma(hit.distance(), way, new Vector3d()));
  }
}

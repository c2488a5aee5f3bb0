package org.selectiverenderer.enricher.preview;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * Estimates the bounds of rooms in a running scene by casting rays to floors, ceilings and walls.
 * World coordinates, Y up, metres.
 */
final class RoomEstimator {
  /** Height of an area where there is no ceiling, in metres. */
  static final double STANDARD_HEIGHT = 2.5;

  /** Distance from the viewer to an assumed wall where no wall is hit, in metres. */
  private static final double NO_WALL = 2.5;

  /** Distance below the ceiling at which rays look for walls: above most furniture and doors. */
  private static final double UNDER_CEILING = 0.15;

  /** Largest distance of a ceiling or wall that still belongs to the room, in metres. */
  private static final double FARTHEST = 25;

  /** Margin around an object to stand in, in metres. */
  private static final double BESIDE = 1;

  /**
   * An object that is larger than this in X and Z, in metres, gets no margin, as one stands in it.
   */
  private static final double PLACE = 3;

  private final PreviewScene scene;

  RoomEstimator(PreviewScene scene) {
    this.scene = scene;
  }

  private Optional<Double> distance(Vector3dc from, double x, double y, double z) {
    return scene
        .hit(from, new Vector3d(x, y, z))
        .map(RayCaster.Hit::distance)
        .filter(distance -> distance < FARTHEST);
  }

  /** Returns the bounds of the room around a point. */
  BoundingBox room(Vector3dc eye) {
    double floor = eye.y() - distance(eye, 0, -1, 0).orElse(1.6);
    double ceiling = distance(eye, 0, 1, 0).map(up -> eye.y() + up).orElse(floor + STANDARD_HEIGHT);
    Vector3d high = new Vector3d(eye.x(), ceiling - UNDER_CEILING, eye.z());
    double right = distance(high, 1, 0, 0).orElse(NO_WALL);
    double left = distance(high, -1, 0, 0).orElse(NO_WALL);
    double front = distance(high, 0, 0, 1).orElse(NO_WALL);
    double back = distance(high, 0, 0, -1).orElse(NO_WALL);
    return new BoundingBox(
        eye.x() - left, floor, eye.z() - back, eye.x() + right, ceiling, eye.z() + front);
  }

  /** Returns an area around an object: with a margin to stand in, from the floor below it up. */
  BoundingBox around(BoundingBox object) {
    boolean place = object.width() > PLACE && object.depth() > PLACE;
    double beside = place ? 0 : BESIDE;
    BoundingBox wide =
        new BoundingBox(
            object.minX() - beside,
            object.minY(),
            object.minZ() - beside,
            object.maxX() + beside,
            object.maxY(),
            object.maxZ() + beside);
    double from = object.maxY() + 0.02;
    double floor = floor(wide, from).orElse(object.minY());
    return new BoundingBox(
        wide.minX(),
        Math.min(floor, object.minY()),
        wide.minZ(),
        wide.maxX(),
        Math.max(object.maxY(), floor + STANDARD_HEIGHT),
        wide.maxZ());
  }

  /**
   * Returns the box over a rectangle, from the floor to the ceiling there; the rectangle's Y is a
   * height in between.
   */
  BoundingBox raised(BoundingBox footprint) {
    double from = footprint.minY();
    double floor = floor(footprint, from).orElse(from);
    double ceiling = Double.NEGATIVE_INFINITY;
    for (Vector3d place : places(footprint, from)) {
      ceiling =
          Math.max(
              ceiling,
              distance(place, 0, 1, 0).map(up -> from + up).orElse(Double.NEGATIVE_INFINITY));
    }
    return new BoundingBox(
        footprint.minX(),
        floor,
        footprint.minZ(),
        footprint.maxX(),
        Double.isInfinite(ceiling) ? floor + STANDARD_HEIGHT : ceiling,
        footprint.maxZ());
  }

  /**
   * Returns the lowest surface hit below a rectangle, so that tables are not taken for the floor.
   */
  private Optional<Double> floor(BoundingBox footprint, double from) {
    Optional<Double> lowest = Optional.empty();
    for (Vector3d place : places(footprint, from)) {
      Optional<Double> here = distance(place, 0, -1, 0).map(down -> from - down);
      if (here.isPresent() && (lowest.isEmpty() || here.get() < lowest.get())) {
        lowest = here;
      }
    }
    return lowest;
  }

  /** Returns the sample points of a rectangle: its centre and four points towards the corners. */
  private static Vector3d[] places(BoundingBox of, double y) {
    double x = (of.minX() + of.maxX()) / 2;
    double z = (of.minZ() + of.maxZ()) / 2;
    double dx = of.width() * 0.4;
    double dz = of.depth() * 0.4;
    return new Vector3d[] {
      new Vector3d(x, y, z),
      new Vector3d(x - dx, y, z - dz),
      new Vector3d(x + dx, y, z - dz),
      new Vector3d(x - dx, y, z + dz),
      new Vector3d(x + dx, y, z + dz)
    };
  }
}

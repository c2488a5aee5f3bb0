package org.selectiverenderer.browser.picking;

import java.util.List;
import java.util.Optional;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.nodes.picking.PickResult;
import org.selectiverenderer.geometry.BoundingBox;

/** The picking geometry of a pick sensor, in the sensor's local coordinates. */
interface Picker {
  /** A picker that picks nothing. */
  Picker NOTHING =
      new Picker() {
        @Override
        public BoundingBox box() {
          return BoundingBox.EMPTY;
        }

        @Override
        public Optional<Met> bounds(PickTarget target) {
          return Optional.empty();
        }

        @Override
        public Optional<Met> mesh(PickTarget target) {
          return Optional.empty();
        }
      };

  /**
   * The result of picking a shape.
   *
   * @param distance the distance by which picked shapes are sorted, in the sensor's unit
   * @param places the intersection points, in the sensor's coordinates; empty if they are not
   *     needed
   */
  record Met(double distance, List<PickResult.Place> places) {}

  /** Returns the bounding box, in the sensor's coordinates. */
  BoundingBox box();

  /** Intersects with the bounding box of a shape; empty if it is not picked. */
  Optional<Met> bounds(PickTarget target);

  /** Intersects with a shape itself; empty if it is not picked. */
  Optional<Met> mesh(PickTarget target);

  /**
   * Returns the distance from a point in the sensor's coordinates to the centre of a shape's
   * bounding box.
   */
  static double toMiddle(PickTarget target, Vector3dc from) {
    return target
        .toSensor()
        .transformPosition(
            BoundingBox.of(target.mesh().bounds())
                .min()
                .add(BoundingBox.of(target.mesh().bounds()).max())
                .mul(0.5))
        .distance(from);
  }
}

package org.selectiverenderer.runtime.pick;

import java.util.List;
import java.util.Optional;
import org.joml.Vector3dc;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.runtime.nodes.pick.Picked;

/** What a sensor meets shapes with: its geometry, in its local coordinates. */
interface Picker {
  /** One that meets nothing. */
  Picker NOTHING =
      new Picker() {
        @Override
        public Bounds box() {
          return Bounds.EMPTY;
        }

        @Override
        public Optional<Met> bounds(Target target) {
          return Optional.empty();
        }

        @Override
        public Optional<Met> mesh(Target target) {
          return Optional.empty();
        }
      };

  /**
   * How a shape is met.
   *
   * @param distance by which met shapes are sorted, in the sensor's unit
   * @param places where, in the sensor's coordinates; none where nobody asks
   */
  record Met(double distance, List<Picked.Place> places) {}

  /** Around all of it, in the sensor's coordinates. */
  Bounds box();

  /** Whether and how the box around a shape is met. */
  Optional<Met> bounds(Target target);

  /** Whether and how a shape itself is met. */
  Optional<Met> mesh(Target target);

  /** From a place of the sensor to the middle of a shape's box. */
  static double toMiddle(Target target, Vector3dc from) {
    return target
        .toSensor()
        .transformPosition(
            Bounds.of(target.mesh().bounds())
                .min()
                .add(Bounds.of(target.mesh().bounds()).max())
                .mul(0.5))
        .distance(from);
  }
}

package org.selectiverenderer.browser.nodes.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector4d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.TestNodes;

/** The sensor against another way to know: where the faces of the transformed box lie. */
class ProximitySensorOracleTest {
  private static final int BOXES = 400;
  private static final int POINTS = 60;

  private final TestNodes nodes = new TestNodes();
  private final TestFrameContext frame = new TestFrameContext();
  private final Random random = new Random(20240517);

  @Test
  void agreesWithTheFacesOfTheBoxUnderAnyTransformation() {
    int inside = 0;
    for (int box = 0; box < BOXES; box++) {
      float[] size = {1 + random.nextFloat(), 1 + random.nextFloat(), 1 + random.nextFloat()};
      float[] center = {random.nextFloat(), random.nextFloat(), random.nextFloat()};
      ProximitySensorNode sensor =
          (ProximitySensorNode) nodes.node("ProximitySensor", "size", size, "center", center);
      Matrix4d place = place();
      frame.place(sensor, place);
      for (int i = 0; i < POINTS; i++) {
        frame.eye.set(point(), point(), point());
        place.transformPosition(frame.eye);
        double depth = depth(place, center, size, frame.eye);
        if (Math.abs(depth) < 1e-9) {
          continue; // Either answer is right within rounding.
        }
        frame.step(sensor, i, nodes.cascade);
        assertThat(sensor.active()).as("depth %s in %s", depth, place).isEqualTo(depth > 0);
        inside += sensor.active() ? 1 : 0;
      }
    }
    assertThat(inside).isBetween(BOXES * POINTS / 10, BOXES * POINTS * 9 / 10);
  }

  private double point() {
    return 2.4 * random.nextDouble() - 0.7;
  }

  /** Rotations, uneven scales, shears and mirrorings, several of them nested. */
  private Matrix4d place() {
    Matrix4d m = new Matrix4d();
    for (int level = random.nextInt(4); level >= 0; level--) {
      m.translate(random.nextGaussian() * 5, random.nextGaussian() * 5, random.nextGaussian() * 5)
          .rotateXYZ(random.nextDouble() * 6, random.nextDouble() * 6, random.nextDouble() * 6)
          .scale(scale(), scale(), scale())
          .mul(new Matrix4d().m10(random.nextDouble()).m20(random.nextDouble()));
    }
    return m;
  }

  private double scale() {
    double size = Math.exp(random.nextGaussian() * 0.5);
    return random.nextInt(5) == 0 ? -size : size;
  }

  /**
   * How deep a point lies within the box, relative to its sizes: the least share of the distances
   * to opposite faces, found from the faces' planes in the world; negative outside.
   */
  private static double depth(Matrix4d place, float[] center, float[] size, Vector3d eye) {
    double least = Double.POSITIVE_INFINITY;
    for (int axis = 0; axis < 3; axis++) {
      Vector3d u = edge(place, (axis + 1) % 3);
      Vector3d v = edge(place, (axis + 2) % 3);
      Vector3d normal = u.cross(v, new Vector3d()).normalize();
      double low = normal.dot(face(place, center, size, axis, -1));
      double high = normal.dot(face(place, center, size, axis, 1));
      double at = (normal.dot(eye) - low) / (high - low);
      least = Math.min(least, Math.min(at, 1 - at));
    }
    return least;
  }

  private static Vector3d edge(Matrix4d place, int axis) {
    return place.getColumn(axis, new Vector4d()).xyz(new Vector3d());
  }

  private static Vector3d face(Matrix4d place, float[] center, float[] size, int axis, int side) {
    Vector3d on = new Vector3d(center[0], center[1], center[2]);
    on.setComponent(axis, on.get(axis) + side * size[axis] / 2.0);
    return place.transformPosition(on);
  }
}

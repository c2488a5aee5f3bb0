package org.selectiverenderer.radiosity.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.radiosity.light.GlowLamp;
import org.selectiverenderer.radiosity.light.Lamp;
import org.selectiverenderer.radiosity.light.PointLamp;
import org.selectiverenderer.radiosity.light.RectangleLamp;
import org.selectiverenderer.radiosity.light.SunLamp;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.LightScene;

/** All that shines in a scene. Immutable; for several threads. */
final class Lights {
  /** What does not glow. */
  static final int NONE = -1;

  private final List<Light> all = new ArrayList<>();
  private final List<Integer> rectangles = new ArrayList<>();
  private final int[] ofBody;

  Lights(LightScene scene) {
    for (Lamp lamp : scene.lamps()) {
      if (lamp instanceof PointLamp point) {
        all.add(new Light.Point(point));
      } else if (lamp instanceof SunLamp sun) {
        all.add(new Light.Sun(sun));
      } else if (lamp instanceof RectangleLamp rectangle) {
        rectangles.add(all.size());
        all.add(Light.Rectangle.of(rectangle));
      } else if (!(lamp instanceof GlowLamp)) {
        throw new IllegalArgumentException("a lamp that the reference does not know: " + lamp);
      }
    }
    // Every body that glows, whether or not the solution takes it for a lamp.
    ofBody = new int[scene.bodies().size()];
    Arrays.fill(ofBody, NONE);
    for (int i = 0; i < ofBody.length; i++) {
      Body body = scene.bodies().get(i);
      if (body.glows() && scene.versions().isReference(body.version())) {
        ofBody[i] = all.size();
        all.add(new Light.Glow(new GlowingBody(scene.triangles(), body)));
      }
    }
  }

  int count() {
    return all.size();
  }

  Light get(int light) {
    return all.get(light);
  }

  /** The lights that are no surfaces and are met by rays all the same: all are rectangles. */
  List<Integer> rectangles() {
    return rectangles;
  }

  Light.Rectangle rectangle(int light) {
    return (Light.Rectangle) all.get(light);
  }

  /** The light that a body is, or {@link #NONE}. */
  int ofBody(int body) {
    return ofBody[body];
  }

  /**
   * How worthwhile each is at a point.
   *
   * @param weights gets one for each
   * @return their sum
   */
  double weigh(double[] point, double[] normal, double[] weights) {
    double sum = 0;
    for (int i = 0; i < weights.length; i++) {
      weights[i] = all.get(i).weight(point, normal);
      sum += weights[i];
    }
    return sum;
  }
}

package org.selectiverenderer.radiosity.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.radiosity.light.DirectionalLightSource;
import org.selectiverenderer.radiosity.light.EmissiveMeshLightSource;
import org.selectiverenderer.radiosity.light.LightSource;
import org.selectiverenderer.radiosity.light.PointLightSource;
import org.selectiverenderer.radiosity.light.RectangleLightSource;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/** All that shines in a scene. Immutable; for several threads. */
final class SceneEmitters {
  /** What does not glow. */
  static final int NONE = -1;

  private final List<Emitter> all = new ArrayList<>();
  private final List<Integer> rectangles = new ArrayList<>();
  private final int[] ofBody;

  SceneEmitters(RadiosityScene scene) {
    for (LightSource lamp : scene.lamps()) {
      if (lamp instanceof PointLightSource point) {
        all.add(new Emitter.Point(point));
      } else if (lamp instanceof DirectionalLightSource sun) {
        all.add(new Emitter.Sun(sun));
      } else if (lamp instanceof RectangleLightSource rectangle) {
        rectangles.add(all.size());
        all.add(Emitter.Rectangle.of(rectangle));
      } else if (!(lamp instanceof EmissiveMeshLightSource)) {
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
        all.add(new Emitter.Glow(new EmissiveMesh(scene.triangles(), body)));
      }
    }
  }

  int count() {
    return all.size();
  }

  Emitter get(int light) {
    return all.get(light);
  }

  /** The lights that are no surfaces and are met by rays all the same: all are rectangles. */
  List<Integer> rectangles() {
    return rectangles;
  }

  Emitter.Rectangle rectangle(int light) {
    return (Emitter.Rectangle) all.get(light);
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

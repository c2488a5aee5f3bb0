package org.selectiverenderer.render.lighting;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.browser.instance.Light;
import org.selectiverenderer.browser.instance.LightInstance;

/** Light culling: tests which lights can reach a bounding box, by their radius and beam. */
final class LightCuller {
  private final Vector3d centre;
  private final double radius;
  private final double[] box;

  /**
   * @param box min x, y, z, max x, y, z in the world
   */
  LightCuller(double[] box) {
    this.box = box;
    centre = new Vector3d((box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2);
    radius = centre.distance(box[3], box[4], box[5]);
  }

  /** Returns the lights that reach the box, on or off; the same list object if all do. */
  List<LightInstance> of(List<LightInstance> lights) {
    List<LightInstance> reaching = new ArrayList<>(lights.size());
    for (LightInstance light : lights) {
      if (light.light().kind() == Light.Kind.DIRECTIONAL || reached(WorldSpaceLight.of(light))) {
        reaching.add(light);
      }
    }
    return reaching.size() == lights.size() ? lights : List.copyOf(reaching);
  }

  /** Returns whether some of the light can fall into the box. */
  boolean reached(WorldSpaceLight light) {
    return nearest(light) <= light.radius() && (light.kind() != Light.Kind.SPOT || inBeam(light));
  }

  /**
   * Returns an upper bound of the error of linear interpolation of the light along an edge in the
   * box.
   *
   * @param lights the lights, of which those that are on count
   * @param length the length of the edge in the world
   */
  double departure(List<LightInstance> lights, double length) {
    double sum = 0;
    for (LightInstance instance : lights) {
      if (instance.on() && instance.light().kind() != Light.Kind.DIRECTIONAL) {
        WorldSpaceLight light = WorldSpaceLight.of(instance);
        if (reached(light)) {
          sum += DiffuseLightModel.bound(light, nearest(light), farthest(light), length);
        }
      }
    }
    return sum;
  }

  /** Returns the distance from a light to the box. */
  private double nearest(WorldSpaceLight light) {
    double x = Math.max(0, Math.max(box[0] - light.position().x(), light.position().x() - box[3]));
    double y = Math.max(0, Math.max(box[1] - light.position().y(), light.position().y() - box[4]));
    double z = Math.max(0, Math.max(box[2] - light.position().z(), light.position().z() - box[5]));
    return Math.sqrt(x * x + y * y + z * z);
  }

  /** Returns an upper bound of the distance from a light to a point of the box. */
  private double farthest(WorldSpaceLight light) {
    return centre.distance(light.position()) + radius;
  }

  private boolean inBeam(WorldSpaceLight light) {
    Vector3d towards = centre.sub(light.position(), new Vector3d());
    double distance = towards.length();
    if (distance <= radius || light.axis().lengthSquared() == 0) {
      return true;
    }
    double angle = Math.acos(Math.max(-1, Math.min(1, towards.dot(light.axis()) / distance)));
    return angle - Math.asin(radius / distance) <= light.cutOff();
  }
}

package org.selectiverenderer.render.lighting;

import java.util.List;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.instance.Light;

/**
 * The diffuse light of point and spot lights on a white surface, as the shaders compute it (X3D
 * 4.0, 17.2.2). Directional lights are left out, because they are constant on a flat face.
 */
final class DiffuseLightModel {
  /** The default ambient intensity of a Material. */
  private static final double AMBIENT = 0.2;

  /**
   * The bound of the second derivative of cosine times attenuation, in units of 1 / distance
   * squared.
   */
  private static final double BEND = 3;

  private final WorldSpaceLight[] lights;
  private final double[] cosBeam;
  private final double[] cosCutOff;

  DiffuseLightModel(List<WorldSpaceLight> lights) {
    this.lights =
        lights.stream().filter(WorldSpaceLight::positional).toArray(WorldSpaceLight[]::new);
    cosBeam = new double[this.lights.length];
    cosCutOff = new double[this.lights.length];
    for (int i = 0; i < this.lights.length; i++) {
      cosBeam[i] = Math.cos(Math.max(0, Math.min(Math.PI, this.lights[i].beamWidth())));
      cosCutOff[i] = Math.cos(Math.max(0, Math.min(Math.PI, this.lights[i].cutOff())));
    }
  }

  boolean isEmpty() {
    return lights.length == 0;
  }

  int size() {
    return lights.length;
  }

  WorldSpaceLight light(int i) {
    return lights[i];
  }

  /** Adds the light r, g, b at a point with a unit normal to {@code out}. */
  void add(
      double x, double y, double z, double nx, double ny, double nz, double[] out, int offset) {
    for (int i = 0; i < lights.length; i++) {
      WorldSpaceLight light = lights[i];
      Vector3dc at = light.position();
      double lx = at.x() - x;
      double ly = at.y() - y;
      double lz = at.z() - z;
      double distance = Math.sqrt(lx * lx + ly * ly + lz * lz);
      if (distance > light.radius()) {
        continue;
      }
      double unit = 1 / Math.max(distance, 1e-9);
      double factor = beam(i, -(lx * axisX(i) + ly * axisY(i) + lz * axisZ(i)) * unit);
      if (factor > 0) {
        double cosine = Math.max(0, (nx * lx + ny * ly + nz * lz) * unit);
        double value =
            factor
                * fall(light, distance)
                * (light.ambientIntensity() * AMBIENT + light.intensity() * cosine);
        out[offset] += light.color().x() * value;
        out[offset + 1] += light.color().y() * value;
        out[offset + 2] += light.color().z() * value;
      }
    }
  }

  private double axisX(int i) {
    return lights[i].axis().x();
  }

  private double axisY(int i) {
    return lights[i].axis().y();
  }

  private double axisZ(int i) {
    return lights[i].axis().z();
  }

  private double beam(int i, double cosine) {
    if (lights[i].kind() == Light.Kind.POINT || cosine >= cosBeam[i]) {
      return 1;
    }
    if (cosine <= cosCutOff[i]) {
      return 0;
    }
    double width = lights[i].cutOff() - lights[i].beamWidth();
    return Math.max(0, Math.min(1, (lights[i].cutOff() - Math.acos(cosine)) / width));
  }

  private static double fall(WorldSpaceLight light, double distance) {
    double divisor = light.constant() + distance * (light.linear() + distance * light.quadratic());
    return 1 / Math.max(divisor, 1);
  }

  /** Returns the distance to the nearest light; infinite if there is none. */
  double nearest(double x, double y, double z) {
    double square = Double.POSITIVE_INFINITY;
    for (WorldSpaceLight light : lights) {
      square = Math.min(square, light.position().distanceSquared(x, y, z));
    }
    return Math.sqrt(square);
  }

  /**
   * Returns an upper bound of the error of linear interpolation of the light along an edge.
   *
   * @param length the length of the edge
   * @param x the midpoint of the edge
   */
  double bound(double x, double y, double z, double length) {
    double sum = 0;
    for (WorldSpaceLight light : lights) {
      double middle = Math.sqrt(light.position().distanceSquared(x, y, z));
      sum += bound(light, middle - length / 2, middle + length / 2, length);
    }
    return sum;
  }

  /**
   * Returns the bound for one light.
   *
   * @param from the least distance of the edge from the light; {@code to} is the greatest
   */
  static double bound(WorldSpaceLight light, double from, double to, double length) {
    if (from >= light.radius()) {
      return 0;
    }
    if (from <= 0) {
      return Double.POSITIVE_INFINITY;
    }
    double share = length / from;
    double bend = BEND * share * share / 8;
    if (light.kind() == Light.Kind.SPOT && light.cutOff() < Math.PI) {
      bend += share / (4 * (light.cutOff() - light.beamWidth()));
    }
    if (to > light.radius()) {
      bend += fall(light, light.radius());
    }
    double color = Math.max(light.color().x(), Math.max(light.color().y(), light.color().z()));
    return light.intensity() * color * Math.min(1, bend);
  }
}

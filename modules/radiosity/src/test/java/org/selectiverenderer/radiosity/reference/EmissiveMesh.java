package org.selectiverenderer.radiosity.reference;

import java.util.Arrays;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/** All triangles of a body that glows, with places drawn evenly over their area. Immutable. */
final class EmissiveMesh {
  private final SceneTriangles triangles;
  private final Body body;
  private final double[] sums;
  private final double[] centre = new double[3];
  private final double radius;
  private final boolean twoSided;

  EmissiveMesh(SceneTriangles triangles, Body body) {
    this.triangles = triangles;
    this.body = body;
    twoSided = triangles.twoSided()[body.firstTriangle()];
    sums = new double[body.triangles()];
    double[] low = {1e30, 1e30, 1e30};
    double[] high = {-1e30, -1e30, -1e30};
    double[] normal = new double[3];
    double sum = 0;
    for (int i = 0; i < sums.length; i++) {
      sum += triangles.normal(body.firstTriangle() + i, normal);
      sums[i] = sum;
      for (int k = 0; k < 9; k++) {
        float value = triangles.corners()[9 * (body.firstTriangle() + i) + k];
        low[k % 3] = Math.min(low[k % 3], value);
        high[k % 3] = Math.max(high[k % 3], value);
      }
    }
    for (int axis = 0; axis < 3; axis++) {
      centre[axis] = (low[axis] + high[axis]) / 2;
    }
    radius = VectorMath.distance(low, high) / 2;
  }

  double area() {
    return sums[sums.length - 1];
  }

  double[] centre() {
    return centre;
  }

  double radius() {
    return radius;
  }

  double lumens() {
    return Math.PI * area() * (twoSided ? 2 : 1) * Photometry.luminance(body.emission());
  }

  boolean draw(double[] point, double s, double t, EmitterSample draw) {
    double wanted = s * area();
    int found = Arrays.binarySearch(sums, wanted);
    int at = Math.min(sums.length - 1, found < 0 ? -found - 1 : found + 1);
    double before = at == 0 ? 0 : sums[at - 1];
    double own = sums[at] > before ? (wanted - before) / (sums[at] - before) : 0;
    double root = Math.sqrt(Math.max(0, Math.min(1, own)));
    double[] place = new double[3];
    double[] normal = new double[3];
    triangles.normal(body.firstTriangle() + at, normal);
    triangles.point(body.firstTriangle() + at, root * (1 - t), root * t, place);
    double square = draw.aim(point, place);
    double cosine = -VectorMath.dot(draw.towards, normal);
    cosine = twoSided ? Math.abs(cosine) : cosine;
    if (!(cosine > 0) || !(square > 0)) {
      return false;
    }
    draw.density = square / (area() * cosine);
    draw.shine(body.emission(), 1);
    return true;
  }
}

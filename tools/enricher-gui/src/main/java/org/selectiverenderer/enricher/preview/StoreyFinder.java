package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Finds the height at which a plan is cut: between a floor and the ceiling over it. Floors and
 * ceilings are the heights at which much of the scene's surface is level.
 */
final class StoreyFinder {
  private static final int BINS = 400;

  /** Least share of the largest level area for a level that counts. */
  private static final double MUCH = 0.3;

  /** Least sine of a surface's slope that is not level. */
  private static final double LEVEL = 0.95;

  /** Least height of a storey, as a share of the highest one. */
  private static final double STOREY = 0.5;

  /** Height of the cut over the floor, in metres: through doors and most windows. */
  private static final double CUT = 1.2;

  /** Largest height of a storey whose unit is taken for the metre. */
  private static final double METRES = 6;

  private final List<ShapeInstance> shapes;
  private double low = Double.POSITIVE_INFINITY;
  private double high = Double.NEGATIVE_INFINITY;

  private record Storey(double floor, double ceiling) {
    double height() {
      return ceiling - floor;
    }
  }

  StoreyFinder(List<ShapeInstance> shapes) {
    this.shapes = shapes;
    for (ShapeInstance shape : shapes) {
      low = Math.min(low, shape.bounds()[1]);
      high = Math.max(high, shape.bounds()[4]);
    }
  }

  /**
   * Returns the height of the cut.
   *
   * @param eye the eye height at the start viewpoint, which is the height of the cut if it is in a
   *     storey; empty without a viewpoint
   */
  double cut(OptionalDouble eye) {
    List<Storey> storeys = storeys();
    if (eye.isPresent()) {
      double at = eye.getAsDouble();
      if (storeys.stream().anyMatch(each -> each.floor() < at && at < each.ceiling())) {
        return at;
      }
    }
    Storey lowest = storeys.get(0);
    double height = lowest.height();
    return lowest.floor() + (height > METRES ? 0.45 * height : Math.min(CUT, height / 2));
  }

  private List<Storey> storeys() {
    if (!(high > low)) {
      return List.of(new Storey(low, low + 1));
    }
    List<Double> levels = new ArrayList<>(levels());
    if (levels.isEmpty() || levels.get(0) - low > 0.5 * (high - low)) {
      levels.add(0, low);
    }
    levels.add(high);
    double most = 0;
    for (int i = 1; i < levels.size(); i++) {
      most = Math.max(most, levels.get(i) - levels.get(i - 1));
    }
    List<Storey> storeys = new ArrayList<>();
    for (int i = 1; i < levels.size(); i++) {
      Storey storey = new Storey(levels.get(i - 1), levels.get(i));
      if (storey.height() >= STOREY * most) {
        storeys.add(storey);
      }
    }
    return storeys;
  }

  private List<Double> levels() {
    double[] areas = new double[BINS];
    double bin = (high - low) / BINS;
    Vector3d[] at = {new Vector3d(), new Vector3d(), new Vector3d()};
    for (ShapeInstance shape : shapes) {
      Mesh mesh =
          shape.mesh().filter(each -> each.primitive() == Mesh.Primitive.TRIANGLES).orElse(null);
      if (mesh != null) {
        add(mesh, shape.world(), areas, bin, at);
      }
    }
    double largest = 0;
    for (double area : areas) {
      largest = Math.max(largest, area);
    }
    List<Double> levels = new ArrayList<>();
    for (int i = 0; i < BINS; i++) {
      if (areas[i] > 0 && areas[i] >= MUCH * largest) {
        levels.add(low + (i + 0.5) * bin);
      }
    }
    return levels;
  }

  private void add(Mesh mesh, Matrix4dc world, double[] areas, double bin, Vector3d[] at) {
    float[] p = mesh.positions();
    int[] indices = mesh.indices();
    Vector3d normal = new Vector3d();
    for (int i = 0; i + 2 < indices.length; i += 3) {
      for (int k = 0; k < 3; k++) {
        int v = 3 * indices[i + k];
        world.transformPosition(at[k].set(p[v], p[v + 1], p[v + 2]));
      }
      double y = (at[0].y + at[1].y + at[2].y) / 3;
      at[1].sub(at[0]).cross(at[2].sub(at[0]), normal);
      double area = normal.length();
      int index = (int) ((y - low) / bin);
      if (area > 0 && Math.abs(normal.y) > LEVEL * area) {
        areas[Math.max(0, Math.min(BINS - 1, index))] += Math.abs(normal.y);
      }
    }
  }
}

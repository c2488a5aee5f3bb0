package org.selectiverenderer.walkthrough.transition;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Points spread evenly over the surface of a version of an object, each for an equal share of the
 * area. They are in the coordinates of the version's shapes, so that they move with these.
 */
final class SurfaceSamples {
  /** The number of points of a version that has an area. */
  static final int COUNT = 24;

  /** The fractional parts of multiples of these numbers fill a square evenly (Roberts 2018). */
  private static final double FIRST = 0.7548776662466927;

  private static final double SECOND = 0.5698402909980532;

  /**
   * A point of a surface.
   *
   * @param edges two edges of its triangle, scaled so that half their cross product is the part of
   *     the area that the point stands for; without length for points of lines and of point sets
   */
  record Sample(ShapeInstance shape, Mesh mesh, Vector3d at, Vector3d[] edges) {
    /** Returns whether the shape still has the mesh of the point. */
    boolean current() {
      return shape.mesh().orElse(null) == mesh;
    }

    Vector3d world() {
      return shape.world().transformPosition(at, new Vector3d());
    }

    /** Returns the normal of the surface in the world, as long as the area of the point's part. */
    Vector3d area() {
      Vector3d first = shape.world().transformDirection(edges[0], new Vector3d());
      Vector3d second = shape.world().transformDirection(edges[1], new Vector3d());
      Vector3d area = first.cross(second).mul(0.5);
      return shape.world().determinant3x3() < 0 ? area.negate() : area;
    }
  }

  private SurfaceSamples() {}

  /** Returns the points of what a version draws where it is shown. */
  static List<Sample> of(Instance version) {
    List<ShapeInstance> shapes = new ArrayList<>();
    collect(version, shapes);
    double all = 0;
    for (ShapeInstance shape : shapes) {
      all += area(shape);
    }
    List<Sample> samples = new ArrayList<>();
    double before = 0;
    for (ShapeInstance shape : shapes) {
      Mesh mesh = shape.mesh().orElseThrow();
      if (mesh.polygons() == 0) {
        corners(shape, mesh, samples);
      } else if (all > 0) {
        before = spread(shape, mesh, before, all / COUNT, samples);
      }
    }
    return List.copyOf(samples);
  }

  private static void collect(Instance instance, List<ShapeInstance> found) {
    if (instance instanceof ShapeInstance shape) {
      if (shape.mesh().filter(mesh -> !mesh.isEmpty()).isPresent()) {
        found.add(shape);
      }
    } else if (instance instanceof GroupInstance group) {
      for (int i = 0; i < group.children().size(); i++) {
        if (group.node().shows(i)) {
          collect(group.children().get(i), found);
        }
      }
    }
  }

  private static double area(ShapeInstance shape) {
    Mesh mesh = shape.mesh().orElseThrow();
    int[] indices = mesh.indices();
    double sum = 0;
    for (int t = 0; t < mesh.polygons(); t++) {
      sum += triangle(shape, mesh, indices, t).area().length();
    }
    return sum;
  }

  /** Returns the middle of a triangle as a point that stands for the whole of it. */
  private static Sample triangle(ShapeInstance shape, Mesh mesh, int[] indices, int t) {
    Vector3d a = corner(mesh, indices[3 * t]);
    Vector3d b = corner(mesh, indices[3 * t + 1]).sub(a);
    Vector3d c = corner(mesh, indices[3 * t + 2]).sub(a);
    Vector3d middle = new Vector3d(a).fma(1 / 3.0, b).fma(1 / 3.0, c);
    return new Sample(shape, mesh, middle, new Vector3d[] {b, c});
  }

  private static Vector3d corner(Mesh mesh, int vertex) {
    int at = 3 * vertex;
    float[] all = mesh.positions();
    return new Vector3d(all[at], all[at + 1], all[at + 2]);
  }

  /**
   * Adds a point wherever the area so far passes the middle of another share.
   *
   * @param before area of the shapes before
   * @param share area for which a point stands
   * @return the area including that of the shape
   */
  private static double spread(
      ShapeInstance shape, Mesh mesh, double before, double share, List<Sample> to) {
    int[] indices = mesh.indices();
    double sum = before;
    for (int t = 0; t < mesh.polygons(); t++) {
      Sample whole = triangle(shape, mesh, indices, t);
      double area = whole.area().length();
      long first = Math.round(sum / share);
      sum += area;
      long end = Math.round(sum / share);
      for (long n = first; n < end; n++) {
        double u = n * FIRST % 1;
        double v = n * SECOND % 1;
        if (u + v > 1) {
          u = 1 - u;
          v = 1 - v;
        }
        Vector3d at =
            corner(mesh, indices[3 * t]).fma(u, whole.edges()[0]).fma(v, whole.edges()[1]);
        Vector3d scaled = new Vector3d(whole.edges()[0]).mul(share / area);
        to.add(new Sample(shape, mesh, at, new Vector3d[] {scaled, whole.edges()[1]}));
      }
    }
    return sum;
  }

  /** Adds corners of lines or of a point set, which have no area. */
  private static void corners(ShapeInstance shape, Mesh mesh, List<Sample> to) {
    int[] indices = mesh.indices();
    int all = indices.length;
    int count = Math.min(COUNT, all);
    for (int n = 0; n < count; n++) {
      Vector3d at = corner(mesh, indices[(int) ((long) n * all / count)]);
      to.add(new Sample(shape, mesh, at, new Vector3d[] {new Vector3d(), new Vector3d()}));
    }
  }
}

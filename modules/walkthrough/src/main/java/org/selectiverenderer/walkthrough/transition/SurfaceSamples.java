package org.selectiverenderer.walkthrough.transition;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Points spread evenly over the surface of a version of an object, each for an equal share of the
 * area. They are in the coordinates of the version's shapes, so that they move with these.
 */
final class SurfaceSamples {
  /** The number of points of a version that has an area. */
  static final int COUNT = 24;

  /**
   * The number of triangles of a version from which on only some of them, evenly spread, are looked
   * at: the first look at an object must not hold up a frame.
   */
  private static final int MOST = 1024;

  /**
   * A point of a surface.
   *
   * @param edges two edges of its triangle, scaled so that half their cross product is the part of
   *     the area that the point stands for; without length for points of lines and of point sets
   */
  record Sample(ShapeInstance shape, Mesh mesh, Vector3d at, Vector3d[] edges) {
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

  /** Returns the points on shapes that have meshes. */
  static List<Sample> of(List<ShapeInstance> shapes) {
    long all = 0;
    for (ShapeInstance shape : shapes) {
      all += shape.mesh().orElseThrow().polygons();
    }
    List<Sample> samples = new ArrayList<>();
    List<Sample> triangles = new ArrayList<>();
    List<Double> areas = new ArrayList<>();
    for (ShapeInstance shape : shapes) {
      Mesh mesh = shape.mesh().orElseThrow();
      if (mesh.polygons() == 0) {
        corners(shape, mesh, samples);
        continue;
      }
      int count = looked(mesh, all);
      for (int n = 0; n < count; n++) {
        Sample triangle = triangle(shape, mesh, (int) ((long) n * mesh.polygons() / count));
        triangles.add(triangle);
        areas.add(triangle.area().length() * mesh.polygons() / count);
      }
    }
    spread(triangles, areas.stream().mapToDouble(Double::doubleValue).toArray(), samples);
    return List.copyOf(samples);
  }

  /** Returns the number of triangles of a shape that are looked at. */
  private static int looked(Mesh mesh, long all) {
    int own = mesh.polygons();
    return all <= MOST ? own : (int) Math.max(1, (long) own * MOST / all);
  }

  /** Returns a triangle as a point in its first corner that stands for the whole of it. */
  private static Sample triangle(ShapeInstance shape, Mesh mesh, int t) {
    int[] indices = mesh.indices();
    Vector3d a = corner(mesh, indices[3 * t]);
    Vector3d b = corner(mesh, indices[3 * t + 1]).sub(a);
    Vector3d c = corner(mesh, indices[3 * t + 2]).sub(a);
    return new Sample(shape, mesh, a, new Vector3d[] {b, c});
  }

  private static Vector3d corner(Mesh mesh, int vertex) {
    int at = 3 * vertex;
    float[] all = mesh.positions();
    return new Vector3d(all[at], all[at + 1], all[at + 2]);
  }

  /** Adds a point wherever the area so far passes the middle of another share. */
  private static void spread(List<Sample> triangles, double[] areas, List<Sample> to) {
    double share = Arrays.stream(areas).sum() / COUNT;
    double sum = 0;
    for (int t = 0; share > 0 && t < areas.length; t++) {
      Sample whole = triangles.get(t);
      long first = Math.round(sum / share);
      sum += areas[t];
      long end = Math.round(sum / share);
      for (long n = first; n < end; n++) {
        double u = PlaneSequence.first(n);
        double v = PlaneSequence.second(n);
        if (u + v > 1) {
          u = 1 - u;
          v = 1 - v;
        }
        Vector3d at = new Vector3d(whole.at()).fma(u, whole.edges()[0]).fma(v, whole.edges()[1]);
        double larger = share / whole.area().length();
        Vector3d scaled = new Vector3d(whole.edges()[0]).mul(larger);
        Vector3d[] edges = {scaled, whole.edges()[1]};
        to.add(new Sample(whole.shape(), whole.mesh(), at, edges));
      }
    }
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

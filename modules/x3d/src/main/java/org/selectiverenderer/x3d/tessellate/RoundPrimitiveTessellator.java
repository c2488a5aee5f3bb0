package org.selectiverenderer.x3d.tessellate;

import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Tessellates Sphere, Cone and Cylinder nodes (X3D 4.0, 13.3.7, 13.3.2, 13.3.3) with {@value
 * #SLICES} slices around the y axis, and the Sphere with {@value #STACKS} stacks. A Sphere has 960
 * triangles, a Cone 32 for the side and 30 for the bottom, a Cylinder 64 for the side and 30 for
 * each cap. Textures wrap around the sides counter-clockwise seen from above, starting at the back
 * (negative z); caps cut a circle out of the texture.
 */
final class RoundPrimitiveTessellator {
  static final int SLICES = 32;
  static final int STACKS = 16;

  private RoundPrimitiveTessellator() {}

  static Mesh sphere(TessellationContext job) {
    PrimitiveMeshBuilder builder = new PrimitiveMeshBuilder();
    if (job.positive("radius")) {
      double radius = job.node().number("radius");
      int[] above = new int[0];
      for (int stack = 0; stack <= STACKS; stack++) {
        double polar = Math.PI * stack / STACKS;
        double y = stack == STACKS ? -1 : Math.cos(polar);
        double ring = stack % STACKS == 0 ? 0 : Math.sin(polar);
        // each triangle at a pole has its own pole vertex, with S midway between its base vertices
        double shift = stack % STACKS == 0 ? 0.5 : 0;
        int[] row = new int[SLICES + 1];
        for (int slice = 0; slice <= SLICES; slice++) {
          double nx = ring * x(slice);
          double nz = ring * z(slice);
          double s = (slice + shift) / SLICES;
          double t = 1 - (double) stack / STACKS;
          if (shift == 0 || slice < SLICES) {
            row[slice] = builder.vertex(radius * nx, radius * y, radius * nz, nx, y, nz, s, t);
          }
        }
        if (stack > 0) {
          joinStacks(builder, above, row, stack);
        }
        above = row;
      }
    }
    return builder.mesh(job.node().bool("solid"));
  }

  private static void joinStacks(
      PrimitiveMeshBuilder builder, int[] above, int[] below, int stack) {
    for (int slice = 0; slice < SLICES; slice++) {
      if (stack == 1) {
        builder.triangle(above[slice], below[slice], below[slice + 1]);
      } else if (stack == STACKS) {
        builder.triangle(above[slice], below[slice], above[slice + 1]);
      } else {
        builder.quad(above[slice], below[slice], below[slice + 1], above[slice + 1]);
      }
    }
  }

  static Mesh cylinder(TessellationContext job) {
    NodeView node = job.node();
    PrimitiveMeshBuilder builder = new PrimitiveMeshBuilder();
    if (job.positive("radius", "height")) {
      double radius = node.number("radius");
      double half = node.number("height") / 2.0;
      if (node.bool("side")) {
        for (int slice = 0; slice <= SLICES; slice++) {
          double x = x(slice);
          double z = z(slice);
          double s = (double) slice / SLICES;
          int top = builder.vertex(radius * x, half, radius * z, x, 0, z, s, 1);
          builder.vertex(radius * x, -half, radius * z, x, 0, z, s, 0);
          if (slice > 0) {
            builder.quad(top - 2, top - 1, top + 1, top);
          }
        }
      }
      if (node.bool("top")) {
        cap(builder, radius, half, 1);
      }
      if (node.bool("bottom")) {
        cap(builder, radius, -half, -1);
      }
    }
    return builder.mesh(node.bool("solid"));
  }

  static Mesh cone(TessellationContext job) {
    NodeView node = job.node();
    PrimitiveMeshBuilder builder = new PrimitiveMeshBuilder();
    if (job.positive("bottomRadius", "height")) {
      double radius = node.number("bottomRadius");
      double height = node.number("height");
      if (node.bool("side")) {
        coneSide(builder, radius, height);
      }
      if (node.bool("bottom")) {
        cap(builder, radius, -height / 2, -1);
      }
    }
    return builder.mesh(node.bool("solid"));
  }

  private static void coneSide(PrimitiveMeshBuilder builder, double radius, double height) {
    double slant = Math.hypot(radius, height);
    double out = height / slant;
    double up = radius / slant;
    for (int slice = 0; slice <= SLICES; slice++) {
      double x = x(slice);
      double z = z(slice);
      double s = (double) slice / SLICES;
      int base = builder.vertex(radius * x, -height / 2, radius * z, out * x, up, out * z, s, 0);
      if (slice < SLICES) {
        double mx = x(slice + 0.5);
        double mz = z(slice + 0.5);
        double ms = (slice + 0.5) / SLICES;
        int apex = builder.vertex(0, height / 2, 0, out * mx, up, out * mz, ms, 1);
        builder.triangle(apex, base, base + 2);
      }
    }
  }

  /** Adds a disk at height y that faces up (side 1) or down (-1), as a triangle fan. */
  private static void cap(PrimitiveMeshBuilder builder, double radius, double y, int side) {
    int first = -1;
    for (int slice = 0; slice < SLICES; slice++) {
      double x = x(slice);
      double z = z(slice);
      int rim =
          builder.vertex(
              radius * x, y, radius * z, 0, side, 0, 0.5 + 0.5 * x, 0.5 - 0.5 * side * z);
      first = slice == 0 ? rim : first;
      if (slice > 1) {
        builder.triangle(first, side > 0 ? rim - 1 : rim, side > 0 ? rim : rim - 1);
      }
    }
  }

  private static double x(double slice) {
    return slice % SLICES == 0 ? 0 : -Math.sin(2 * Math.PI * slice / SLICES);
  }

  private static double z(double slice) {
    return slice % SLICES == 0 ? -1 : -Math.cos(2 * Math.PI * slice / SLICES);
  }
}

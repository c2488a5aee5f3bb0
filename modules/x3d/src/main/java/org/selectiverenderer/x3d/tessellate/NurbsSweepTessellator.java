package org.selectiverenderer.x3d.tessellate;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.geometry.mesh.TriangleMeshBuilder;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Tessellates NurbsSweptSurface and NurbsSwungSurface nodes (X3D 4.0, 27.4.13, 27.4.14) with smooth
 * normals, and NurbsCurve nodes as lines.
 */
final class NurbsSweepTessellator {
  private static final int LIMIT = 1_000_000;

  private NurbsSweepTessellator() {}

  /** Returns a NurbsCurve as lines. */
  static Mesh curve(TessellationContext job) {
    return Geometry2DTessellator.lines(
        job, floats(NurbsNodeReader.polyline(job.node(), job::problem)));
  }

  /** Sweeps a cross-section, in x and z of its plane as in an Extrusion, along a trajectory. */
  static Mesh swept(TessellationContext job) {
    double[] section = polyline(job, "crossSectionCurve");
    double[] path = polyline(job, "trajectoryCurve");
    int across = section.length / 2;
    int along = path.length / 3;
    if (across < 2 || along < 2) {
      return PrimitiveMeshBuilder.empty(job.node().bool("solid"));
    }
    SpineFrames frames = new SpineFrames(floats(path));
    return grid(
        job,
        across,
        along,
        (i, j, p) -> {
          for (int axis = 0; axis < 3; axis++) {
            p[axis] =
                path[3 * j + axis]
                    + section[2 * i] * frames.xAxis(j).get(axis)
                    + section[2 * i + 1] * frames.zAxis(j).get(axis);
          }
        });
  }

  /**
   * Swings a profile in the y-z plane along a trajectory in the x-z plane: each point of the
   * trajectory scales and rotates the profile about the y axis (The NURBS Book, 8.4).
   */
  static Mesh swung(TessellationContext job) {
    double[] profile = polyline(job, "profileCurve");
    double[] path = polyline(job, "trajectoryCurve");
    int across = profile.length / 2;
    int along = path.length / 2;
    if (across < 2 || along < 2) {
      return PrimitiveMeshBuilder.empty(job.node().bool("solid"));
    }
    return grid(
        job,
        across,
        along,
        (i, j, p) -> {
          p[0] = profile[2 * i] * path[2 * j];
          p[1] = profile[2 * i + 1];
          p[2] = profile[2 * i] * path[2 * j + 1];
        });
  }

  private static double[] polyline(TessellationContext job, String field) {
    @Nullable NodeView curve = job.node().node(field);
    return curve == null ? new double[0] : NurbsNodeReader.polyline(curve, job::problem);
  }

  @FunctionalInterface
  private interface Grid {
    void point(int i, int j, double[] into);
  }

  private static Mesh grid(TessellationContext job, int across, int along, Grid grid) {
    boolean solid = job.node().bool("solid");
    if ((long) across * along > LIMIT) {
      job.problem("has more than " + LIMIT + " points; it is left out");
      return PrimitiveMeshBuilder.empty(solid);
    }
    boolean ccw = job.node().bool("ccw");
    TriangleMeshBuilder form = new TriangleMeshBuilder();
    float[] texCoords = new float[2 * across * along];
    double[] p = new double[3];
    for (int j = 0; j < along; j++) {
      for (int i = 0; i < across; i++) {
        grid.point(i, j, p);
        int at = form.point(p[0], p[1], p[2]);
        texCoords[2 * at] = (float) i / (across - 1);
        texCoords[2 * at + 1] = (float) j / (along - 1);
        if (i > 0 && j > 0) {
          int below = at - across;
          form.quad(below - 1, ccw ? below : at - 1, at, ccw ? at - 1 : below);
        }
      }
    }
    TriangleMesh made = form.mesh();
    for (float value : made.positions()) {
      if (!Float.isFinite(value)) {
        job.problem("has points that are not finite; it is left out");
        return PrimitiveMeshBuilder.empty(solid);
      }
    }
    return MeshFactory.of(made, null, null, texCoords, Math.PI / 3, solid);
  }

  private static float[] floats(double[] doubles) {
    float[] floats = new float[doubles.length];
    for (int i = 0; i < doubles.length; i++) {
      floats[i] = (float) doubles[i];
    }
    return floats;
  }
}

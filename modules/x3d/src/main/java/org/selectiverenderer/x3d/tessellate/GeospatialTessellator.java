package org.selectiverenderer.x3d.tessellate;

import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.geodesy.GeoCoordinateTransform;

/** Tessellates GeoElevationGrid, and converts GeoCoordinate points (X3D 4.0, 25.3.2, 25.3.1). */
final class GeospatialTessellator {
  private GeospatialTessellator() {}

  /** Returns the points of a GeoCoordinate relative to the geometry's {@link GeoMeshOrigin}. */
  static float[] points(TessellationContext job, NodeView coord) {
    double[] given = (double[]) coord.value("point");
    GeoCoordinateTransform frame = frame(job, coord);
    Vector3d anchor = GeoMeshOrigin.of(job.node()).orElseGet(Vector3d::new);
    float[] xyz = new float[given.length / 3 * 3];
    for (int i = 0; i + 2 < given.length; i += 3) {
      put(frame.scene(given[i], given[i + 1], given[i + 2]).sub(anchor), xyz, i);
    }
    return xyz;
  }

  private static GeoCoordinateTransform frame(TessellationContext job, NodeView node) {
    GeoCoordinateTransform frame = GeoCoordinateTransform.of(node);
    frame.system().problem().ifPresent(job::problem);
    return frame;
  }

  private static void put(Vector3d at, float[] xyz, int i) {
    xyz[i] = (float) at.x;
    xyz[i + 1] = (float) at.y;
    xyz[i + 2] = (float) at.z;
  }

  /** Tessellates a GeoElevationGrid, whose rows run from south to north, each west to east. */
  static Mesh grid(TessellationContext job) {
    NodeView node = job.node();
    int columns = node.integer("xDimension");
    int rows = node.integer("zDimension");
    double[] heights = (double[]) node.value("height");
    double east = (Double) node.value("xSpacing");
    double north = (Double) node.value("zSpacing");
    boolean solid = node.bool("solid");
    if (columns < 2 || rows < 2) {
      return PrimitiveMeshBuilder.empty(solid);
    }
    if (!(east > 0 && north > 0)) {
      job.problem("has an xSpacing or zSpacing that is not above 0; it is left out");
      return PrimitiveMeshBuilder.empty(solid);
    }
    if (ElevationGridTessellator.tooFew(job, heights.length, columns, rows)) {
      return PrimitiveMeshBuilder.empty(solid);
    }
    GeoCoordinateTransform frame = frame(job, node);
    Vector3d anchor = GeoMeshOrigin.of(node).orElseGet(Vector3d::new);
    double[] corner = (double[]) node.value("geoGridOrigin");
    float yScale = node.number("yScale");
    float[] xyz = new float[3 * columns * rows];
    for (int row = 0, point = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++, point++) {
        double[] at =
            frame.system().step(corner, column * east, row * north, heights[point] * yScale);
        put(frame.scene(at[0], at[1], at[2]).sub(anchor), xyz, 3 * point);
      }
    }
    double creaseAngle = (Double) node.value("creaseAngle");
    return ElevationGridTessellator.mesh(job, xyz, columns, rows, true, creaseAngle);
  }
}

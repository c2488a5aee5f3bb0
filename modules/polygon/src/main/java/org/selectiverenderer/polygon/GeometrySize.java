package org.selectiverenderer.polygon;

import java.util.List;
import org.joml.Matrix4dc;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.tessellate.GeoMeshOrigin;

/**
 * The polygon count and the bounding box of a geometry node.
 *
 * @param polygons number of triangles
 * @param bounds bounding box in the geometry's coordinates
 */
public record GeometrySize(int polygons, BoundingBox bounds) {
  /** The size of geometry that draws nothing. */
  public static final GeometrySize NOTHING = new GeometrySize(0, BoundingBox.EMPTY);

  /**
   * @param mesh mesh of the geometry
   */
  static GeometrySize of(NodeView geometry, Mesh mesh) {
    BoundingBox own = mesh.isEmpty() ? BoundingBox.EMPTY : BoundingBox.of(mesh.bounds());
    BoundingBox placed =
        mesh.isEmpty()
            ? own
            : GeoMeshOrigin.of(geometry)
                .map(at -> BoundingBox.of(own.min().add(at), own.max().add(at)))
                .orElse(own);
    return new GeometrySize(mesh.polygons(), placed);
  }

  /**
   * Returns the total size of several copies.
   *
   * @param places transform of each copy from the geometry's coordinates to the shape's
   */
  GeometrySize copied(List<? extends Matrix4dc> places) {
    BoundingBox all = BoundingBox.EMPTY;
    for (Matrix4dc place : places) {
      all = bounds.isEmpty() ? all : all.union(bounds.transformed(place));
    }
    return new GeometrySize(
        (int) Math.min(Integer.MAX_VALUE, (long) polygons * places.size()), all);
  }
}

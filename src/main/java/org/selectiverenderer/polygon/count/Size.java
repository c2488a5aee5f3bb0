package org.selectiverenderer.polygon.count;

import java.util.List;
import org.joml.Matrix4dc;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.tessellate.GeoAnchor;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * The polygon count and the bounding box of a geometry node.
 *
 * @param polygons number of triangles
 * @param bounds bounding box in the geometry's coordinates
 */
public record Size(int polygons, Bounds bounds) {
  /** The size of geometry that draws nothing. */
  public static final Size NOTHING = new Size(0, Bounds.EMPTY);

  /**
   * @param mesh mesh of the geometry
   */
  static Size of(NodeView geometry, Mesh mesh) {
    Bounds own = mesh.isEmpty() ? Bounds.EMPTY : Bounds.of(mesh.bounds());
    Bounds placed =
        mesh.isEmpty()
            ? own
            : GeoAnchor.of(geometry)
                .map(at -> Bounds.of(own.min().add(at), own.max().add(at)))
                .orElse(own);
    return new Size(mesh.polygons(), placed);
  }

  /**
   * Returns the total size of several copies.
   *
   * @param places transform of each copy from the geometry's coordinates to the shape's
   */
  Size copied(List<? extends Matrix4dc> places) {
    Bounds all = Bounds.EMPTY;
    for (Matrix4dc place : places) {
      all = bounds.isEmpty() ? all : all.union(bounds.transformed(place));
    }
    return new Size((int) Math.min(Integer.MAX_VALUE, (long) polygons * places.size()), all);
  }
}

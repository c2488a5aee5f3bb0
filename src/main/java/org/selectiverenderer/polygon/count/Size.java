package org.selectiverenderer.polygon.count;

import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.tessellate.GeoAnchor;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * What is kept of a mesh.
 *
 * @param polygons triangles
 * @param bounds in the geometry's coordinates
 */
public record Size(int polygons, Bounds bounds) {
  /** Of geometry that draws nothing. */
  public static final Size NOTHING = new Size(0, Bounds.EMPTY);

  /**
   * @param mesh of the geometry
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
}

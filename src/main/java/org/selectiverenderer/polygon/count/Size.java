package org.selectiverenderer.polygon.count;

import java.util.List;
import org.joml.Matrix4dc;
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

  /**
   * The same in each of several places, together.
   *
   * @param places from the geometry's coordinates to the shape's
   */
  Size copied(List<? extends Matrix4dc> places) {
    Bounds all = Bounds.EMPTY;
    for (Matrix4dc place : places) {
      all = bounds.isEmpty() ? all : all.union(bounds.transformed(place));
    }
    return new Size((int) Math.min(Integer.MAX_VALUE, (long) polygons * places.size()), all);
  }
}

package org.selectiverenderer.polygon.count;

import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * What is kept of a mesh.
 *
 * @param polygons triangles
 * @param bounds in the geometry's coordinates
 */
public record Size(int polygons, Bounds bounds) {
  /** Of geometry that draws nothing. */
  public static final Size NOTHING = new Size(0, Bounds.EMPTY);

  static Size of(Mesh mesh) {
    return new Size(mesh.polygons(), mesh.isEmpty() ? Bounds.EMPTY : Bounds.of(mesh.bounds()));
  }
}

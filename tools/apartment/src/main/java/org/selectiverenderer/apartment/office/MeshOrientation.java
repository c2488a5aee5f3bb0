package org.selectiverenderer.apartment.office;

import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ParametricSurface;

/** Reorients meshes for the recipes of the office. */
final class MeshOrientation {

  private MeshOrientation() {}

  /** Returns a mesh about the y axis rotated to lie along z: its top points to the front. */
  static TriangleMesh forward(TriangleMesh upright) {
    return upright.turnX(90);
  }

  /** Returns a mesh about the y axis rotated to lie along x: its top points to the right. */
  static TriangleMesh sideways(TriangleMesh upright) {
    return upright.turnZ(-90);
  }

  /**
   * Returns the solid of an extruded side view, which is drawn as seen from the right with its
   * front at +x; the solid is centred on x and has its front at +z.
   */
  static TriangleMesh across(TriangleMesh sideView, double width) {
    return sideView.turnY(-90).move(width / 2, 0, 0);
  }

  /** Returns a flat rectangle about the origin that faces +z: two triangles. */
  static TriangleMesh flat(double width, double height) {
    return ParametricSurface.of(
        1, 1, (u, v) -> new Vector3d((u - 0.5) * width, (v - 0.5) * height, 0));
  }
}

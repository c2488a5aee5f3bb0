package org.selectiverenderer.apartment.office;

import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Sheet;

/** Small steps that many recipes need. */
final class Placing {

  private Placing() {}

  /** A mesh about the y axis laid down along z: what was up points to the front. */
  static TriangleMesh forward(TriangleMesh upright) {
    return upright.turnX(90);
  }

  /** A mesh about the y axis laid down along x: what was up points to the right. */
  static TriangleMesh sideways(TriangleMesh upright) {
    return upright.turnZ(-90);
  }

  /**
   * An extruded side view, seen from the right with its front at +x, made a solid that is centred
   * on x and has its front at +z.
   */
  static TriangleMesh across(TriangleMesh sideView, double width) {
    return sideView.turnY(-90).move(width / 2, 0, 0);
  }

  /** A flat rectangle about the origin that faces +z: two triangles. */
  static TriangleMesh flat(double width, double height) {
    return Sheet.of(1, 1, (u, v) -> new Vector3d((u - 0.5) * width, (v - 0.5) * height, 0));
  }
}

package org.selectiverenderer.geometry.tessellate;

import org.joml.Matrix4d;
import org.selectiverenderer.geometry.geo.GeoFrame;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Where geospatial groups place their children, in double precision (X3D 4.0, clause 25). */
final class GeoPlacement {
  private static final float[] NO_CENTER = {0, 0, 0};

  private GeoPlacement() {}

  /** GeoLocation (25.3.7): x east, y up, z south of its {@code geoCoords}. */
  static Matrix4d location(NodeView node) {
    return GeoFrame.of(node).place((double[]) node.value("geoCoords"));
  }

  /**
   * GeoTransform (25.3.11): moves, turns and scales what lies in the scene about the axes east, up
   * and south at its {@code geoCenter}.
   */
  static Matrix4d transform(NodeView node) {
    Matrix4d center = GeoFrame.of(node).place((double[]) node.value("geoCenter"));
    Matrix4d back = center.invertAffine(new Matrix4d());
    return TransformPlacement.of(
            center,
            node.floats("translation"),
            NO_CENTER,
            node.floats("rotation"),
            node.floats("scale"),
            node.floats("scaleOrientation"))
        .mul(back);
  }
}

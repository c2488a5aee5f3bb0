package org.selectiverenderer.geometry.tessellate;

import org.joml.Matrix4d;
import org.selectiverenderer.geometry.geo.GeoFrame;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Computes the transforms of geospatial grouping nodes in doubles (X3D 4.0, clause 25). */
final class GeoPlacement {
  private static final float[] NO_CENTER = {0, 0, 0};

  private GeoPlacement() {}

  /** Returns the transform of a GeoLocation (25.3.7): x east, y up, z south. */
  static Matrix4d location(NodeView node) {
    return GeoFrame.of(node).place((double[]) node.value("geoCoords"));
  }

  /**
   * Returns the transform of a GeoTransform (25.3.11), which translates, rotates and scales in the
   * local frame (east, up, south) of its {@code geoCenter}.
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

package org.selectiverenderer.browser.nodes.geospatial;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.event.KeyframeNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.geodesy.GeoCoordinateTransform;

/**
 * GeoPositionInterpolator (X3D 4.0, 25.3.8): interpolates geographic positions in their own
 * coordinate system, and sends the result both there and in scene coordinates.
 */
final class GeoPositionInterpolatorNode extends KeyframeNode {
  private final int keyValue;
  private final int geoValueChanged;
  private final int valueChanged;

  GeoPositionInterpolatorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    keyValue = type.indexOf("keyValue");
    geoValueChanged = type.indexOf("geovalue_changed");
    valueChanged = type.indexOf("value_changed");
  }

  @Override
  protected int values() {
    return ((double[]) value(keyValue)).length / 3;
  }

  @Override
  protected void send(int low, int count, float part, EventCascade cascade) {
    double[] values = (double[]) value(keyValue);
    double[] place = new double[3];
    for (int i = 0; i < 3; i++) {
      double from = values[3 * low + i];
      place[i] = part > 0 ? from + part * (values[3 * low + 3 + i] - from) : from;
    }
    Vector3d scene = GeoCoordinateTransform.of(this).scene(place[0], place[1], place[2]);
    emit(geoValueChanged, place, cascade);
    emit(valueChanged, new float[] {(float) scene.x, (float) scene.y, (float) scene.z}, cascade);
  }
}

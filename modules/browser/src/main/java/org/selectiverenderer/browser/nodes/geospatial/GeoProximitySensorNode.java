package org.selectiverenderer.browser.nodes.geospatial;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.sensor.ProximitySensorNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.geodesy.GeoCoordinateTransform;

/**
 * GeoProximitySensor (X3D 4.0, 25.3.9): a ProximitySensor around a geographic position that also
 * sends the viewer's geographic position. The centre is {@code geoCenter} (X3D 3.3), or {@code
 * center} if that is 0 0 0.
 */
final class GeoProximitySensorNode extends ProximitySensorNode {
  private final int geoCoordChanged;
  private final int geoCenter;
  private final int center;

  GeoProximitySensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    geoCoordChanged = type.indexOf("geoCoord_changed");
    geoCenter = type.indexOf("geoCenter");
    center = type.indexOf("center");
  }

  @Override
  protected float[] center() {
    double[] at = (double[]) value(geoCenter);
    if (at[0] == 0 && at[1] == 0 && at[2] == 0) {
      at = (double[]) value(center);
    }
    Vector3d scene = GeoCoordinateTransform.of(this).scene(at[0], at[1], at[2]);
    return new float[] {(float) scene.x, (float) scene.y, (float) scene.z};
  }

  @Override
  public boolean hasBoxOf(int field) {
    return field == geoCenter || super.hasBoxOf(field);
  }

  @Override
  protected void reportPosition(Vector3dc local, boolean moved, EventCascade cascade) {
    if (moved) {
      emit(geoCoordChanged, GeoCoordinateTransform.of(this).coordinates(local), cascade);
    }
  }
}

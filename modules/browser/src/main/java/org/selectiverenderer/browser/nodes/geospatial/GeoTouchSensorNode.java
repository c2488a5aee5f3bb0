package org.selectiverenderer.browser.nodes.geospatial;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.sensor.PointerHit;
import org.selectiverenderer.browser.nodes.sensor.TouchSensorNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.geodesy.GeoCoordinateTransform;

/**
 * GeoTouchSensor (X3D 4.0, 25.3.10): a TouchSensor that also sends the geographic position of the
 * point hit.
 */
final class GeoTouchSensorNode extends TouchSensorNode {
  private final int hitGeoCoord;

  GeoTouchSensorNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    hitGeoCoord = type.indexOf("hitGeoCoord_changed");
  }

  @Override
  protected void touched(PointerHit at, boolean entered, EventCascade cascade) {
    super.touched(at, entered, cascade);
    send(hitGeoCoord, GeoCoordinateTransform.of(this).coordinates(at.point()), entered, cascade);
  }
}

package org.selectiverenderer.browser.nodes.geospatial;

import java.util.Map;
import org.selectiverenderer.browser.scene.NodeConstructor;

/** The constructors of the geospatial nodes that have a behaviour, by node type name. */
public final class GeospatialNodeConstructors {
  public static final Map<String, NodeConstructor> MAKERS =
      Map.of(
          "GeoLocation", GeoGroupNode::new,
          "GeoTransform", GeoGroupNode::new,
          "GeoViewpoint", GeoViewpointNode::new,
          "GeoPositionInterpolator", GeoPositionInterpolatorNode::new,
          "GeoTouchSensor", GeoTouchSensorNode::new,
          "GeoProximitySensor", GeoProximitySensorNode::new,
          "GeoLOD", GeoLodNode::new);

  private GeospatialNodeConstructors() {}
}

package org.selectiverenderer.runtime.nodes.geo;

import java.util.Map;
import org.selectiverenderer.runtime.scene.NodeMaker;

/** The constructors of the geospatial nodes that have a behaviour, by node type name. */
public final class Geospatial {
  public static final Map<String, NodeMaker> MAKERS =
      Map.of(
          "GeoLocation", GeoGroupNode::new,
          "GeoTransform", GeoGroupNode::new,
          "GeoViewpoint", GeoViewpointNode::new,
          "GeoPositionInterpolator", GeoPositionInterpolatorNode::new,
          "GeoTouchSensor", GeoTouchSensorNode::new,
          "GeoProximitySensor", GeoProximitySensorNode::new,
          "GeoLOD", GeoLodNode::new);

  private Geospatial() {}
}

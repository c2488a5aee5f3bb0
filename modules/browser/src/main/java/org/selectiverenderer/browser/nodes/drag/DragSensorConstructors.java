package org.selectiverenderer.browser.nodes.drag;

import java.util.Map;
import org.selectiverenderer.browser.scene.NodeConstructor;

/** The constructors of the drag sensors, by node type name. */
public final class DragSensorConstructors {
  public static final Map<String, NodeConstructor> MAKERS =
      Map.of(
          "PlaneSensor", PlaneSensorNode::new,
          "SphereSensor", SphereSensorNode::new,
          "CylinderSensor", CylinderSensorNode::new);

  private DragSensorConstructors() {}
}

package org.selectiverenderer.runtime.nodes.drag;

import java.util.Map;
import org.selectiverenderer.runtime.scene.NodeMaker;

/** The constructors of the drag sensors, by node type name. */
public final class DragSensors {
  public static final Map<String, NodeMaker> MAKERS =
      Map.of(
          "PlaneSensor", PlaneSensorNode::new,
          "SphereSensor", SphereSensorNode::new,
          "CylinderSensor", CylinderSensorNode::new);

  private DragSensors() {}
}

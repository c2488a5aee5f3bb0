package org.selectiverenderer.polygon;

import java.util.List;
import org.selectiverenderer.schema.SensorSchemas;

/**
 * An area: a ProximitySensor with schema metadata, which activates schemas when the viewer enters
 * its box. Compared by identity.
 */
final class Area {
  final CountGraphNode sensor;
  final SensorSchemas schemas;
  final List<SensorBox> boxes;

  /**
   * @param boxes boxes of the sensor in world coordinates, at least one; a sensor that is USEd
   *     senses the union of its boxes
   */
  Area(CountGraphNode sensor, SensorSchemas schemas, List<SensorBox> boxes) {
    this.sensor = sensor;
    this.schemas = schemas;
    this.boxes = List.copyOf(boxes);
  }
}

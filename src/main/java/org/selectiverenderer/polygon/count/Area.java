package org.selectiverenderer.polygon.count;

import java.util.List;
import org.selectiverenderer.schema.SensorSchemas;

/** A part of the scene that activates schemas when the viewer enters it. Compared by identity. */
final class Area {
  final CountedItem sensor;
  final SensorSchemas schemas;
  final List<SensorBox> boxes;

  /**
   * @param boxes at least one: a sensor that is USEd senses the union of its boxes
   */
  Area(CountedItem sensor, SensorSchemas schemas, List<SensorBox> boxes) {
    this.sensor = sensor;
    this.schemas = schemas;
    this.boxes = List.copyOf(boxes);
  }
}

package org.selectiverenderer.authoring.area;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.polygon.SensorBox;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * An area of a document with its position in the scene.
 *
 * @param element its ProximitySensor
 * @param name the area's name
 * @param frame its local coordinate system
 * @param box its box in scene coordinates
 * @param solid the same as an oriented box; empty for an area that cannot be entered
 * @param elsewhere names of enclosing groups that are also used elsewhere by USE, so that the area
 *     has other instances
 */
public record AreaInstance(
    DocumentElement element,
    String name,
    SensorSchemas schemas,
    LocalCoordinateSystem frame,
    AreaBox box,
    Optional<SensorBox> solid,
    List<String> elsewhere) {
  public AreaInstance {
    elsewhere = List.copyOf(elsewhere);
  }

  /** Returns whether the area activates any schemas. */
  public boolean enriched() {
    return !schemas.enter().isEmpty() || !schemas.exit().isEmpty();
  }
}

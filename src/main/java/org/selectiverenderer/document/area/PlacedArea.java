package org.selectiverenderer.document.area;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.polygon.count.SensorBox;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * An area of a document where it is in the scene.
 *
 * @param element its ProximitySensor
 * @param name as the author calls it
 * @param frame that it stands in
 * @param box in the scene
 * @param solid the same as what may be turned; empty for one that nobody can enter
 * @param elsewhere names of groups around it that also stand at other places by USE, and take it
 *     along
 */
public record PlacedArea(
    DocumentElement element,
    String name,
    SensorSchemas schemas,
    AreaFrame frame,
    AreaBox box,
    Optional<SensorBox> solid,
    List<String> elsewhere) {
  public PlacedArea {
    elsewhere = List.copyOf(elsewhere);
  }

  /** Whether entering it means something. */
  public boolean enriched() {
    return !schemas.enter().isEmpty() || !schemas.exit().isEmpty();
  }
}

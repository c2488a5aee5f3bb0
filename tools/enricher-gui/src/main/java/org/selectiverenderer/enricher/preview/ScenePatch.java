package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * What a running scene has to take over to be another state of the text that it was loaded from:
 * values of fields that may change while a scene runs, and metadata. A value.
 *
 * @param from the revision of the document that the scene shows
 * @param revision that it shows with this
 * @param fields in document order
 * @param metadata of nodes, in document order
 * @param moved where start tags were that stand elsewhere now
 */
record ScenePatch(
    long from,
    long revision,
    List<Field> fields,
    List<Metadata> metadata,
    Map<Place, Place> moved) {

  /**
   * The place of a start tag, which a node of a running scene remembers.
   *
   * @param line from 1
   * @param column from 1
   */
  record Place(int line, int column) {}

  /**
   * Another value of a field.
   *
   * @param place of the node, before
   * @param type the name of the node's type
   * @param value as {@link org.selectiverenderer.x3d.field.FieldType} represents it
   */
  record Field(Place place, String type, String name, @Nullable Object value) {}

  /**
   * Other metadata of a node.
   *
   * @param place of the node, before
   * @param type the name of the node's type
   * @param text the elements; empty for none
   */
  record Metadata(Place place, String type, String text) {}
}

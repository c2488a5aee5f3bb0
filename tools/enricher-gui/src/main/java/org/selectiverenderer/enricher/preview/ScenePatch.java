package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * The changes that bring a running scene to another state of the text that it was loaded from:
 * values of fields that may change at run time, and metadata. A value.
 *
 * @param from the revision of the document that the scene shows
 * @param revision the revision that it shows after the patch
 * @param fields in document order
 * @param metadata of nodes, in document order
 * @param moved new positions of start tags that have moved, by their old positions
 */
record ScenePatch(
    long from,
    long revision,
    List<Field> fields,
    List<Metadata> metadata,
    Map<Place, Place> moved) {

  /**
   * The position of a start tag, by which a node of a running scene is found.
   *
   * @param line from 1
   * @param column from 1
   */
  record Place(int line, int column) {}

  /**
   * A new value of a field.
   *
   * @param place of the node, before
   * @param type the name of the node's type
   * @param value as {@link org.selectiverenderer.x3d.field.FieldType} represents it
   */
  record Field(Place place, String type, String name, @Nullable Object value) {}

  /**
   * New metadata of a node.
   *
   * @param place of the node, before
   * @param type the name of the node's type
   * @param text the elements; empty for none
   */
  record Metadata(Place place, String type, String text) {}
}

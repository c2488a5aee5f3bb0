package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The changes that bring a running scene to another state of the text that it was loaded from:
 * values of fields that may change at run time, metadata, names, and children of groups. A value.
 *
 * @param from the revision of the document that the scene shows
 * @param revision the revision that it shows after the patch
 * @param fields in document order
 * @param metadata of nodes, in document order
 * @param names of nodes that have another one
 * @param children other children of groups
 * @param moved new positions of start tags that have moved, by their old positions
 * @param shift how the start tags have moved that are behind all that has changed
 */
record ScenePatch(
    long from,
    long revision,
    List<Field> fields,
    List<Metadata> metadata,
    List<Name> names,
    List<Children> children,
    Map<Place, Place> moved,
    Optional<Shift> shift) {
  /** Returns where a start tag is after the patch. */
  Place after(Place before) {
    Place known = moved.get(before);
    return known != null ? known : shift.map(by -> by.after(before)).orElse(before);
  }

  /** Whether it changes nothing but metadata, which only the labels show. */
  boolean metadataOnly() {
    return fields.isEmpty() && children.isEmpty();
  }

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

  /**
   * Another DEF name of a node.
   *
   * @param place of the node, before
   * @param type the name of the node's type
   * @param was the name before; empty for none
   * @param is the name after; empty for none
   */
  record Name(Place place, String type, Optional<String> was, Optional<String> is) {}

  /**
   * Other children of a group.
   *
   * @param owner the group's place; empty for the scene itself
   * @param type the name of the group's type
   * @param removed the places of the children that are gone, before
   * @param unnamed the DEF names that are gone with them
   * @param sibling the place of the child, before, behind which the new ones are; empty for the
   *     beginning
   * @param added the new children, in the lines and columns where they are
   * @param count how many they are
   */
  record Children(
      Optional<Place> owner,
      String type,
      List<Place> removed,
      List<String> unnamed,
      Optional<Place> sibling,
      String added,
      int count) {}

  /**
   * How start tags have moved from a place on.
   *
   * @param from the place, before
   * @param to the place, after
   */
  record Shift(Place from, Place to) {
    Place after(Place before) {
      if (before.line() > from.line()) {
        return new Place(before.line() + to.line() - from.line(), before.column());
      }
      return before.line() == from.line() && before.column() >= from.column()
          ? new Place(to.line(), before.column() + to.column() - from.column())
          : before;
    }
  }
}

package org.selectiverenderer.x3d.write;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;

/** An item of a scene to be written: an element with typed values, or a comment. */
sealed interface SceneItem {
  /** A comment. */
  record Words(String text) implements SceneItem {}

  /**
   * A value of an element, neither DEF nor USE nor containerField.
   *
   * @param type the field type; null if unknown
   * @param text the text as it was written, without parts that are invalid for the type
   */
  record Value(String name, @Nullable FieldType type, String text) {}

  /**
   * The field of the parent that contains an element.
   *
   * @param name the name of the field; empty at the top level and in prototypes
   * @param multiple whether the field can have several nodes
   * @param usual whether it is the default containerField of the node
   */
  record Place(String name, boolean multiple, boolean usual) {}

  /** The place of an element that is not in a field. */
  Place NOWHERE = new Place("", true, true);

  /**
   * An element.
   *
   * @param name the name of the element
   * @param type the node type; null for a statement or a prototype instance
   * @param def the DEF name; empty for none
   * @param use the USE name; empty for none
   * @param source the code of a Script or shader; empty for none
   */
  record Element(
      String name,
      @Nullable NodeType type,
      String def,
      String use,
      Place place,
      List<Value> values,
      List<SceneItem> items,
      String source)
      implements SceneItem {
    /** Returns whether it represents a node. */
    boolean node() {
      return type != null || name.equals("ProtoInstance");
    }

    /** Returns a value's text; empty if it is not given. */
    String text(String value) {
      for (Value candidate : values) {
        if (candidate.name().equals(value)) {
          return candidate.text();
        }
      }
      return "";
    }

    /** Returns the child elements with a name. */
    List<Element> all(String element) {
      return items.stream()
          .filter(Element.class::isInstance)
          .map(Element.class::cast)
          .filter(item -> item.name().equals(element))
          .toList();
    }

    /** Returns the access type of a field declaration; outputOnly if it is invalid. */
    AccessType access() {
      for (AccessType access : AccessType.values()) {
        if (access.spelling().equals(text("accessType"))) {
          return access;
        }
      }
      return AccessType.OUTPUT_ONLY;
    }
  }
}

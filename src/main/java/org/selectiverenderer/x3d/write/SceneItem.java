package org.selectiverenderer.x3d.write;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldAccess;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;

/** What stands in a scene that is written anew: elements whose values have types, and comments. */
sealed interface SceneItem {
  /** A comment. */
  record Words(String text) implements SceneItem {}

  /**
   * A value of an element, neither DEF nor USE nor containerField.
   *
   * @param type null where nobody knows it
   * @param text as it was written, without what could not be read as that type
   */
  record Value(String name, @Nullable FieldType type, String text) {}

  /**
   * A field of the node around it.
   *
   * @param name empty where no field is named: at the top of a scene, in prototypes
   * @param usual whether a node of its kind gets there without being told, in XML
   */
  record Place(String name, boolean multiple, boolean usual) {}

  /** Where no field is named. */
  Place NOWHERE = new Place("", true, true);

  /**
   * An element.
   *
   * @param name of the element
   * @param type null for a statement or an instance of a prototype
   * @param def empty for none
   * @param use empty for none
   * @param source text in it: the code of a script or shader
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
    /** Whether it stands for a node. */
    boolean node() {
      return type != null || name.equals("ProtoInstance");
    }

    /** A value's text; empty if it is not given. */
    String text(String value) {
      for (Value candidate : values) {
        if (candidate.name().equals(value)) {
          return candidate.text();
        }
      }
      return "";
    }

    /** The elements of that name directly in it. */
    List<Element> all(String element) {
      return items.stream()
          .filter(Element.class::isInstance)
          .map(Element.class::cast)
          .filter(item -> item.name().equals(element))
          .toList();
    }

    /** The access that a field of an interface says; the one without values if it says none. */
    FieldAccess access() {
      for (FieldAccess access : FieldAccess.values()) {
        if (access.spelling().equals(text("accessType"))) {
          return access;
        }
      }
      return FieldAccess.OUTPUT_ONLY;
    }
  }
}

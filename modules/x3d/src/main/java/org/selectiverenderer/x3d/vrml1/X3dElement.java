package org.selectiverenderer.x3d.vrml1;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.XmlParseException;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field;

/** An X3D element to be written, which may still change and be used again by others. */
final class X3dElement {
  /**
   * An attribute.
   *
   * @param value the value; null for the characters of the text from {@code from} to {@code to}
   */
  private record Attribute(String name, @Nullable String value, int at, int from, int to) {}

  private final int start;
  private final int end;
  private final List<Attribute> attributes = new ArrayList<>(2);
  private final List<X3dElement> children = new ArrayList<>(1);
  private String name;
  private @Nullable String def;
  private @Nullable X3dElement used;

  /** Creates an element that stands for a part of the text. */
  X3dElement(String name, int start, int end) {
    this.name = name;
    this.start = start;
    this.end = end;
  }

  /** Creates an element at a node's start. */
  static X3dElement of(String name, Vrml1Node node) {
    return new X3dElement(name, node.start(), node.end());
  }

  /**
   * Creates an element at a node's type. Only one element that keeps characters of the text as
   * values may begin at an offset.
   */
  static X3dElement atType(String name, Vrml1Node node) {
    return new X3dElement(name, node.typeAt(), node.end());
  }

  /** Returns a use of this element, which must have a name. */
  X3dElement use(int at) {
    X3dElement use = new X3dElement(name, at, at);
    use.used = this;
    return use;
  }

  /** Returns the element that this one uses, or this one. */
  X3dElement original() {
    return used == null ? this : used;
  }

  /** Returns the offset at which it begins. */
  int start() {
    return start;
  }

  String name() {
    return name;
  }

  void rename(String newName) {
    name = newName;
  }

  @Nullable String def() {
    return def;
  }

  void def(@Nullable String newDef) {
    def = newDef;
  }

  List<X3dElement> children() {
    return children;
  }

  X3dElement add(X3dElement child) {
    children.add(child);
    return this;
  }

  /** Returns whether it is nothing but a container of its children. */
  boolean plainGroup() {
    return name.equals("Group") && def == null && used == null && attributes.isEmpty();
  }

  /** Sets an attribute to a value that is computed from what stands at an offset. */
  X3dElement set(String attribute, String value, int at) {
    attributes.add(new Attribute(attribute, value, at, at, at));
    return this;
  }

  /** Sets an attribute to a value that is computed from a field. */
  X3dElement set(String attribute, String value, Field from) {
    attributes.add(new Attribute(attribute, value, from.at(), from.from(), from.to()));
    return this;
  }

  /** Sets an attribute to the characters of a field, which are not copied. */
  X3dElement setAsWritten(String attribute, Field field) {
    attributes.add(new Attribute(attribute, null, field.at(), field.from(), field.to()));
    return this;
  }

  /**
   * Writes the element with its children.
   *
   * @param depth the number of elements that contain it
   * @throws XmlParseException at a limit
   */
  void write(ElementTreeBuilder document, PendingComments comments, int depth)
      throws XmlParseException {
    int most = document.limits().maxDepth();
    if (depth >= most) {
      String what =
          "the X3D elements that show these nodes are nested more than %s deep, with those for"
              + " lights and transformations";
      throw document.limit(start, what.formatted(most));
    }
    comments.before(start, document);
    String use = used == null ? null : used.def;
    document.open(name, def, use, start, start);
    if (use != null) {
      document.attribute("USE", use, start);
    }
    if (def != null) {
      document.attribute("DEF", def, start);
    }
    for (Attribute attribute : attributes) {
      if (attribute.value() == null) {
        document.attribute(attribute.name(), attribute.at(), attribute.from(), attribute.to());
      } else {
        document.attribute(
            attribute.name(), attribute.value(), attribute.at(), attribute.from(), attribute.to());
      }
    }
    for (X3dElement child : children) {
      child.write(document, comments, depth + 1);
    }
    document.close(Math.max(start, end));
  }
}

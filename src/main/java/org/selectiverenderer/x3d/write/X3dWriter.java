package org.selectiverenderer.x3d.write;

import java.util.ArrayDeque;
import java.util.Deque;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Writes X3D's XML encoding (ISO/IEC 19776-1) from its beginning to its end: an element a line,
 * indented by two blanks, attributes in single quotes as the thesis's listings have them. Elements
 * without content end in their tag. Not for several threads.
 */
public final class X3dWriter {
  private final StringBuilder text;
  private final Deque<String> open = new ArrayDeque<>();
  private boolean inTag;
  private boolean ownLine;

  public X3dWriter() {
    this(1000);
  }

  /**
   * @param capacity how many characters are expected
   */
  public X3dWriter(int capacity) {
    text = new StringBuilder(capacity);
  }

  /** Begins a file: its declaration and the X3D element. */
  public X3dWriter file(String profile, String version) {
    return declaration().open("X3D", "profile", profile, "version", version);
  }

  /** The first line of a file. */
  X3dWriter declaration() {
    text.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    return this;
  }

  /** A component statement of the head. */
  public X3dWriter component(String name, int level) {
    return empty("component", "name", name, "level", Integer.toString(level));
  }

  /** A unit statement of the head. */
  public X3dWriter unit(String category, String name, double factor) {
    String conversion = DecimalText.shortest(factor);
    return empty("unit", "category", category, "name", name, "conversionFactor", conversion);
  }

  /** A meta statement of the head. */
  public X3dWriter meta(String name, String content) {
    return empty("meta", "name", name, "content", content);
  }

  /** A route between named nodes. */
  public X3dWriter route(String fromNode, String fromField, String toNode, String toField) {
    return empty(
        "ROUTE",
        "fromNode",
        fromNode,
        "fromField",
        fromField,
        "toNode",
        toNode,
        "toField",
        toField);
  }

  /** An Appearance with a Material of these fields. */
  public X3dWriter material(String... fields) {
    return open("Appearance").empty("Material", fields).close();
  }

  /**
   * Begins an element; more attributes may follow.
   *
   * @param attributes names and values in turn
   */
  public X3dWriter open(String name, String... attributes) {
    endTag();
    indent().append('<').append(name);
    open.push(name);
    inTag = true;
    for (int i = 0; i < attributes.length; i += 2) {
      attribute(attributes[i], attributes[i + 1]);
    }
    return this;
  }

  /** An element without content. */
  public X3dWriter empty(String name, String... attributes) {
    return open(name, attributes).close();
  }

  /**
   * Begins a node.
   *
   * @param def its DEF name; empty for none
   * @param container the field of the parent that holds it; empty at the top of a scene
   */
  X3dWriter node(NodeType type, String def, String container) {
    return open(type.name()).def(def).container(type, container);
  }

  /** A node that was defined before. */
  X3dWriter use(NodeType type, String def, String container) {
    return open(type.name(), "USE", def).container(type, container).close();
  }

  /** Names the node begun last; empty for no name. */
  public X3dWriter def(String name) {
    return name.isEmpty() ? this : attribute("DEF", name);
  }

  private X3dWriter container(NodeType type, String container) {
    boolean usual = container.isEmpty() || container.equals(type.containerField());
    return usual ? this : attribute("containerField", container);
  }

  /** An attribute of the element begun last. */
  public X3dWriter attribute(String name, String value) {
    XmlAttribute.append(attribute(name), value, '\'');
    text.append('\'');
    return this;
  }

  /** An attribute of nothing but numbers, perhaps in several lines. */
  public X3dWriter numbers(String name, CharSequence numbers) {
    attribute(name).append(numbers).append('\'');
    return this;
  }

  /** Has the next attribute begin a line. */
  public X3dWriter ownLine() {
    ownLine = true;
    return this;
  }

  private StringBuilder attribute(String name) {
    if (!inTag) {
      throw new IllegalStateException("the tag that " + name + " belongs to has ended");
    }
    if (ownLine) {
      text.append('\n');
      indent();
    }
    text.append(ownLine ? "  " : " ").append(name).append("='");
    ownLine = false;
    return text;
  }

  /** Ends the element begun last of those that have not ended. */
  public X3dWriter close() {
    String name = open.pop();
    if (inTag) {
      text.append("/>\n");
      inTag = false;
    } else {
      indent().append("</").append(name).append(">\n");
    }
    return this;
  }

  /** A comment; two hyphens, which end one (XML 1.0, 2.5), are parted. */
  public X3dWriter comment(String words) {
    endTag();
    String safe = words.replace("--", "- -").replace("--", "- -");
    indent().append("<!-- ").append(safe).append(" -->\n");
    return this;
  }

  /** Text in the element begun last, as it is. */
  X3dWriter code(String code) {
    endTag();
    String safe = code.replace("]]>", "]]]]><![CDATA[>");
    indent().append("<![CDATA[").append(safe).append("]]>\n");
    return this;
  }

  private void endTag() {
    if (inTag) {
      text.append(">\n");
      inTag = false;
    }
  }

  private StringBuilder indent() {
    return text.append("  ".repeat(open.size()));
  }

  /** Ends all that is open; the text is complete. */
  public String finish() {
    while (!open.isEmpty()) {
      close();
    }
    return text.toString();
  }
}

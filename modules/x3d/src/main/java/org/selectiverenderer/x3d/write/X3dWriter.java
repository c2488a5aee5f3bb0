package org.selectiverenderer.x3d.write;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * Writes X3D's XML encoding (ISO/IEC 19776-1) sequentially: one element per line, indented by two
 * blanks, with attributes in single quotes as in the listings of the thesis, and with empty-element
 * tags for elements without content. Not thread-safe.
 */
public final class X3dWriter {
  private final StringBuilder text;
  private final long maxCharacters;
  private final Deque<String> open = new ArrayDeque<>();
  private boolean inTag;
  private boolean ownLine;

  /** Creates a writer for a short file. */
  public X3dWriter() {
    this(1000);
  }

  /**
   * Creates a writer.
   *
   * @param capacity the expected number of characters
   */
  public X3dWriter(int capacity) {
    this(capacity, Long.MAX_VALUE);
  }

  /**
   * Creates a writer of a text that must not become too long for the memory. What would make it
   * longer ends with an {@link UncheckedIOException}, whose cause says so in one sentence.
   *
   * @param capacity the expected number of characters
   * @param maxCharacters the maximum number of characters
   */
  public X3dWriter(int capacity, long maxCharacters) {
    text = new StringBuilder(capacity);
    this.maxCharacters = maxCharacters;
  }

  /** Begins a file with the XML declaration and the X3D element. */
  public X3dWriter file(String profile, String version) {
    return declaration().open("X3D", "profile", profile, "version", version);
  }

  /** Writes the XML declaration. */
  X3dWriter declaration() {
    text.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    return this;
  }

  /** Writes a component statement of the head. */
  public X3dWriter component(String name, int level) {
    return empty("component", "name", name, "level", Integer.toString(level));
  }

  /** Writes a unit statement of the head. */
  public X3dWriter unit(String category, String name, double factor) {
    String conversion = DecimalFormatter.shortest(factor);
    return empty("unit", "category", category, "name", name, "conversionFactor", conversion);
  }

  /** Writes a meta statement of the head. */
  public X3dWriter meta(String name, String content) {
    return empty("meta", "name", name, "content", content);
  }

  /** Writes a route between named nodes. */
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

  /** Writes an Appearance with a Material of these fields. */
  public X3dWriter material(String... fields) {
    return open("Appearance").empty("Material", fields).close();
  }

  /**
   * Begins an element; more attributes may follow.
   *
   * @param attributes alternating names and values
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

  /** Writes an element without content. */
  public X3dWriter empty(String name, String... attributes) {
    return open(name, attributes).close();
  }

  /**
   * Begins a node.
   *
   * @param def its DEF name; empty for none
   * @param container the field of the parent that contains it; empty at the top level
   */
  X3dWriter node(NodeType type, String def, String container) {
    return open(type.name()).def(def).container(type, container);
  }

  /** Writes a USE of a node. */
  X3dWriter use(NodeType type, String def, String container) {
    return open(type.name(), "USE", def).container(type, container).close();
  }

  /** Writes the DEF of the current node, unless the name is empty. */
  public X3dWriter def(String name) {
    return name.isEmpty() ? this : attribute("DEF", name);
  }

  private X3dWriter container(NodeType type, String container) {
    boolean usual = container.isEmpty() || ContainerFieldRules.isAlwaysDefault(type, container);
    return usual ? this : attribute("containerField", container);
  }

  /** Writes an attribute of the current element. */
  public X3dWriter attribute(String name, String value) {
    makeRoom(value);
    XmlAttributeEscaper.append(attribute(name), value, '\'');
    text.append('\'');
    return this;
  }

  /** Writes an attribute of numbers only, possibly in several lines. */
  public X3dWriter numbers(String name, CharSequence numbers) {
    makeRoom(numbers);
    attribute(name).append(numbers).append('\'');
    return this;
  }

  /** Starts the next attribute on a new line. */
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

  /** Ends the current element. */
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

  /** Writes a comment; double hyphens, which XML 1.0, 2.5 forbids there, are separated. */
  public X3dWriter comment(String words) {
    endTag();
    makeRoom(words);
    String safe = words.replace("--", "- -").replace("--", "- -");
    indent().append("<!-- ").append(safe).append(" -->\n");
    return this;
  }

  /** Writes text in the current element as CDATA. */
  X3dWriter code(String code) {
    endTag();
    makeRoom(code);
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

  /** Refuses what would make the text longer than it may be, before it is in memory again. */
  private void makeRoom(CharSequence more) {
    if (text.length() + (long) more.length() > maxCharacters) {
      throw new UncheckedIOException(
          new IOException(
              String.format(
                  Locale.ROOT,
                  "it becomes an X3D text of more than %.1f MB, which is the limit; "
                      + "make it smaller, or give Java a larger heap (-Xmx)",
                  maxCharacters / 1e6)));
    }
  }

  private StringBuilder indent() {
    makeRoom("");
    return text.append("  ".repeat(open.size()));
  }

  /** Ends all open elements and returns the text. */
  public String finish() {
    while (!open.isEmpty()) {
      close();
    }
    return text.toString();
  }
}

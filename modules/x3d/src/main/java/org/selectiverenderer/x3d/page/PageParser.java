package org.selectiverenderer.x3d.page;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.page.HtmlTokenizer.Attribute;
import org.selectiverenderer.x3d.page.HtmlTokenizer.Kind;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.ValueCommentStripper;
import org.selectiverenderer.x3d.source.XmlParseException;

/** Parses the first {@code x3d} element of an HTML or XHTML page. */
public final class PageParser implements ElementTreeBuilder.Parser {
  /** More attributes than any node has. */
  private static final int MOST_ATTRIBUTES = 1000;

  /** The characters of the longest reference that is read, such as {@code &#x10ffff;}. */
  private static final int LONGEST_REFERENCE = 11;

  private static final String ROOT = "x3d";
  private static final String SCRIPT = "Script";

  private final NodeCatalogue catalogue;

  /** Creates a parser for the node types of a catalogue. */
  public PageParser(NodeCatalogue catalogue) {
    this.catalogue = catalogue;
  }

  @Override
  public ValueCommentStripper cleaner() {
    return (value, length) -> {
      // attributes have no comments
    };
  }

  @Override
  public void parse(ElementTreeBuilder document) throws XmlParseException {
    HtmlTokenizer tags = new HtmlTokenizer(document.text(), MOST_ATTRIBUTES);
    if (!find(tags)) {
      throw document.fault(0, "this is an HTML page without an x3d element, so it holds no scene");
    }
    new Reading(document, tags, new PageNames(catalogue), catalogue).scene();
    if (find(tags)) {
      document.leftOut(
          tags.start(),
          "the page has more than one x3d element; the first is read, this one and any further ones"
              + " are left out");
    }
  }

  /** Goes to the start tag of the next x3d element; returns false if there is none. */
  private static boolean find(HtmlTokenizer tags) {
    for (Kind kind = tags.next(); kind != Kind.END; kind = tags.next()) {
      if (kind == Kind.START_TAG) {
        switch (PageNames.lower(tags.name())) {
          case ROOT -> {
            return true;
          }
          case "script", "style", "textarea", "title", "noscript" -> {
            if (!tags.isClosed()) {
              tags.skipRawText();
            }
          }
          default -> {
            // what is around the scene
          }
        }
      }
    }
    return false;
  }

  /** The parsing of one scene. */
  private static final class Reading {
    private final ElementTreeBuilder document;
    private final HtmlTokenizer tags;
    private final PageNames names;
    private final NodeCatalogue catalogue;
    private final List<String> open = new ArrayList<>();

    Reading(
        ElementTreeBuilder document, HtmlTokenizer tags, PageNames names, NodeCatalogue catalogue) {
      this.document = document;
      this.tags = tags;
      this.names = names;
      this.catalogue = catalogue;
    }

    /** Parses the element whose start tag has been found. */
    void scene() throws XmlParseException {
      start();
      while (!open.isEmpty()) {
        switch (tags.next()) {
          case START_TAG -> start();
          case END_TAG -> end(names.element(tags.name()));
          case COMMENT -> document.comment(content(), tags.start());
          case CHARACTER_DATA -> characters();
          case OTHER -> {
            // a processing instruction
          }
          case END -> throw document.fault(tags.start(), "the page ends within the x3d element");
        }
      }
    }

    private String content() {
      return document.text().subSequence(tags.contentFrom(), tags.contentTo()).toString();
    }

    private void characters() {
      String characters = content();
      if (!characters.isBlank()) {
        boolean plain = document.text().charAt(tags.start()) == '<';
        document.text(plain ? characters : resolved(characters), tags.contentFrom());
      }
    }

    private void start() throws XmlParseException {
      String element = names.element(tags.name());
      if (tags.attributes().size() > MOST_ATTRIBUTES) {
        throw document.limit(
            tags.start(), "an element has more than " + MOST_ATTRIBUTES + " attributes");
      }
      document.open(
          element, named(element, "DEF"), named(element, "USE"), tags.start(), tags.end());
      open.add(element);
      Set<String> given = new HashSet<>();
      for (Attribute attribute : tags.attributes()) {
        String name = names.attribute(element, attribute.name());
        if (!names.ofPage(element, attribute.name()) && given.add(name)) {
          attribute(element, name, attribute);
        }
      }
      if (element.equals("X3D")) {
        implied(given, "profile", "Full");
        implied(given, "version", "4.0");
      }
      if (tags.isClosed()) {
        end(element);
      } else if (element.equals(SCRIPT)) {
        script();
      }
    }

    private void implied(Set<String> given, String name, String value) {
      if (given.add(name)) {
        document.attribute(name, value, tags.start());
      }
    }

    private @Nullable String named(String element, String name) {
      for (Attribute attribute : tags.attributes()) {
        if (names.attribute(element, attribute.name()).equals(name)) {
          return resolved(written(attribute));
        }
      }
      return null;
    }

    private String written(Attribute attribute) {
      return document.text().subSequence(attribute.from(), attribute.to()).toString();
    }

    private void attribute(String element, String name, Attribute attribute) {
      FieldType type =
          catalogue
              .find(element)
              .flatMap(found -> found.field(name))
              .map(FieldDefinition::type)
              .orElse(null);
      boolean words = type == null || type.kind() == FieldType.Kind.STRING;
      String written = written(attribute);
      boolean plain = written.indexOf('&') < 0;
      if (plain && !words && type.kind() != FieldType.Kind.BOOLEAN) {
        document.attribute(name, attribute.at(), attribute.from(), attribute.to());
        return;
      }
      String value = resolved(written);
      if (type == FieldType.MFString && !value.isBlank() && !value.strip().startsWith("\"")) {
        value = FieldTokenizer.string(value.strip()); // one string, as X3DOM reads it
      } else if (type != null && type.kind() == FieldType.Kind.BOOLEAN) {
        value = PageNames.lower(value.strip());
      }
      document.attribute(name, value, attribute.at(), attribute.from(), attribute.to());
    }

    /** Reads the text of a Script, in which no tags are. */
    private void script() {
      int at = tags.end();
      tags.skipRawText();
      String program = content();
      int data = program.indexOf("<![CDATA[");
      int end = program.lastIndexOf("]]>");
      boolean wrapped = data >= 0 && end > data;
      String code = wrapped ? program.substring(data + "<![CDATA[".length(), end) : program;
      if (!code.isBlank()) {
        document.text(code, at);
      }
    }

    /** Ends an element with all that is open within it; does nothing if it is not open. */
    private void end(String element) {
      if (!open.contains(element)) {
        return;
      }
      String ended;
      do {
        ended = open.remove(open.size() - 1);
        document.close(tags.end());
      } while (!ended.equals(element));
    }
  }

  /** Replaces character references; what is none stays as it is written. */
  private static String resolved(String text) {
    if (text.indexOf('&') < 0) {
      return text;
    }
    StringBuilder plain = new StringBuilder(text.length());
    int at = 0;
    for (int mark = text.indexOf('&'); mark >= 0; mark = text.indexOf('&', at)) {
      plain.append(text, at, mark);
      String near = text.substring(mark, Math.min(text.length(), mark + LONGEST_REFERENCE));
      int end = near.indexOf(';') < 0 ? -1 : mark + near.indexOf(';');
      String character = end < 0 ? null : character(text.substring(mark + 1, end));
      plain.append(character == null ? "&" : character);
      at = character == null ? mark + 1 : end + 1;
    }
    return plain.append(text, at, text.length()).toString();
  }

  private static @Nullable String character(String reference) {
    return switch (reference) {
      case "amp" -> "&";
      case "lt" -> "<";
      case "gt" -> ">";
      case "quot" -> "\"";
      case "apos" -> "'";
      case "nbsp" -> " ";
      default -> reference.startsWith("#") ? numbered(reference.substring(1)) : null;
    };
  }

  private static @Nullable String numbered(String number) {
    try {
      boolean hexadecimal = number.startsWith("x") || number.startsWith("X");
      int code = hexadecimal ? Integer.parseInt(number.substring(1), 16) : Integer.parseInt(number);
      return Character.isValidCodePoint(code) && code > 0 ? Character.toString(code) : null;
    } catch (NumberFormatException e) {
      return null; // no reference
    }
  }
}

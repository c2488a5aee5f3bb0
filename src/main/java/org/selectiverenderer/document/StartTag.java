package org.selectiverenderer.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The attributes of an element, read from the text when they are asked for. */
public final class StartTag {
  private final List<Attribute> attributes;
  private final int end;

  private StartTag(List<Attribute> attributes, int end) {
    this.attributes = attributes;
    this.end = end;
  }

  /** Reads the tag of an element whose text is well formed. */
  static StartTag of(DocumentElement element, CharSequence text) {
    List<Attribute> attributes = new ArrayList<>();
    int limit = element.tagEnd();
    int at = skipName(text, element.start() + 1, limit);
    int end = at;
    while (true) {
      at = skipSpace(text, at, limit);
      if (at >= limit || text.charAt(at) == '>' || text.charAt(at) == '/') {
        return new StartTag(List.copyOf(attributes), end);
      }
      int from = at;
      at = skipName(text, at, limit);
      final String name = text.subSequence(from, at).toString();
      at = skipSpace(text, at, limit) + 1; // the equals sign
      at = skipSpace(text, at, limit);
      char quote = text.charAt(at);
      int valueFrom = at + 1;
      int valueTo = valueFrom;
      while (valueTo < limit && text.charAt(valueTo) != quote) {
        valueTo++;
      }
      String value = XmlValues.read(text, valueFrom, valueTo);
      attributes.add(new Attribute(name, from, valueFrom, valueTo, value));
      at = valueTo + 1;
      end = at;
    }
  }

  private static int skipName(CharSequence text, int from, int limit) {
    int at = from;
    while (at < limit && text.charAt(at) > ' ' && "=/>".indexOf(text.charAt(at)) < 0) {
      at++;
    }
    return at;
  }

  private static int skipSpace(CharSequence text, int from, int limit) {
    int at = from;
    while (at < limit && text.charAt(at) <= ' ') {
      at++;
    }
    return at;
  }

  /** In the order of the text. */
  public List<Attribute> attributes() {
    return attributes;
  }

  public Optional<Attribute> attribute(String name) {
    for (Attribute attribute : attributes) {
      if (attribute.name().equals(name)) {
        return Optional.of(attribute);
      }
    }
    return Optional.empty();
  }

  /** The offset behind the last attribute, or behind the name: where another one goes. */
  public int end() {
    return end;
  }
}

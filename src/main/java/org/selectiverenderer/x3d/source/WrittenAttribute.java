package org.selectiverenderer.x3d.source;

/**
 * An attribute as it stands in a start tag; good as long as the text stays as it is.
 *
 * @param text that it stands in
 * @param name as it is written, prefix included
 * @param from offset of the name
 * @param valueFrom offset of the value, behind its quote
 * @param valueTo offset of the quote that ends it
 * @param entities that the value may refer to
 */
public record WrittenAttribute(
    CharSequence text, String name, int from, int valueFrom, int valueTo, Entities entities) {
  /** The value with references replaced and white space as XML reads it. */
  public String value() {
    return XmlReferences.read(text, valueFrom, valueTo, ' ', entities);
  }

  /** The same with the ends of its lines, which XML takes for blanks: for programs. */
  String lines() {
    return XmlReferences.read(text, valueFrom, valueTo, '\n', entities);
  }

  /** Whether a part of the value, or all, comes out of an entity of the DOCTYPE. */
  public boolean fromEntity() {
    return entities.within(text, valueFrom, valueTo);
  }

  /** The value as it is written, references and all. */
  String written() {
    return text.subSequence(valueFrom, valueTo).toString();
  }

  /** Whether it declares a namespace. */
  public boolean declaration() {
    return name.equals("xmlns") || name.startsWith("xmlns:");
  }

  /** The offset of a character of the value, counted from the first that is no white space. */
  int at(int character) {
    int at = valueFrom;
    while (at < valueTo && text.charAt(at) <= ' ') {
      at++;
    }
    for (int i = 0; i < character && at < valueTo; i++) {
      if (text.charAt(at) == '&') {
        int start = at;
        while (at < valueTo && text.charAt(at) != ';') {
          at++;
        }
        // A reference is one character, two beyond the basic plane.
        i += XmlReferences.read(text, start, Math.min(at + 1, valueTo)).length() == 2 ? 1 : 0;
      }
      // CR LF is one character, as XML reads it (XML 1.0, 2.11).
      boolean two = at + 1 < valueTo && text.charAt(at) == '\r' && text.charAt(at + 1) == '\n';
      at += two ? 2 : 1;
    }
    return Math.min(at, valueTo);
  }
}

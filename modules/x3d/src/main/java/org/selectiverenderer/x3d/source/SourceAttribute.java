package org.selectiverenderer.x3d.source;

/**
 * An attribute as written in a start tag; valid until the text changes.
 *
 * @param text the text that contains it
 * @param name the qualified name, with its prefix
 * @param from the offset of the name
 * @param valueFrom the offset of the value, after its quote
 * @param valueTo the offset of the quote that ends the value
 * @param entities the entities for references in the value
 */
public record SourceAttribute(
    CharSequence text, String name, int from, int valueFrom, int valueTo, EntityTable entities) {
  /** Returns the normalized value, with references resolved (XML 1.0, 3.3.3). */
  public String value() {
    return AttributeValueNormalizer.read(text, valueFrom, valueTo, ' ', entities);
  }

  /** Returns the value with its line ends, which XML normalizes to blanks, for programs. */
  String lines() {
    return AttributeValueNormalizer.read(text, valueFrom, valueTo, '\n', entities);
  }

  /** Returns whether the value refers to an entity of the DOCTYPE. */
  public boolean fromEntity() {
    return entities.within(text, valueFrom, valueTo);
  }

  /** Returns the value as it is written, with references. */
  String written() {
    return text.subSequence(valueFrom, valueTo).toString();
  }

  /** Returns whether it is a namespace declaration. */
  public boolean declaration() {
    return name.equals("xmlns") || name.startsWith("xmlns:");
  }

  /** Returns the offset of a character of the value, counted from the first non-blank one. */
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
        // a reference is one char, or two for a supplementary character
        i +=
            AttributeValueNormalizer.read(text, start, Math.min(at + 1, valueTo)).length() == 2
                ? 1
                : 0;
      }
      // CRLF is one character in XML (XML 1.0, 2.11)
      boolean two = at + 1 < valueTo && text.charAt(at) == '\r' && text.charAt(at + 1) == '\n';
      at += two ? 2 : 1;
    }
    return Math.min(at, valueTo);
  }
}

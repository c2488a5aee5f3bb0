package org.selectiverenderer.x3d.source;

import org.selectiverenderer.x3d.source.DocumentError.Kind;

/**
 * Masks the entity references in the attributes of a text by placeholder characters of the same
 * length, so that a parser without entity expansion can read the text with unchanged offsets.
 * References in element content are kept and reported by the parser.
 */
final class EntityMasker {
  private final CharSequence text;
  private final EntityTable entities;
  private final char[] masked;
  private long grown;

  private EntityMasker(CharSequence text, EntityTable entities) {
    this.text = text;
    this.entities = entities;
    this.masked = new char[text.length()];
    for (int i = 0; i < masked.length; i++) {
      masked[i] = text.charAt(i);
    }
  }

  /**
   * Returns the masked text.
   *
   * @param shift a number that converts offsets in the text to those in the source
   * @throws XmlParseException if the expansions of the references are too long
   */
  static SourceText of(SourceText text, EntityTable entities, ElementSource source, int shift)
      throws XmlParseException {
    EntityMasker mask = new EntityMasker(text, entities);
    int from = shift == 0 && text.length() >= entities.end() ? entities.end() : 0;
    mask.fill(from, source, shift);
    return SourceText.of(new String(mask.masked));
  }

  private void fill(int from, ElementSource source, int shift) throws XmlParseException {
    int i = from;
    while (i < masked.length) {
      if (masked[i] != '<') {
        i++;
      } else if (starts(i, "<!--")) {
        i = behind(i, "-->");
      } else if (starts(i, "<![CDATA[")) {
        i = behind(i, "]]>");
      } else if (starts(i, "<?")) {
        i = behind(i, "?>");
      } else {
        i = tag(i, source, shift);
      }
    }
  }

  private int tag(int open, ElementSource source, int shift) throws XmlParseException {
    char quote = 0;
    for (int i = open; i < masked.length; i++) {
      char c = masked[i];
      if (quote == 0 && c == '>') {
        return i + 1;
      }
      if (quote == 0) {
        quote = c == '"' || c == '\'' ? c : 0;
      } else if (c == quote) {
        quote = 0;
      } else if (c == '&') {
        i = reference(i, source, shift);
      }
    }
    return masked.length;
  }

  private int reference(int at, ElementSource source, int shift) throws XmlParseException {
    String name = EntityTable.name(text, at, text.length());
    if (entities.find(name).isEmpty()) {
      return at;
    }
    grown += entities.value(name).map(String::length).orElse(0);
    if (grown > EntityTable.MOST) {
      String why =
          "the entities of the DOCTYPE expand to more than "
              + EntityTable.MOST
              + " characters, which is not plausible for a scene";
      throw new XmlParseException(
          new DocumentError(Kind.LIMIT, source.location(Math.max(0, at + shift)), why));
    }
    int end = at + name.length() + 2;
    for (int i = at; i < end; i++) {
      masked[i] = '_';
    }
    return end - 1;
  }

  private boolean starts(int at, String word) {
    for (int i = 0; i < word.length(); i++) {
      if (at + i >= masked.length || masked[at + i] != word.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  private int behind(int from, String word) {
    int i = from;
    while (i < masked.length && !starts(i, word)) {
      i++;
    }
    return Math.min(masked.length, i + word.length());
  }
}

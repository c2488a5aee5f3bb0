package org.selectiverenderer.x3d.source;

import org.selectiverenderer.x3d.source.DocumentError.Kind;

/**
 * Finds the references to declared entities in a text: in attribute values and in element content,
 * but not in comments, CDATA sections and processing instructions (XML 1.0, 4.4). Bounds the length
 * of all expansions of a text.
 */
abstract class EntityReferenceScanner {
  final EntityTable entities;
  private long grown;

  EntityReferenceScanner(EntityTable entities) {
    this.entities = entities;
  }

  /** Called when the expansions of a text would be too long. */
  static final class TooLong extends Exception {
    private static final long serialVersionUID = 1L;

    private final int at;

    TooLong(int at) {
      super(null, null, false, false);
      this.at = at;
    }

    /** Returns the error, which locates the reference. */
    DocumentError fault(ElementSource source, int shift) {
      String why =
          "the entities of the DOCTYPE expand to more than "
              + EntityTable.MOST
              + " characters, which is not plausible for a scene";
      return new DocumentError(Kind.LIMIT, source.location(Math.max(0, at + shift)), why);
    }
  }

  /**
   * Called for a reference in an attribute value.
   *
   * @param at the offset of the reference
   * @param end the offset after it
   * @param quote the quote around the value
   */
  abstract void attribute(CharSequence text, int at, int end, String name, char quote)
      throws TooLong;

  /** Called for a reference in element content. */
  void content(CharSequence text, int at, int end, String name) throws TooLong {}

  /**
   * Counts the length of an expansion, and of its reference, since even empty entities take time.
   */
  final void spend(long length, int at) throws TooLong {
    grown += length;
    if (grown > EntityTable.MOST) {
      throw new TooLong(at);
    }
  }

  /** Scans a text from an offset in element content. */
  final void scan(CharSequence text, int from) throws TooLong {
    int i = from;
    while (i < text.length()) {
      char c = text.charAt(i);
      if (c == '<') {
        i = markup(text, i);
      } else if (c == '&') {
        String name = EntityTable.name(text, i, text.length());
        if (entities.find(name).isPresent()) {
          content(text, i, i + name.length() + 2, name);
          i += name.length() + 2;
        } else {
          i++;
        }
      } else {
        i++;
      }
    }
  }

  private int markup(CharSequence text, int at) throws TooLong {
    int skipped = unparsed(text, at);
    if (skipped > at) {
      return skipped;
    }
    char quote = 0;
    for (int i = at; i < text.length(); i++) {
      char c = text.charAt(i);
      if (quote == 0 && c == '>') {
        return i + 1;
      }
      if (quote == 0) {
        quote = c == '"' || c == '\'' ? c : 0;
      } else if (c == quote) {
        quote = 0;
      } else if (c == '&') {
        String name = EntityTable.name(text, i, text.length());
        if (entities.find(name).isPresent()) {
          attribute(text, i, i + name.length() + 2, name, quote);
          i += name.length() + 1;
        }
      }
    }
    return text.length();
  }

  /** Returns the offset after a comment, CDATA section or instruction; else the given offset. */
  private static int unparsed(CharSequence text, int at) {
    if (DoctypeParser.starts(text, at, "<!--")) {
      return behind(text, at + 4, "-->");
    }
    if (DoctypeParser.starts(text, at, "<![CDATA[")) {
      return behind(text, at, "]]>");
    }
    return DoctypeParser.starts(text, at, "<?") ? behind(text, at, "?>") : at;
  }

  private static int behind(CharSequence text, int from, String word) {
    int i = from;
    while (i < text.length() && !DoctypeParser.starts(text, i, word)) {
      i++;
    }
    return Math.min(text.length(), i + word.length());
  }

  /** Returns whether each element of a replacement text begins and ends in it (XML 1.0, 4.3.2). */
  static boolean balanced(CharSequence text) {
    int depth = 0;
    for (int i = 0; i < text.length(); ) {
      int next = text.charAt(i) == '<' ? unparsed(text, i) : i + 1;
      if (next == i) {
        boolean end = DoctypeParser.starts(text, i, "</");
        next = tagEnd(text, i);
        if (next < 0) {
          return false;
        }
        depth += end ? -1 : text.charAt(next - 2) == '/' ? 0 : 1;
      }
      if (depth < 0) {
        return false;
      }
      i = next;
    }
    return depth == 0;
  }

  /** Returns the offset after a tag; -1 if it is not closed. */
  private static int tagEnd(CharSequence text, int at) {
    char quote = 0;
    for (int i = at; i < text.length(); i++) {
      char c = text.charAt(i);
      if (quote == 0 && c == '>') {
        return i + 1;
      }
      quote = quote == 0 ? (c == '"' || c == '\'' ? c : 0) : c == quote ? 0 : quote;
    }
    return -1;
  }
}

package org.selectiverenderer.x3d.source;

import org.jspecify.annotations.Nullable;

/**
 * Replaces the references to internal entities of a text's DOCTYPE by what they stand for (XML 1.0,
 * 4.4), so that a parser without entity expansion reads the whole scene. References that cannot be
 * expanded are kept, and the parser reports them. For one text.
 */
final class EntityExpander extends EntityReferenceScanner {
  private final StringBuilder out;
  private final ExpansionMapping mapping = new ExpansionMapping();
  private int copied;
  private int reference = -1;
  private @Nullable TooLong limit;

  private EntityExpander(SourceText text, EntityTable entities) {
    super(entities);
    this.out = new StringBuilder(text.length() + 1024);
    try {
      scan(text, Math.min(entities.end(), text.length()));
      out.append(text, copied, text.length());
    } catch (TooLong e) {
      limit = new TooLong(reference);
      // the tag of an unfinished value is left out, too
      out.setLength(Math.max(0, Math.max(out.lastIndexOf("<"), out.lastIndexOf(">") + 1)));
    }
  }

  static EntityExpander of(SourceText text, EntityTable entities) {
    return new EntityExpander(text, entities);
  }

  /** Returns the expanded text, up to the reference that exceeds the limit. */
  CharSequence text() {
    return out;
  }

  /** Returns the mapping of its offsets to those of the original text. */
  ExpansionMapping mapping() {
    return mapping;
  }

  /** Returns the reference from which on the expansions are too long; null if there is none. */
  @Nullable TooLong limit() {
    return limit;
  }

  @Override
  void attribute(CharSequence text, int at, int end, String name, char quote) throws TooLong {
    String value = entities.value(name).orElse(null);
    if (value == null || value.indexOf('<') >= 0) {
      return;
    }
    boolean outer = begin(text, at);
    String literal = value.replace(String.valueOf(quote), quote == '"' ? "&quot;" : "&apos;");
    spend(end - at + literal.length(), reference);
    out.append(literal);
    finish(outer, end);
  }

  @Override
  void content(CharSequence text, int at, int end, String name) throws TooLong {
    String value = entities.written(name).orElse(null);
    if (value == null || !EntityReferenceScanner.balanced(value)) {
      return;
    }
    boolean outer = begin(text, at);
    spend(end - at + value.length(), reference);
    int before = copied;
    copied = 0;
    scan(value, 0);
    out.append(value, copied, value.length());
    copied = before;
    finish(outer, end);
  }

  /** Copies the text before a reference; returns whether it is not within an entity itself. */
  private boolean begin(CharSequence text, int at) {
    boolean outer = reference < 0;
    out.append(text, copied, at);
    if (outer) {
      reference = at;
      mapping.begin(out.length(), at);
    }
    return outer;
  }

  private void finish(boolean outer, int end) {
    copied = end;
    if (outer) {
      mapping.end(out.length(), end);
      reference = -1;
    }
  }
}

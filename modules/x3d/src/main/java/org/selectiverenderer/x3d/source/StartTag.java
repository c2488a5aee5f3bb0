package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** The attributes of a start tag, parsed from the text on request. */
public final class StartTag {
  private final List<SourceAttribute> attributes = new ArrayList<>(4);
  private final int end;

  private StartTag(CharSequence text, int start, EntityTable entities) {
    if (start < text.length() && text.charAt(start) == '&') {
      end = start; // a reference to an entity, which has none
      return;
    }
    int limit = text.length();
    int at = skipName(text, start + 1, limit);
    int last = at;
    while (true) {
      int from = skipSpace(text, at, limit);
      at = skipName(text, from, limit);
      int equals = skipSpace(text, at, limit);
      int quote = skipSpace(text, equals + 1, limit);
      if (at == from || quote >= limit || text.charAt(equals) != '=') {
        end = last;
        return;
      }
      int to = quote + 1;
      while (to < limit && text.charAt(to) != text.charAt(quote)) {
        to++;
      }
      String name = text.subSequence(from, at).toString();
      attributes.add(new SourceAttribute(text, name, from, quote + 1, to, entities));
      at = Math.min(to + 1, limit);
      last = at;
    }
  }

  /**
   * Parses a tag, of which a malformed rest is ignored.
   *
   * @param start the offset of its {@code <}
   * @param entities the entities for references in values
   */
  static StartTag of(CharSequence text, int start, EntityTable entities) {
    return new StartTag(text, start, entities);
  }

  private static int skipName(CharSequence text, int from, int limit) {
    int at = from;
    while (at < limit && text.charAt(at) > ' ' && "=/><\"'".indexOf(text.charAt(at)) < 0) {
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

  /** Returns the attributes in the order of the text. */
  public List<SourceAttribute> attributes() {
    return attributes;
  }

  /** Returns the attribute of an index, not counting namespace declarations, or null. */
  @Nullable SourceAttribute at(int index) {
    int left = index;
    for (SourceAttribute attribute : attributes) {
      if (!attribute.declaration() && left-- == 0) {
        return attribute;
      }
    }
    return null;
  }

  /** Returns the attribute with a name, if there is one. */
  public Optional<SourceAttribute> attribute(String name) {
    for (SourceAttribute attribute : attributes) {
      if (attribute.name().equals(name)) {
        return Optional.of(attribute);
      }
    }
    return Optional.empty();
  }

  /** Returns the offset after the last attribute, or the name, at which to insert another. */
  public int end() {
    return end;
  }
}

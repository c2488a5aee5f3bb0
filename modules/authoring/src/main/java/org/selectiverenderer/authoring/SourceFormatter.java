package org.selectiverenderer.authoring;

import java.util.List;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.StartTag;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.write.XmlAttributeEscaper;

/**
 * Formats added elements and attributes in the style of the document: indentation, line ends,
 * quotes.
 */
public final class SourceFormatter {
  private static final int LOOKED_AT = 4096;

  private final CharSequence text;

  SourceFormatter(CharSequence text) {
    this.text = text;
  }

  /** Returns whether only white space precedes an element on its line. */
  public boolean onItsOwnLine(DocumentElement element) {
    return indentEnd(element.start()) == element.start();
  }

  /** Returns the indentation of an element's line. */
  public String indentation(DocumentElement element) {
    int from = lineStart(element.start());
    return text.subSequence(from, indentEnd(element.start())).toString();
  }

  private int indentEnd(int offset) {
    int at = lineStart(offset);
    while (at < offset && (text.charAt(at) == ' ' || text.charAt(at) == '\t')) {
      at++;
    }
    return at;
  }

  private int lineStart(int offset) {
    int at = offset;
    while (at > 0 && text.charAt(at - 1) != '\n' && text.charAt(at - 1) != '\r') {
      at--;
    }
    return at;
  }

  /** Returns one step of indentation, as between an element and its parent. */
  public String step(DocumentElement element) {
    String own = indentation(element);
    for (DocumentElement at = element; at.parent().isPresent(); at = at.parent().get()) {
      String inner = indentation(at);
      String outer = indentation(at.parent().get());
      if (onItsOwnLine(at) && inner.length() > outer.length() && inner.startsWith(outer)) {
        return inner.substring(outer.length());
      }
    }
    return own.contains("\t") ? "\t" : "  ";
  }

  /** Returns the line end that is used near an element. */
  public String endOfLine(DocumentElement near) {
    for (int i = near.start(); i > 0; i--) {
      char c = text.charAt(i - 1);
      if (c == '\n') {
        return i > 1 && text.charAt(i - 2) == '\r' ? "\r\n" : "\n";
      }
      if (c == '\r') {
        return "\r";
      }
    }
    for (int i = near.start(); i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '\r') {
        return i + 1 < text.length() && text.charAt(i + 1) == '\n' ? "\r\n" : "\r";
      }
      if (c == '\n') {
        return "\n";
      }
    }
    return "\n";
  }

  /**
   * Returns the quote character that an element's tag, or else its parent's, uses for attribute
   * values.
   */
  public char quote(DocumentElement near) {
    for (DocumentElement at = near; ; at = at.parent().get()) {
      int end = Math.min(at.tagEnd(), at.start() + LOOKED_AT);
      for (int i = at.start(); i < end; i++) {
        char c = text.charAt(i);
        if (c == '"' || c == '\'') {
          return c;
        }
      }
      if (at.parent().isEmpty()) {
        return '\'';
      }
    }
  }

  /**
   * Inserts an element before all children of another element.
   *
   * @param lines the element's lines, indented relative to the first
   */
  public TextEdit insertFirst(DocumentElement into, List<String> lines) {
    if (into.children().isEmpty()) {
      return insertInto(into, into.tagEnd(), lines);
    }
    return insertBefore(into.children().get(0), lines);
  }

  /** Inserts an element after all children of another element. */
  public TextEdit insertLast(DocumentElement into, List<String> lines) {
    List<DocumentElement> children = into.children();
    return children.isEmpty()
        ? insertInto(into, into.tagEnd(), lines)
        : insertAfter(children.get(children.size() - 1), lines);
  }

  /** Inserts an element before another one. */
  public TextEdit insertBefore(DocumentElement element, List<String> lines) {
    if (!onItsOwnLine(element)) {
      return TextEdit.insert(element.start(), LineJoiner.join(lines));
    }
    String separator = endOfLine(element) + indentation(element);
    return TextEdit.insert(element.start(), String.join(separator, lines) + separator);
  }

  /** Inserts an element after another one. */
  public TextEdit insertAfter(DocumentElement element, List<String> lines) {
    if (!onItsOwnLine(element)) {
      return TextEdit.insert(element.end(), LineJoiner.join(lines));
    }
    String separator = endOfLine(element) + indentation(element);
    return TextEdit.insert(element.end(), separator + String.join(separator, lines));
  }

  /** Replaces an element by other lines. */
  public TextEdit replace(DocumentElement element, List<String> lines) {
    String separator = endOfLine(element) + indentation(element);
    return new TextEdit(
        element.start(),
        element.end(),
        onItsOwnLine(element) ? String.join(separator, lines) : LineJoiner.join(lines));
  }

  private TextEdit insertInto(DocumentElement into, int at, List<String> lines) {
    String outer = endOfLine(into) + indentation(into);
    String inner = outer + step(into);
    boolean laid = onItsOwnLine(into);
    String body = laid ? inner + String.join(inner, lines) : LineJoiner.join(lines);
    if (!into.open()) {
      int tagStart = into.tag().end();
      String close = (laid ? outer : "") + "</" + written(into);
      // The last ">" stays, so that the change is inside the element, which keeps its identity.
      return new TextEdit(tagStart, into.end() - 1, ">" + body + close);
    }
    int endTag = endTag(into);
    boolean blank = text.subSequence(at, endTag).toString().isBlank();
    return blank ? new TextEdit(at, endTag, body + (laid ? outer : "")) : TextEdit.insert(at, body);
  }

  private int endTag(DocumentElement element) {
    int at = element.end() - 1;
    while (text.charAt(at) != '<') {
      at--;
    }
    return at;
  }

  private String written(DocumentElement element) {
    int end = element.start() + 1;
    while (text.charAt(end) > ' ' && "/>".indexOf(text.charAt(end)) < 0) {
      end++;
    }
    return text.subSequence(element.start() + 1, end).toString();
  }

  /** Removes an element, together with its line if the line contains nothing else. */
  public TextEdit remove(DocumentElement element) {
    int after = element.end();
    while (after < text.length() && (text.charAt(after) == ' ' || text.charAt(after) == '\t')) {
      after++;
    }
    boolean last =
        after == text.length() || text.charAt(after) == '\r' || text.charAt(after) == '\n';
    if (!onItsOwnLine(element) || !last) {
      return TextEdit.remove(element.start(), element.end());
    }
    // Removes the previous line's end, so that the document's last line end stays.
    int cut = lineStart(element.start());
    if (cut > 0 && text.charAt(cut - 1) == '\n') {
      cut--;
    }
    if (cut > 0 && text.charAt(cut - 1) == '\r') {
      cut--;
    }
    return TextEdit.remove(cut, after);
  }

  /**
   * Sets the value of an attribute, which is added if it is missing.
   *
   * @throws EditRejectedException if the value or the element comes from an entity
   */
  public TextEdit attribute(DocumentElement element, String name, String value) {
    StartTag tag = element.tag();
    boolean entity = tag.attribute(name).filter(SourceAttribute::fromEntity).isPresent();
    if (entity || element.isReference()) {
      throw new EditRejectedException(
          (entity ? "The value of " + name + " of " : "")
              + element
              + " comes from an entity of the DOCTYPE, which may be used in several places; "
              + "change it in the source");
    }
    return tag.attribute(name)
        .map(
            old ->
                new TextEdit(
                    old.valueFrom(),
                    old.valueTo(),
                    XmlAttributeEscaper.escaped(value, text.charAt(old.valueTo()))))
        .orElseGet(() -> TextEdit.insert(tag.end(), written(name, value, quote(element))));
  }

  /** Returns the source text of an attribute, with a leading space. */
  public static String written(String name, String value, char quote) {
    char used = value.indexOf(quote) >= 0 && value.indexOf(other(quote)) < 0 ? other(quote) : quote;
    return " " + name + "=" + used + XmlAttributeEscaper.escaped(value, used) + used;
  }

  private static char other(char quote) {
    return quote == '"' ? '\'' : '"';
  }
}

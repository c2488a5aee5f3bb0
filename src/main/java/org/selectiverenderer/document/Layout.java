package org.selectiverenderer.document;

import java.util.List;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.StartTag;
import org.selectiverenderer.x3d.source.TextChange;
import org.selectiverenderer.x3d.source.WrittenAttribute;
import org.selectiverenderer.x3d.write.XmlAttribute;

/** Lays out what is added to a document as its author does: indentation, ends of lines, quotes. */
public final class Layout {
  private static final int LOOKED_AT = 4096;

  private final CharSequence text;

  Layout(CharSequence text) {
    this.text = text;
  }

  /** Whether nothing but white space stands before an element on its line. */
  public boolean onItsOwnLine(DocumentElement element) {
    return indentEnd(element.start()) == element.start();
  }

  /** The white space before an element's line. */
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

  /** One step of indentation, as between an element and what it stands in. */
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

  /** What ends a line, as near an element. */
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

  /** The quote that an element's tag, or else the one around it, puts values in. */
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
   * Puts an element's lines in front of all in another element.
   *
   * @param lines indented against each other, but not as a whole
   */
  public TextChange insertFirst(DocumentElement into, List<String> lines) {
    if (into.children().isEmpty()) {
      return insertInto(into, into.tagEnd(), lines);
    }
    DocumentElement first = into.children().get(0);
    if (!onItsOwnLine(first)) {
      return TextChange.insert(first.start(), String.join("", stripped(lines)));
    }
    String separator = endOfLine(first) + indentation(first);
    return TextChange.insert(first.start(), String.join(separator, lines) + separator);
  }

  /** Puts an element's lines behind all elements in another one. */
  public TextChange insertLast(DocumentElement into, List<String> lines) {
    List<DocumentElement> children = into.children();
    return children.isEmpty()
        ? insertInto(into, into.tagEnd(), lines)
        : insertAfter(children.get(children.size() - 1), lines);
  }

  /** Puts an element's lines behind an element. */
  public TextChange insertAfter(DocumentElement element, List<String> lines) {
    if (!onItsOwnLine(element)) {
      return TextChange.insert(element.end(), String.join("", stripped(lines)));
    }
    String separator = endOfLine(element) + indentation(element);
    return TextChange.insert(element.end(), separator + String.join(separator, lines));
  }

  /** Puts an element's lines in its place. */
  public TextChange replace(DocumentElement element, List<String> lines) {
    String separator = endOfLine(element) + indentation(element);
    return new TextChange(
        element.start(),
        element.end(),
        onItsOwnLine(element) ? String.join(separator, lines) : String.join("", stripped(lines)));
  }

  private TextChange insertInto(DocumentElement into, int at, List<String> lines) {
    String outer = endOfLine(into) + indentation(into);
    String inner = outer + step(into);
    boolean laid = onItsOwnLine(into);
    String body = laid ? inner + String.join(inner, lines) : String.join("", stripped(lines));
    if (!into.open()) {
      int tagStart = into.tag().end();
      String close = (laid ? outer : "") + "</" + written(into);
      // The last ">" stays, so that the change is within the element, which stays the same then.
      return new TextChange(tagStart, into.end() - 1, ">" + body + close);
    }
    int endTag = endTag(into);
    boolean blank = text.subSequence(at, endTag).toString().isBlank();
    return blank
        ? new TextChange(at, endTag, body + (laid ? outer : ""))
        : TextChange.insert(at, body);
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

  private static List<String> stripped(List<String> lines) {
    return lines.stream().map(String::strip).toList();
  }

  /** Takes an element out, with the line that it stands on if nothing else does. */
  public TextChange remove(DocumentElement element) {
    int after = element.end();
    while (after < text.length() && (text.charAt(after) == ' ' || text.charAt(after) == '\t')) {
      after++;
    }
    boolean last =
        after == text.length() || text.charAt(after) == '\r' || text.charAt(after) == '\n';
    if (!onItsOwnLine(element) || !last) {
      return TextChange.remove(element.start(), element.end());
    }
    // The end of the line before goes, so that the end of the last line stays.
    int cut = lineStart(element.start());
    if (cut > 0 && text.charAt(cut - 1) == '\n') {
      cut--;
    }
    if (cut > 0 && text.charAt(cut - 1) == '\r') {
      cut--;
    }
    return TextChange.remove(cut, after);
  }

  /**
   * Gives an attribute another value, or the element the attribute.
   *
   * @throws EditRefused if the value comes out of an entity, or the element does
   */
  public TextChange attribute(DocumentElement element, String name, String value) {
    StartTag tag = element.tag();
    boolean entity = tag.attribute(name).filter(WrittenAttribute::fromEntity).isPresent();
    if (entity || element.isReference()) {
      throw new EditRefused(
          (entity ? "The value of " + name + " of " : "")
              + element
              + " comes out of an entity of the DOCTYPE, which may stand in several places; "
              + "change it in the source");
    }
    return tag.attribute(name)
        .map(
            old ->
                new TextChange(
                    old.valueFrom(),
                    old.valueTo(),
                    XmlAttribute.escaped(value, text.charAt(old.valueTo()))))
        .orElseGet(() -> TextChange.insert(tag.end(), written(name, value, quote(element))));
  }

  /** An attribute as it is written, with the space before it. */
  public static String written(String name, String value, char quote) {
    char used = value.indexOf(quote) >= 0 && value.indexOf(other(quote)) < 0 ? other(quote) : quote;
    return " " + name + "=" + used + XmlAttribute.escaped(value, used) + used;
  }

  private static char other(char quote) {
    return quote == '"' ? '\'' : '"';
  }
}

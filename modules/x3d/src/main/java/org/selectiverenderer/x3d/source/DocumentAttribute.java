package org.selectiverenderer.x3d.source;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * An attribute of a document element. Long numeric attributes are stored as parsed values only.
 * Values may be read by several threads at a time, as for a shared prototype.
 */
public final class DocumentAttribute {
  private final DocumentElement element;
  private final int index;
  private final String name;
  private final @Nullable String text;
  private @Nullable Known known;
  private boolean told;

  /** A parsed value, in one immutable object, for publication to other threads. */
  private record Known(FieldType type, @Nullable Object value, List<FieldParser.Flaw> flaws) {}

  /**
   * Creates an attribute.
   *
   * @param index the index among the attributes of the element, as the parser counts
   * @param name the local name; empty for an attribute of a foreign namespace
   * @param text the text with references resolved; null for a value that is stored parsed
   */
  public DocumentAttribute(DocumentElement element, int index, String name, @Nullable String text) {
    this.element = element;
    this.index = index;
    this.name = name;
    this.text = text;
  }

  void keep(FieldType parsedAs, @Nullable Object parsed, List<FieldParser.Flaw> found) {
    known = new Known(parsedAs, parsed, found);
  }

  /** Returns the element of the attribute. */
  public DocumentElement element() {
    return element;
  }

  /** Returns the local name; empty for an attribute of a foreign namespace. */
  public String name() {
    return name;
  }

  /** Returns whether the value as a field of a type has already been parsed. */
  public boolean known(FieldType wanted) {
    Known now = known;
    return now != null && now.type == wanted;
  }

  /** Returns the text with references resolved; for a long numeric value with its line ends. */
  public String text() {
    if (text != null) {
      return text;
    }
    String written = element.place().attributeText(index);
    return written.indexOf('&') < 0 ? written : element.place().attributeLines(index);
  }

  /**
   * Returns the text with its line ends, which XML normalizes to blanks but which end comments of
   * programs.
   */
  public String lines() {
    String now = text();
    String lines = element.place().attributeLines(index);
    // In other encodings the text of the file has escapes, and the value has its lines already.
    boolean same = lines.replace('\n', ' ').equals(now.replace('\n', ' '));
    return same ? lines : now;
  }

  /** Returns the value as a field of a type; null if nothing of the text is usable. */
  public @Nullable Object value(FieldType wanted) {
    return as(wanted).value;
  }

  /** Returns the errors in the text as a value of a type. */
  public List<FieldParser.Flaw> flaws(FieldType wanted) {
    return as(wanted).flaws;
  }

  private Known as(FieldType wanted) {
    Known now = known;
    if (now == null || now.type != wanted) {
      String written = text();
      synchronized (element.source()) { // the parser is not thread-safe
        FieldParser.Parsed parsed = element.source().parser().parse(wanted, written);
        now = new Known(wanted, parsed.value(), parsed.flaws());
      }
      known = now;
    }
    return now;
  }

  /** Returns the errors for reporting; empty if they have been returned before. */
  public List<FieldParser.Flaw> untold(FieldType wanted) {
    Known now = known;
    boolean before = told && now != null && now.type == wanted;
    told = true;
    return before ? List.of() : flaws(wanted);
  }

  /** Returns the location of the name. */
  public SourceLocation location() {
    return element.place().attribute(index);
  }

  /**
   * Returns the location of a character of the value.
   *
   * @param offset the offset from 0, as in a {@link FieldParser.Flaw}
   */
  public SourceLocation location(int offset) {
    int leading = text == null ? 0 : FieldTokenizer.leading(text);
    return element.place().inAttribute(index, offset - leading);
  }
}

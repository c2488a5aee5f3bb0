package org.selectiverenderer.x3d.source;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.field.Tokens;

/**
 * An attribute of a document. Long numeric values are kept as values only. Several threads may ask
 * for values at a time, as those do that use one prototype.
 */
public final class DocumentAttribute {
  private final DocumentElement element;
  private final int index;
  private final String name;
  private final @Nullable String text;
  private @Nullable Known known;
  private boolean told;

  /** A value, in one object, so that other threads see all of it or nothing. */
  private record Known(FieldType type, @Nullable Object value, List<FieldParser.Flaw> flaws) {}

  /**
   * @param index among the attributes of the element, as the parser counts
   * @param name without prefix; empty when it belongs to another language's namespace
   * @param text references replaced; null for a value that is kept as such
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

  /** The element that it stands in. */
  public DocumentElement element() {
    return element;
  }

  /** The name; empty when it belongs to another language's namespace. */
  public String name() {
    return name;
  }

  /** Whether its value as a field of that type is known already. */
  public boolean known(FieldType wanted) {
    Known now = known;
    return now != null && now.type == wanted;
  }

  /** The text, references replaced; of a long numeric value as it stands in the file. */
  public String text() {
    return text != null ? text : element.place().attributeText(index);
  }

  /** The value that the text means as a field of a type; null when nothing of it can be used. */
  public @Nullable Object value(FieldType wanted) {
    return as(wanted).value;
  }

  /** What is wrong with the text as a value of that type. */
  public List<FieldParser.Flaw> flaws(FieldType wanted) {
    return as(wanted).flaws;
  }

  private Known as(FieldType wanted) {
    Known now = known;
    if (now == null || now.type != wanted) {
      String written = text();
      synchronized (element.source()) { // Its parser serves one thread.
        FieldParser.Parsed parsed = element.source().parser().parse(wanted, written);
        now = new Known(wanted, parsed.value(), parsed.flaws());
      }
      known = now;
    }
    return now;
  }

  /** The same for who tells it: nothing the next time. */
  public List<FieldParser.Flaw> untold(FieldType wanted) {
    Known now = known;
    boolean before = told && now != null && now.type == wanted;
    told = true;
    return before ? List.of() : flaws(wanted);
  }

  /** Where the name stands. */
  public Location location() {
    return element.place().attribute(index);
  }

  /**
   * Where a character of the value stands.
   *
   * @param offset from 0, as a {@link FieldParser.Flaw} counts
   */
  public Location location(int offset) {
    int leading = text == null ? 0 : Tokens.leading(text);
    return element.place().inAttribute(index, offset - leading);
  }
}

package org.selectiverenderer.x3d.source;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.field.Tokens;

/**
 * An attribute of a document. Long numeric values are kept as values only. Serves one thread, as
 * its document does.
 */
public final class DocumentAttribute {
  private final DocumentElement element;
  private final int index;
  private final String name;
  private final @Nullable String text;
  private @Nullable FieldType type;
  private @Nullable Object value;
  private List<FieldParser.Flaw> flaws = List.of();
  private boolean told;

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
    type = parsedAs;
    value = parsed;
    flaws = found;
  }

  public DocumentElement element() {
    return element;
  }

  /** The name; empty when it belongs to another language's namespace. */
  public String name() {
    return name;
  }

  /** Whether its value as a field of that type is known already. */
  public boolean known(FieldType wanted) {
    return type == wanted;
  }

  /** The text, references replaced; of a long numeric value as it stands in the file. */
  public String text() {
    return text != null ? text : element.place().attributeText(index);
  }

  /** The value that the text means as a field of a type; null when nothing of it can be used. */
  public @Nullable Object value(FieldType wanted) {
    if (type != wanted) {
      FieldParser.Parsed parsed = element.source().parser().parse(wanted, text());
      keep(wanted, parsed.value(), parsed.flaws());
    }
    return value;
  }

  /** What is wrong with the text as a value of that type. */
  public List<FieldParser.Flaw> flaws(FieldType wanted) {
    value(wanted);
    return flaws;
  }

  /** The same for who tells it: nothing the next time. */
  public List<FieldParser.Flaw> untold(FieldType wanted) {
    boolean before = told && type == wanted;
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

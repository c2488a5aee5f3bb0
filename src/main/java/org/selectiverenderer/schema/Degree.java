package org.selectiverenderer.schema;

import java.util.Locale;
import java.util.Optional;

/**
 * How consistent an object is with a schema, from 0 to 1. The thesis knows two levels, and foresees
 * more (7.2): {@code low} is 0, {@code high} is 1, and a number between them is one of the further
 * levels. The higher the degree, the fewer polygons the object is drawn with.
 *
 * @param value from 0 to 1
 */
public record Degree(double value) implements Comparable<Degree> {
  /** Hardly expected: all polygons. */
  public static final Degree LOW = new Degree(0);

  /** Fully expected: the fewest polygons. */
  public static final Degree HIGH = new Degree(1);

  /** Refuses what is not from 0 to 1. */
  public Degree {
    if (!(value >= 0 && value <= 1)) {
      throw new IllegalArgumentException(
          "a degree of consistency must be from 0 to 1, not " + value);
    }
    value += 0.0; // -0 is 0
  }

  /** The degree of {@code low}, {@code high} or a number from 0 to 1, with spaces around it. */
  public static Optional<Degree> of(String text) {
    String word = text.strip().toLowerCase(Locale.ROOT);
    if (word.equals("low")) {
      return Optional.of(LOW);
    }
    if (word.equals("high")) {
      return Optional.of(HIGH);
    }
    try {
      return Optional.of(new Degree(Double.parseDouble(word)));
    } catch (IllegalArgumentException e) {
      return Optional.empty(); // no number, or none from 0 to 1
    }
  }

  /** The text in the metadata. */
  public String spelling() {
    return equals(LOW) ? "low" : equals(HIGH) ? "high" : Double.toString(value);
  }

  @Override
  public int compareTo(Degree other) {
    return Double.compare(value, other.value);
  }
}

package org.selectiverenderer.schema;

import java.util.Locale;
import java.util.Optional;

/**
 * The degree of consistency of an object with a schema, from 0 to 1. The thesis has two levels,
 * {@code low} (0) and {@code high} (1), and proposes more (7.2), which are numbers between them.
 * The higher the degree, the fewer polygons the object is drawn with.
 *
 * @param value from 0 to 1
 */
public record ConsistencyDegree(double value) implements Comparable<ConsistencyDegree> {
  /** The degree of a hardly expected object, drawn with all polygons. */
  public static final ConsistencyDegree LOW = new ConsistencyDegree(0);

  /** The degree of a fully expected object, drawn with the fewest polygons. */
  public static final ConsistencyDegree HIGH = new ConsistencyDegree(1);

  /** Checks that the value is from 0 to 1. */
  public ConsistencyDegree {
    if (!(value >= 0 && value <= 1)) {
      throw new IllegalArgumentException(
          "a degree of consistency must be from 0 to 1, not " + value);
    }
    value += 0.0; // -0 is 0
  }

  /** Parses {@code low}, {@code high} or a number from 0 to 1, with optional spaces around it. */
  public static Optional<ConsistencyDegree> of(String text) {
    String word = text.strip().toLowerCase(Locale.ROOT);
    if (word.equals("low")) {
      return Optional.of(LOW);
    }
    if (word.equals("high")) {
      return Optional.of(HIGH);
    }
    try {
      return Optional.of(new ConsistencyDegree(Double.parseDouble(word)));
    } catch (IllegalArgumentException e) {
      return Optional.empty(); // not a number from 0 to 1
    }
  }

  /** Returns the text for the degree in the metadata. */
  public String spelling() {
    return equals(LOW) ? "low" : equals(HIGH) ? "high" : Double.toString(value);
  }

  @Override
  public int compareTo(ConsistencyDegree other) {
    return Double.compare(value, other.value);
  }
}

package org.selectiverenderer.x3d.field;

import ch.randelshofer.fastdoubleparser.JavaDoubleParser;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;

/**
 * Parses the text of a field (X3D 4.0 XML encoding, ISO/IEC 19776-1, clause 5) to the value that
 * {@link FieldType} describes. Errors are returned beside the value, of which the usable part is
 * kept. Reuses buffers between calls; not thread-safe.
 */
public final class FieldParser {
  /**
   * An error in the text of a value.
   *
   * @param offset the offset of the offending word in the text, from 0
   * @param message a sentence that says what is wrong and what the program does about it
   */
  public record Flaw(int offset, Problem.Severity severity, String message) {}

  /**
   * A value and the errors in its text.
   *
   * @param value the value as {@link FieldType} represents it; null if nothing of the text is
   *     usable
   */
  public record Parsed(@Nullable Object value, List<Flaw> flaws) {}

  private final FloatScanner floats = new FloatScanner();
  private final DoubleScanner doubles = new DoubleScanner();
  private final IntScanner ints = new IntScanner();

  /**
   * Parses a value.
   *
   * @throws IllegalArgumentException for SFNode and MFNode, which text cannot express
   */
  public Parsed parse(FieldType type, String text) {
    FieldParseErrors flaws = new FieldParseErrors();
    Object value = parse(type, text, flaws);
    return new Parsed(value, flaws.list());
  }

  /**
   * Parses a value to its representation by {@link FieldType}, or null; errors go to {@code flaws}.
   */
  @Nullable
  public Object parse(FieldType type, String text, FieldParseErrors flaws) {
    if (type.kind() == FieldType.Kind.STRING) {
      return type.multiple() ? StringScanner.strings(text, flaws) : text;
    }
    return parse(type, text.toCharArray(), 0, text.length(), flaws);
  }

  /** Parses a value, not of strings, in a part of a buffer; offsets count from {@code start}. */
  @Nullable
  public Object parse(FieldType type, char[] text, int start, int end, FieldParseErrors flaws) {
    return switch (type.kind()) {
      case FLOAT -> {
        int length = tuples(type, floats.scan(text, start, end, flaws), text, start, end, flaws);
        yield type.multiple()
            ? floats.copy(length)
            : length == 0 ? null : length == 1 ? (Object) floats.first() : floats.copy(length);
      }
      case DOUBLE -> {
        int length = tuples(type, doubles.scan(text, start, end, flaws), text, start, end, flaws);
        yield type.multiple()
            ? doubles.copy(length)
            : length == 0 ? null : length == 1 ? (Object) doubles.first() : doubles.copy(length);
      }
      case INT -> {
        int found = ints.scan(text, start, end, flaws);
        if (type.components() == 0) {
          yield ImageValidator.check(ints.copy(found), type.multiple(), flaws);
        }
        int length = tuples(type, found, text, start, end, flaws);
        yield type.multiple() ? ints.copy(length) : length == 0 ? null : (Object) ints.first();
      }
      case BOOLEAN -> booleans(type, text, start, end, flaws);
      case STRING -> throw new IllegalArgumentException("strings are not read from a buffer");
      case NODE -> throw new IllegalArgumentException(type + " has no text form");
    };
  }

  /** Returns how many of the numbers form complete tuples, or the one tuple of a single value. */
  private static int tuples(
      FieldType type, int found, char[] text, int start, int end, FieldParseErrors flaws) {
    int size = type.components();
    if (type.multiple()) {
      int over = found % size;
      if (over != 0) {
        flaws.error(
            FieldTokenizer.offset(text, start, end, found - over),
            "the last value has only "
                + over
                + " of its "
                + size
                + (over == 1 ? " numbers; it is left out" : " numbers; they are left out"));
      }
      return found - over;
    }
    if (found > size) {
      flaws.error(
          FieldTokenizer.offset(text, start, end, size),
          size == 1
              ? "only one number is needed here; the rest is left out"
              : size + " numbers are needed here; the rest is left out");
      return size;
    }
    if (found < size) {
      flaws.unusable(
          size == 1
              ? "a number is missing; the default is used"
              : size + " numbers are needed, not " + found + "; the default is used");
      return 0;
    }
    return size;
  }

  private static @Nullable Object booleans(
      FieldType type, char[] text, int start, int end, FieldParseErrors flaws) {
    int count = FieldTokenizer.count(text, start, end);
    if (!type.multiple() && count != 1) {
      flaws.error(0, "either true or false is needed here; the default is used");
      return null;
    }
    boolean[] values = new boolean[count];
    int at = start;
    for (int i = 0; i < count; i++) {
      at = FieldTokenizer.skipSeparators(text, at, end);
      int stop = FieldTokenizer.skipWord(text, at, end);
      String word = new String(text, at, stop - at);
      values[i] = word.equalsIgnoreCase("true");
      if (!word.equals("true") && !word.equals("false")) {
        if (values[i] || word.equalsIgnoreCase("false")) {
          flaws.warning(at - start, "'" + word + "' must be written in lower case in X3D");
        } else if (type.multiple()) {
          flaws.error(
              at - start, FieldTokenizer.quote(word) + " is neither true nor false; false is used");
        } else {
          flaws.error(
              at - start,
              FieldTokenizer.quote(word) + " is neither true nor false; the default is used");
          return null;
        }
      }
      at = stop;
    }
    return type.multiple() ? values : (Object) values[0];
  }

  /** Reads doubles, correctly rounded; not optimized, since they are rare in scenes. */
  private static final class DoubleScanner extends NumberScanner {
    private double[] values;

    DoubleScanner() {
      super(16);
      values = new double[16];
    }

    double first() {
      return values[0];
    }

    double[] copy(int length) {
      return Arrays.copyOf(values, length);
    }

    @Override
    void grow(int wanted) {
      values = Arrays.copyOf(values, wanted);
    }

    @Override
    int number(char[] text, int start, int word, int end, int index, FieldParseErrors flaws) {
      int stop = FieldTokenizer.skipWord(text, word, end);
      double value = Double.NaN;
      if (DecimalParser.wellFormed(text, word, stop)) {
        value = JavaDoubleParser.parseDouble(text, word, stop - word);
      }
      if (!Double.isFinite(value)) {
        flaws.error(word - start, DecimalParser.complaint(text, word, stop));
        value = 0;
      }
      values[index] = value;
      return stop;
    }
  }
}

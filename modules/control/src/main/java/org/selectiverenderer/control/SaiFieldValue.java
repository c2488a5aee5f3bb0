package org.selectiverenderer.control;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.web3d.x3d.sai.MFDouble;
import org.web3d.x3d.sai.MFFloat;
import org.web3d.x3d.sai.MFInt32;
import org.web3d.x3d.sai.MFString;
import org.web3d.x3d.sai.MField;
import org.web3d.x3d.sai.SFBool;
import org.web3d.x3d.sai.SFColor;
import org.web3d.x3d.sai.SFDouble;
import org.web3d.x3d.sai.SFFloat;
import org.web3d.x3d.sai.SFInt32;
import org.web3d.x3d.sai.SFString;
import org.web3d.x3d.sai.SFTime;
import org.web3d.x3d.sai.X3DField;

/** A value that can be written into one field, and compared with what the field has. */
final class SaiFieldValue {
  private final Runnable writer;
  private final BooleanSupplier comparison;

  private SaiFieldValue(Runnable writer, BooleanSupplier comparison) {
    this.writer = writer;
    this.comparison = comparison;
  }

  /** Returns whether a field is of a type that has values here. */
  static boolean supports(X3DField field) {
    return field instanceof SFBool
        || field instanceof SFString
        || field instanceof MFString
        || numbers(field).isPresent();
  }

  /**
   * Reads the value of a level.
   *
   * @param strings the strings of an MFString; of other types the value in the XML encoding's
   *     syntax, in one string or several
   * @return empty if the text is no value of the field's type
   */
  static Optional<SaiFieldValue> of(X3DField field, List<String> strings) {
    String text = String.join(" ", strings).strip();
    if (field instanceof SFBool truth) {
      boolean value = text.equals("true");
      return value || text.equals("false")
          ? Optional.of(
              new SaiFieldValue(() -> truth.setValue(value), () -> truth.getValue() == value))
          : Optional.empty();
    }
    if (field instanceof SFString string) {
      String value = String.join(" ", strings);
      return Optional.of(
          new SaiFieldValue(() -> string.setValue(value), () -> value.equals(string.getValue())));
    }
    if (field instanceof MFString texts) {
      String[] values = strings.toArray(String[]::new);
      return Optional.of(
          new SaiFieldValue(
              () -> texts.setValue(values.length, values.clone()),
              () -> Arrays.equals(strings(texts), values)));
    }
    Optional<NumberField> target = numbers(field);
    try {
      double[] values =
          text.isEmpty()
              ? new double[0]
              : Arrays.stream(text.split("[\\s,]+")).mapToDouble(Double::parseDouble).toArray();
      return target.filter(known -> known.accepts(values)).map(known -> known.valued(values));
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  /** Writes the value into the field. */
  void write() {
    writer.run();
  }

  /** Returns whether the field has the value. */
  boolean isThere() {
    return comparison.getAsBoolean();
  }

  private static String[] strings(MFString field) {
    String[] strings = new String[field.getSize()];
    field.getValue(strings);
    return strings;
  }

  private static Optional<NumberField> numbers(X3DField field) {
    if (field instanceof SFInt32 target) {
      return Optional.of(
          new NumberField(
              1, true, () -> new double[] {target.getValue()}, v -> target.setValue((int) v[0])));
    }
    if (field instanceof SFFloat target) {
      return Optional.of(
          new NumberField(
              1,
              false,
              () -> new double[] {target.getValue()},
              v -> target.setValue((float) v[0])));
    }
    if (field instanceof SFDouble target) {
      return Optional.of(
          new NumberField(
              1, false, () -> new double[] {target.getValue()}, v -> target.setValue(v[0])));
    }
    if (field instanceof SFTime target) {
      return Optional.of(
          new NumberField(
              1, false, () -> new double[] {target.getValue()}, v -> target.setValue(v[0])));
    }
    if (field instanceof SFColor target) {
      return Optional.of(
          new NumberField(
              3,
              false,
              () -> {
                float[] colour = new float[3];
                target.getValue(colour);
                return doubles(colour);
              },
              v -> target.setValue(floats(v))));
    }
    return field instanceof MField list ? list(list) : Optional.empty();
  }

  private static Optional<NumberField> list(MField field) {
    if (field instanceof MFFloat target) {
      return Optional.of(
          new NumberField(
              -1,
              false,
              () -> {
                float[] values = new float[target.getSize()];
                target.getValue(values);
                return doubles(values);
              },
              v -> target.setValue(v.length, floats(v))));
    }
    if (field instanceof MFDouble target) {
      return Optional.of(
          new NumberField(
              -1,
              false,
              () -> {
                double[] values = new double[target.getSize()];
                target.getValue(values);
                return values;
              },
              v -> target.setValue(v.length, v)));
    }
    if (field instanceof MFInt32 target) {
      return Optional.of(
          new NumberField(
              -1,
              true,
              () -> {
                int[] values = new int[target.getSize()];
                target.getValue(values);
                return Arrays.stream(values).asDoubleStream().toArray();
              },
              v -> target.setValue(v.length, Arrays.stream(v).mapToInt(n -> (int) n).toArray())));
    }
    return Optional.empty();
  }

  private static float[] floats(double[] values) {
    float[] floats = new float[values.length];
    for (int i = 0; i < values.length; i++) {
      floats[i] = (float) values[i];
    }
    return floats;
  }

  private static double[] doubles(float[] values) {
    double[] doubles = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      doubles[i] = values[i];
    }
    return doubles;
  }

  /**
   * Access to a field of numbers.
   *
   * @param count how many numbers it has; -1 for any number
   * @param whole whether they are integers
   */
  private record NumberField(
      int count, boolean whole, Supplier<double[]> reader, Consumer<double[]> writer) {
    boolean accepts(double[] values) {
      return (count < 0 || values.length == count)
          && Arrays.stream(values).allMatch(Double::isFinite)
          && (!whole || Arrays.stream(values).allMatch(value -> value == (int) value));
    }

    SaiFieldValue valued(double[] values) {
      return new SaiFieldValue(
          () -> writer.accept(values.clone()), () -> equal(reader.get(), values));
    }

    /** Returns whether numbers are the same, to the precision of floats. */
    private static boolean equal(double[] there, double[] wanted) {
      boolean same = there.length == wanted.length;
      for (int i = 0; same && i < wanted.length; i++) {
        same = (float) there[i] == (float) wanted[i];
      }
      return same;
    }
  }
}

package org.selectiverenderer.bench;

/** Appends numbers with a fixed number of decimals: many times faster than a format string. */
final class FixedPointText {

  private final StringBuilder text;

  FixedPointText(int capacity) {
    text = new StringBuilder(capacity);
  }

  FixedPointText append(String literal) {
    text.append(literal);
    return this;
  }

  FixedPointText append(int value) {
    text.append(value).append(' ');
    return this;
  }

  /**
   * Rounds half up and appends the number and a blank.
   *
   * @param decimals 1 to 9
   */
  FixedPointText append(double value, int decimals) {
    long unit = 1;
    for (int i = 0; i < decimals; i++) {
      unit *= 10;
    }
    long scaled = Math.round(Math.abs(value) * unit);
    if (value < 0 && scaled != 0) {
      text.append('-');
    }
    text.append(scaled / unit).append('.');
    for (long digit = unit / 10; digit > 0; digit /= 10) {
      text.append((char) ('0' + scaled / digit % 10));
    }
    text.append(' ');
    return this;
  }

  @Override
  public String toString() {
    return text.toString();
  }
}

package org.selectiverenderer.modelling;

/** Numbers as short decimal text, the same in every locale. */
public final class DecimalText {

  private DecimalText() {}

  /**
   * Rounded to so many decimals, without the zeros that say nothing: {@code 0.153}, {@code 0}.
   *
   * @param decimals 0 to 9
   */
  public static String of(double value, int decimals) {
    long unit = 1;
    for (int i = 0; i < decimals; i++) {
      unit *= 10;
    }
    long scaled = Math.round(Math.abs(value) * unit);
    if (scaled == 0) {
      return "0";
    }
    StringBuilder text = new StringBuilder(12);
    if (value < 0) {
      text.append('-');
    }
    text.append(scaled / unit);
    long rest = scaled % unit;
    if (rest > 0) {
      text.append('.');
      for (long digit = unit / 10; rest > 0; digit /= 10) {
        text.append((char) ('0' + rest / digit));
        rest %= digit;
      }
    }
    return text.toString();
  }
}

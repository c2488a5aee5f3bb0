package org.selectiverenderer.cli.view;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** A size in pixels, as {@code 1024x768} on the command line. */
record PixelSize(int width, int height) {
  private static final int MOST = 16384;
  private static final Pattern FORM = Pattern.compile("([0-9]{1,5})[xX]([0-9]{1,5})");

  /**
   * Returns the size as on the command line; the generated method of a record would slow down the
   * start.
   */
  @Override
  public String toString() {
    return width + "x" + height;
  }

  /** Converts a size. */
  static final class Converter implements ITypeConverter<PixelSize> {
    @Override
    public PixelSize convert(String value) {
      Matcher matcher = FORM.matcher(value);
      if (matcher.matches()) {
        int width = Integer.parseInt(matcher.group(1));
        int height = Integer.parseInt(matcher.group(2));
        if (width > 0 && height > 0 && width <= MOST && height <= MOST) {
          return new PixelSize(width, height);
        }
      }
      throw new TypeConversionException(
          "'" + value + "' is not a size such as 1024x768, from 1x1 to " + MOST + "x" + MOST);
    }
  }
}

package org.selectiverenderer.browser.sai;

import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.RenderedImage;
import java.awt.image.WritableRaster;
import java.util.Arrays;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.web3d.x3d.sai.InvalidFieldValueException;

/**
 * Implements the methods of SFImage, whose value is width, height, components and an integer per
 * pixel, the lowest row first (X3D 4.0, 5.3.6).
 */
final class ImageFieldMethods {
  private ImageFieldMethods() {}

  static int[] of(int width, int height, int components, int[] pixels) {
    if (width < 0 || height < 0 || components < 0 || components > 4) {
      throw new InvalidFieldValueException(
          "an image needs a width and height of 0 or more and 0 to 4 components");
    }
    if ((long) width * height > pixels.length) {
      throw new InvalidFieldValueException(
          "an image of %s x %s pixels has only %s in its array"
              .formatted(width, height, pixels.length));
    }
    int[] value = new int[3 + width * height];
    value[0] = width;
    value[1] = height;
    value[2] = components;
    System.arraycopy(pixels, 0, value, 3, width * height);
    return value;
  }

  /** Checks and copies an image value that an application passes as one array. */
  static int[] checked(int[] value) {
    if (value.length < 3) {
      throw new InvalidFieldValueException("an image begins with width, height and components");
    }
    return of(value[0], value[1], value[2], Arrays.copyOfRange(value, 3, value.length));
  }

  static @Nullable Object call(String method, Object[] a, FieldMethods.Target field) {
    switch (method) {
      case "getWidth" -> {
        return value(field)[0];
      }
      case "getHeight" -> {
        return value(field)[1];
      }
      case "getComponents" -> {
        return value(field)[2];
      }
      case "getPixels" -> {
        int[] value = value(field);
        System.arraycopy(value, 3, a[0], 0, value.length - 3);
      }
      case "getImage" -> {
        return image(value(field));
      }
      case "setImage" -> {
        int[] image = fromImage((RenderedImage) a[0]);
        field.change(old -> image);
      }
      case "setSubImage" -> {
        int[] part = fromImage((RenderedImage) a[0]);
        field.change(old -> withPart((int[]) Objects.requireNonNull(old), part, a));
      }
      default -> throw new UnsupportedOperationException(method);
    }
    return null;
  }

  private static int[] value(FieldMethods.Target field) {
    return (int[]) Objects.requireNonNull(field.value());
  }

  private static BufferedImage image(int[] value) {
    int width = value[0];
    int height = value[1];
    BufferedImage image =
        new BufferedImage(Math.max(1, width), Math.max(1, height), BufferedImage.TYPE_INT_ARGB);
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        image.setRGB(x, height - 1 - y, argb(value[3 + y * width + x], value[2]));
      }
    }
    return image;
  }

  private static int argb(int pixel, int components) {
    return switch (components) {
      case 1 -> 0xFF000000 | pixel << 16 | pixel << 8 | pixel;
      case 2 -> (pixel & 0xFF) << 24 | (pixel >>> 8 & 0xFF) * 0x010101;
      case 3 -> 0xFF000000 | pixel;
      default -> pixel << 24 | pixel >>> 8;
    };
  }

  private static int[] fromImage(RenderedImage rendered) {
    BufferedImage image = argbCopy(rendered);
    int width = image.getWidth();
    int height = image.getHeight();
    int[] pixels = new int[width * height];
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int argb = image.getRGB(x, height - 1 - y);
        pixels[y * width + x] = argb << 8 | argb >>> 24;
      }
    }
    return of(width, height, 4, pixels);
  }

  private static BufferedImage argbCopy(RenderedImage rendered) {
    if (rendered instanceof BufferedImage image) {
      return image;
    }
    WritableRaster pixels = rendered.copyData(null).createWritableTranslatedChild(0, 0);
    ColorModel colours = rendered.getColorModel();
    return new BufferedImage(colours, pixels, colours.isAlphaPremultiplied(), null);
  }

  /** Returns the field's image with a rectangle replaced by a part of another image. */
  private static int[] withPart(int[] value, int[] part, Object[] a) {
    int width = (Integer) a[1];
    int height = (Integer) a[2];
    int fromX = (Integer) a[3];
    int fromY = (Integer) a[4];
    int toX = (Integer) a[5];
    int toY = (Integer) a[6];
    check(part, fromX, fromY, width, height);
    check(value, toX, toY, width, height);
    int[] result = Arrays.copyOf(value, value.length);
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int rgba = part[3 + (fromY + y) * part[0] + fromX + x];
        result[3 + (toY + y) * value[0] + toX + x] = reduced(rgba, value[2]);
      }
    }
    return result;
  }

  private static void check(int[] image, int x, int y, int width, int height) {
    if (x < 0 || y < 0 || width < 0 || height < 0) {
      throw new InvalidFieldValueException("a sub-image's position and size must not be negative");
    }
    if ((long) x + width > image[0] || (long) y + height > image[1]) {
      throw new InvalidFieldValueException(
          "a sub-image of %s x %s at %s, %s exceeds the image of %s x %s"
              .formatted(width, height, x, y, image[0], image[1]));
    }
  }

  /** Converts an RGBA pixel to another number of components. */
  private static int reduced(int rgba, int components) {
    int alpha = rgba & 0xFF;
    int rgb = rgba >>> 8;
    // Luminance as in ITU-R BT.601.
    int grey =
        Math.round(0.299f * (rgb >>> 16) + 0.587f * (rgb >>> 8 & 0xFF) + 0.114f * (rgb & 0xFF));
    return switch (components) {
      case 1 -> grey;
      case 2 -> grey << 8 | alpha;
      case 3 -> rgb;
      default -> rgba;
    };
  }
}

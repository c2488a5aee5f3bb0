package org.selectiverenderer.runtime.sai;

import java.awt.image.BufferedImage;
import java.awt.image.RenderedImage;
import java.util.Arrays;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.web3d.x3d.sai.InvalidFieldValueException;

/**
 * The methods of SFImage, whose value is width, height, components and a number per pixel, the
 * lowest row first (X3D 4.0, 5.3.6).
 */
final class ImageValues {
  private ImageValues() {}

  static int[] of(int width, int height, int components, int[] pixels) {
    if (width < 0 || height < 0 || components < 0 || components > 4) {
      throw new InvalidFieldValueException(
          "an image has a size of 0 or more and 0 to 4 components");
    }
    if (pixels.length < width * height) {
      throw new InvalidFieldValueException(
          "%s x %s pixels are announced, %s are given".formatted(width, height, pixels.length));
    }
    int[] value = new int[3 + width * height];
    value[0] = width;
    value[1] = height;
    value[2] = components;
    System.arraycopy(pixels, 0, value, 3, width * height);
    return value;
  }

  static @Nullable Object call(String method, Object[] a, int[] value, Consumer<int[]> write) {
    switch (method) {
      case "getWidth" -> {
        return value[0];
      }
      case "getHeight" -> {
        return value[1];
      }
      case "getComponents" -> {
        return value[2];
      }
      case "getPixels" -> System.arraycopy(value, 3, a[0], 0, value.length - 3);
      case "getImage" -> {
        return image(value);
      }
      case "setImage" -> write.accept(fromImage((RenderedImage) a[0]));
      case "setSubImage" -> write.accept(withPart(value, a));
      default -> throw new UnsupportedOperationException(method);
    }
    return null;
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
    BufferedImage image =
        new BufferedImage(rendered.getWidth(), rendered.getHeight(), BufferedImage.TYPE_INT_ARGB);
    rendered.copyData(image.getRaster());
    return image;
  }

  /** The field's image with a rectangle of another one put in. */
  private static int[] withPart(int[] value, Object[] a) {
    int width = (Integer) a[1];
    int height = (Integer) a[2];
    int[] part = fromImage((RenderedImage) a[0]);
    int[] result = Arrays.copyOf(value, value.length);
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int from = 3 + ((Integer) a[4] + y) * part[0] + (Integer) a[3] + x;
        int to = 3 + ((Integer) a[6] + y) * value[0] + (Integer) a[5] + x;
        result[to] = part[from];
      }
    }
    return result;
  }
}

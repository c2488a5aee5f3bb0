package org.selectiverenderer.browser.script.value;

import org.mozilla.javascript.Context;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * An SFImage object with the properties {@code width} and {@code height} (in VRML97 {@code x} and
 * {@code y}), {@code comp}, and {@code array}, the pixels from the lower left.
 */
@SuppressWarnings("serial") // See FieldValue.
final class ImageValue extends FieldValue {
  /** The most pixels, far more than textures have. */
  private static final int MAX_PIXELS = 1 << 26;

  private int width;
  private int height;
  private int comp;
  private final ArrayValue pixels;

  /**
   * @param pixels an MFInt32 that belongs to the image
   */
  ImageValue(int width, int height, int comp, ArrayValue pixels) {
    super(FieldType.SFImage);
    this.width = width;
    this.height = height;
    this.comp = comp;
    this.pixels = pixels;
    pixels.heldBy(this::changed);
  }

  @Override
  public boolean has(String name, Scriptable start) {
    return switch (name) {
      case "width", "x", "height", "y", "comp", "array" -> true;
      default -> super.has(name, start);
    };
  }

  @Override
  public Object get(String name, Scriptable start) {
    return switch (name) {
      case "width", "x" -> width;
      case "height", "y" -> height;
      case "comp" -> comp;
      case "array" -> pixels;
      default -> super.get(name, start);
    };
  }

  @Override
  public void put(String name, Scriptable start, Object value) {
    switch (name) {
      case "width", "x" -> width = size(value);
      case "height", "y" -> height = size(value);
      case "comp" -> comp = Math.min(4, size(value));
      case "array" -> pixels.assign(value);
      default -> {
        super.put(name, start, value);
        return;
      }
    }
    changed();
  }

  private static int size(Object value) {
    int size = ScriptRuntime.toInt32(value);
    if (size < 0) {
      throw ScriptRuntime.rangeError("an image's size cannot be " + Context.toString(value));
    }
    return size;
  }

  @Override
  public Object toField() {
    long count = comp == 0 ? 0 : (long) width * height;
    if (count > MAX_PIXELS) {
      throw ScriptRuntime.rangeError("an image of %s x %s is too large".formatted(width, height));
    }
    int[] given = (int[]) pixels.toField();
    int[] value = new int[3 + (int) count];
    value[0] = width;
    value[1] = height;
    value[2] = comp;
    System.arraycopy(given, 0, value, 3, Math.min(given.length, (int) count));
    return value;
  }

  @Override
  String text() {
    return width + " " + height + " " + comp + " " + pixels.text();
  }
}

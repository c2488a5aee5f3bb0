package org.selectiverenderer.browser.script.value;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.selectiverenderer.scriptengine.ScriptMeter;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * An SFImage object with the properties {@code width} and {@code height} (in VRML97 {@code x} and
 * {@code y}), {@code comp}, and {@code array}, the pixels from the lower left.
 */
@SuppressWarnings("serial") // See FieldValue.
final class ImageValue extends FieldValue {
  /** The most pixels, far more than textures have. */
  private static final int MAX_PIXELS = 1 << 26;

  private final transient FieldValueConverter values;
  private int width;
  private int height;
  private int comp;

  /** The value that the image was made of, until a script asks for the pixels. */
  private final int[] given;

  private @Nullable ArrayValue pixels;

  /**
   * @param given width, height, components and pixels; not modified
   */
  ImageValue(FieldValueConverter values, int[] given) {
    super(FieldType.SFImage);
    this.values = values;
    this.given = given;
    if (given.length >= 3) {
      width = given[0];
      height = given[1];
      comp = given[2];
    }
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
      case "array" -> pixels();
      default -> super.get(name, start);
    };
  }

  private ArrayValue pixels() {
    if (pixels == null) {
      ScriptMeter.allocate(given.length, 4);
      int[] numbers = Arrays.copyOfRange(given, Math.min(3, given.length), given.length);
      pixels = values.array(FieldType.MFInt32, new ElementStorage(FieldType.MFInt32, numbers));
      pixels.belongsTo(new Pixels());
    }
    return pixels;
  }

  @Override
  public void put(String name, Scriptable start, Object value) {
    switch (name) {
      case "width", "x" -> resize(size(value), height, comp);
      case "height", "y" -> resize(width, size(value), comp);
      case "comp" -> resize(width, height, Math.min(4, size(value)));
      case "array" -> pixels().assign(value);
      default -> super.put(name, start, value);
    }
  }

  private static int size(Object value) {
    int size = ScriptRuntime.toInt32(value);
    if (size < 0) {
      throw ScriptRuntime.rangeError("an image's size cannot be " + Context.toString(value));
    }
    return size;
  }

  private void resize(int newWidth, int newHeight, int newComp) {
    beforeChange();
    count(newWidth, newHeight, newComp);
    width = newWidth;
    height = newHeight;
    comp = newComp;
    changed();
  }

  /** Returns the number of pixels. */
  private static int count(int width, int height, int comp) {
    long count = comp == 0 ? 0 : Math.max(0, (long) width * height);
    if (count > MAX_PIXELS) {
      throw ScriptRuntime.rangeError("an image of %s x %s is too large".formatted(width, height));
    }
    return (int) count;
  }

  @Override
  public Object toField() {
    int count = count(width, height, comp);
    ScriptMeter.allocate(3 + count, 4);
    int[] value = new int[3 + count];
    value[0] = width;
    value[1] = height;
    value[2] = comp;
    int[] from = pixels == null ? given : (int[]) pixels.toField();
    int at = pixels == null ? 3 : 0;
    System.arraycopy(from, at, value, 3, Math.max(0, Math.min(from.length - at, count)));
    return value;
  }

  @Override
  String text() {
    return width + " " + height + " " + comp + " " + pixels().text();
  }

  /** The place of the pixels in the image. */
  private final class Pixels implements ValueOwner {
    @Override
    public void beforeChange() {
      ImageValue.this.beforeChange();
    }

    @Override
    public void changed(FieldValue value) {
      ImageValue.this.changed();
    }
  }
}

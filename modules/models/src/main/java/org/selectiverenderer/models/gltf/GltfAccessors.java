package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.function.IntToDoubleFunction;

/**
 * Reads the arrays of numbers of a glTF file (glTF 2.0, 3.6.2): interleaved, sparse, and integers
 * that stand for fractions.
 */
final class GltfAccessors {
  private static final int BYTE = 5120;
  private static final int UNSIGNED_BYTE = 5121;
  private static final int SHORT = 5122;
  private static final int UNSIGNED_SHORT = 5123;
  private static final int UNSIGNED_INT = 5125;
  private static final int FLOAT = 5126;

  private final GltfFile file;
  private final Map<Integer, Unpacked> unpacked = new HashMap<>();
  private long left;

  /** Values of an accessor that are compressed elsewhere in the file. */
  private record Unpacked(int length, boolean integers, IntToDoubleFunction values) {}

  /**
   * @param most the number of values that may be read in all
   */
  GltfAccessors(GltfFile file, long most) {
    this.file = file;
    left = most;
  }

  /** Returns the number of values that may still be read. */
  long left() {
    return left;
  }

  /**
   * Gives an accessor without a bufferView its values, all components one after the other.
   *
   * @param integers whether they are integers, which the accessor may read as fractions
   */
  void unpacked(int index, int length, boolean integers, IntToDoubleFunction values) {
    unpacked.put(index, new Unpacked(length, integers, values));
  }

  /** Returns whether an accessor was given values. */
  boolean isUnpacked(int index) {
    return unpacked.containsKey(index);
  }

  /** Forgets all values that accessors were given. */
  void forgetUnpacked() {
    unpacked.clear();
  }

  /** Returns the number of components of an accessor; 0 if there is none. */
  int components(int index) {
    return switch (file.part("accessors", index).path("type").asText("")) {
      case "SCALAR" -> 1;
      case "VEC2" -> 2;
      case "VEC3" -> 3;
      case "VEC4", "MAT2" -> 4;
      case "MAT3" -> 9;
      case "MAT4" -> 16;
      default -> 0;
    };
  }

  /**
   * Returns the values of an accessor, all components one after the other; those that are not
   * finite are 0.
   *
   * @throws IOException if there is no such accessor or it lies outside of its file, with one
   *     sentence
   */
  float[] floats(int index) throws IOException {
    double[] values = values(index);
    float[] floats = new float[values.length];
    for (int i = 0; i < floats.length; i++) {
      float value = (float) values[i];
      floats[i] = Float.isFinite(value) ? value : 0;
    }
    return floats;
  }

  /** Returns the values of an accessor of whole numbers, as {@link #floats} does. */
  int[] ints(int index) throws IOException {
    double[] values = values(index);
    int[] ints = new int[values.length];
    for (int i = 0; i < ints.length; i++) {
      ints[i] = (int) values[i];
    }
    return ints;
  }

  private double[] values(int index) throws IOException {
    JsonNode accessor = file.part("accessors", index);
    int components = components(index);
    long count = accessor.path("count").asLong(0);
    if (components == 0 || count < 0) {
      throw new IOException("accessors[%d] is missing or has no known type".formatted(index));
    }
    if (count > Integer.MAX_VALUE || count * components > Math.min(left, Integer.MAX_VALUE - 8)) {
      throw new IOException("the model has more numbers than fit into the memory");
    }
    left -= count * components;
    String path = "accessors[%d]".formatted(index);
    int type = accessor.path("componentType").asInt();
    boolean normalized = accessor.path("normalized").asBoolean(false);
    int view = GltfFile.index(accessor, "bufferView");
    Unpacked given = unpacked.get(index);
    Layout layout = null;
    if (given == null && view >= 0) {
      int stride = file.part("bufferViews", view).path("byteStride").asInt(0);
      long offset = accessor.path("byteOffset").asLong(0);
      layout = new Layout(file.view(view), offset, stride, type, components, normalized, path);
      check(layout, count); // before there is an array for as many as are announced
    }
    if (given != null && given.length() != count * components) {
      throw new IOException(path + " announces another number of values than its Draco data");
    }
    double[] values = new double[(int) count * components];
    if (layout != null) {
      read(layout, values);
    } else if (given != null) {
      boolean fraction = normalized && given.integers();
      for (int i = 0; i < values.length; i++) {
        double value = given.values().applyAsDouble(i);
        values[i] = fraction ? fraction(type, value) : value;
      }
    }
    JsonNode sparse = accessor.path("sparse");
    if (sparse.isObject()) {
      sparse(sparse, type, components, normalized, path, values);
    }
    return values;
  }

  private void sparse(
      JsonNode sparse, int type, int components, boolean normalized, String path, double[] into)
      throws IOException {
    long count = sparse.path("count").asLong(0);
    if (count < 0 || count > into.length / components) {
      throw new IOException(path + ".sparse replaces more values than there are");
    }
    JsonNode indices = sparse.path("indices");
    double[] places = new double[(int) count];
    ByteBuffer bytes = file.view(GltfFile.index(indices, "bufferView"));
    long offset = indices.path("byteOffset").asLong(0);
    int indexType = indices.path("componentType").asInt();
    String in = path + ".sparse.indices";
    read(new Layout(bytes, offset, 0, indexType, 1, false, in), places);
    JsonNode values = sparse.path("values");
    ByteBuffer replacing = file.view(GltfFile.index(values, "bufferView"));
    long start = values.path("byteOffset").asLong(0);
    String of = path + ".sparse.values";
    double[] replaced = new double[(int) count * components];
    read(new Layout(replacing, start, 0, type, components, normalized, of), replaced);
    for (int i = 0; i < count; i++) {
      if (places[i] < 0 || places[i] >= into.length / components) {
        throw new IOException(in + " names a value that does not exist");
      }
      System.arraycopy(replaced, i * components, into, (int) places[i] * components, components);
    }
  }

  /** Tells where numbers lie and what they are. */
  private record Layout(
      ByteBuffer bytes,
      long offset,
      int stride,
      int type,
      int components,
      boolean normalized,
      String path) {
    /** Returns the bytes of a value with all its components. */
    long each() {
      return (long) size(type) * components;
    }

    /** Returns the bytes from one value to the next. */
    long step() {
      return stride > 0 ? stride : each();
    }
  }

  private static void check(Layout from, long count) throws IOException {
    if (size(from.type()) == 0) {
      throw new IOException(from.path() + ".componentType is none of glTF's");
    }
    long end = count == 0 ? 0 : from.offset() + (count - 1) * from.step() + from.each();
    int limit = from.bytes().limit();
    if (from.offset() < 0 || from.offset() > limit || end > limit) {
      throw new IOException(from.path() + " lies outside of its bufferView; the file is damaged");
    }
  }

  private static void read(Layout from, double[] into) throws IOException {
    long count = into.length / from.components();
    check(from, count);
    int size = size(from.type());
    for (int i = 0; i < count; i++) {
      int at = (int) (from.offset() + i * from.step());
      for (int k = 0; k < from.components(); k++) {
        into[i * from.components() + k] = value(from, at + k * size);
      }
    }
  }

  private static double value(Layout from, int at) {
    ByteBuffer bytes = from.bytes();
    boolean fraction = from.normalized();
    double value =
        switch (from.type()) {
          case BYTE -> bytes.get(at);
          case UNSIGNED_BYTE -> bytes.get(at) & 0xff;
          case SHORT -> bytes.getShort(at);
          case UNSIGNED_SHORT -> bytes.getShort(at) & 0xffff;
          case UNSIGNED_INT -> Integer.toUnsignedLong(bytes.getInt(at));
          default -> bytes.getFloat(at);
        };
    return fraction ? fraction(from.type(), value) : value;
  }

  /** Returns the fraction for which an integer stands (glTF 2.0, 3.6.2.2). */
  private static double fraction(int type, double value) {
    return switch (type) {
      case BYTE -> Math.max(value / 127.0, -1);
      case UNSIGNED_BYTE -> value / 255.0;
      case SHORT -> Math.max(value / 32767.0, -1);
      case UNSIGNED_SHORT -> value / 65535.0;
      default -> value;
    };
  }

  private static int size(int type) {
    return switch (type) {
      case BYTE, UNSIGNED_BYTE -> 1;
      case SHORT, UNSIGNED_SHORT -> 2;
      case UNSIGNED_INT, FLOAT -> 4;
      default -> 0;
    };
  }
}

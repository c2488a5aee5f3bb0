package org.selectiverenderer.models.importer;

import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.function.IntUnaryOperator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMaterial;

/**
 * Writes parts of a model as {@link ImportProtocol} describes them. Arrays are copied in chunks, so
 * that the child process needs little heap.
 */
final class ImportedModelEncoder {
  private static final int CHUNK = 1 << 14;

  private final DataOutputStream out;
  private final ByteBuffer chunk = ByteBuffer.allocate(CHUNK * Integer.BYTES);

  ImportedModelEncoder(DataOutputStream out) {
    this.out = out;
  }

  void number(int value) throws IOException {
    out.writeInt(value);
  }

  void string(String text) throws IOException {
    out.writeUTF(text);
  }

  void truth(boolean value) throws IOException {
    out.writeBoolean(value);
  }

  void number(float value) throws IOException {
    out.writeFloat(value);
  }

  /** Writes an array of bytes; null for none. */
  void bytes(@Nullable ByteBuffer bytes) throws IOException {
    if (bytes == null) {
      out.writeInt(0);
      return;
    }
    out.writeInt(bytes.remaining());
    byte[] part = new byte[CHUNK];
    while (bytes.hasRemaining()) {
      int length = Math.min(part.length, bytes.remaining());
      bytes.get(part, 0, length);
      out.write(part, 0, length);
    }
  }

  void material(ImportedMaterial material) throws IOException {
    floats(material.diffuse());
    floats(material.specular());
    floats(material.emissive());
    floats(material.specularExponent());
    floats(material.opacity());
    out.writeBoolean(material.texture() != null);
    if (material.texture() != null) {
      out.writeUTF(material.texture());
    }
  }

  void floats(float @Nullable ... values) throws IOException {
    floats(values == null ? null : FloatBuffer.wrap(values), 1, 1);
  }

  private void floats(@Nullable Float value) throws IOException {
    floats(value == null ? null : new float[] {value});
  }

  /**
   * Writes an array.
   *
   * @param values the values, or null for an absent array
   * @param from the number of components of each record
   * @param to how many of them are written
   */
  void floats(@Nullable FloatBuffer values, int from, int to) throws IOException {
    if (values == null) {
      out.writeInt(ImportProtocol.ABSENT);
      return;
    }
    ints(
        values.remaining() / from * to,
        i -> Float.floatToRawIntBits(values.get(i / to * from + i % to)));
  }

  /** Writes the values of a function of 0 to {@code count - 1}. */
  void ints(int count, IntUnaryOperator value) throws IOException {
    out.writeInt(count);
    for (int at = 0; at < count; at += CHUNK) {
      int part = Math.min(CHUNK, count - at);
      for (int i = 0; i < part; i++) {
        chunk.putInt(i * Integer.BYTES, value.applyAsInt(at + i));
      }
      out.write(chunk.array(), 0, part * Integer.BYTES);
    }
  }
}

package org.selectiverenderer.models.importer;

import java.io.DataInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMaterial;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMesh;

/**
 * Reads a model as {@link ImportProtocol} describes it. The child process has read a file that may
 * have taken it over, so every count, index and length is checked before it is used.
 */
final class ImportedModelDecoder {
  private static final int CHUNK = 1 << 16;

  /** The bytes of an object of its own that a count announces, at least. */
  private static final int OBJECT_BYTES = 64;

  private final DataInputStream in;
  private final byte[] chunk = new byte[CHUNK];
  private long left;

  /**
   * @param maxBytes the maximum size of everything that is read
   */
  ImportedModelDecoder(DataInputStream in, long maxBytes) {
    this.in = in;
    this.left = maxBytes;
  }

  /**
   * @throws IOException if the message is cut off or makes no sense
   * @throws ModelImportException if the model is too large
   */
  ImportedModel read() throws IOException, ModelImportException {
    int materialCount = count(OBJECT_BYTES);
    List<ImportedMaterial> materials = new ArrayList<>();
    for (int i = 0; i < materialCount; i++) {
      materials.add(new ImportedMaterial(color(), color(), color(), number(), number(), texture()));
    }
    int meshCount = count(OBJECT_BYTES);
    List<ImportedMesh> meshes = new ArrayList<>();
    for (int i = 0; i < meshCount; i++) {
      meshes.add(mesh(materialCount));
    }
    return new ImportedModel(materials, meshes);
  }

  private ImportedMesh mesh(int materialCount) throws IOException, ModelImportException {
    String name = string();
    int material = in.readInt();
    check(material >= 0 && material < materialCount);
    float[] positions = floats();
    check(positions != null && positions.length % 3 == 0);
    int vertices = positions.length / 3;
    float[] normals = floats();
    check(normals == null || normals.length == positions.length);
    float[] texCoords = floats();
    check(texCoords == null || texCoords.length == 2L * vertices);
    float[] colors = floats();
    check(colors == null || colors.length == 4L * vertices);
    int[] triangles = ints();
    check(triangles.length % 3 == 0);
    for (int index : triangles) {
      check(index >= 0 && index < vertices);
    }
    return new ImportedMesh(name, material, positions, normals, texCoords, colors, triangles);
  }

  private float @Nullable [] color() throws IOException, ModelImportException {
    float[] color = floats();
    check(color == null || color.length == 3);
    return color;
  }

  private @Nullable Float number() throws IOException, ModelImportException {
    float[] value = floats();
    check(value == null || value.length == 1);
    return value == null ? null : value[0];
  }

  private @Nullable String texture() throws IOException, ModelImportException {
    return in.readBoolean() ? string() : null;
  }

  private String string() throws IOException, ModelImportException {
    String text = in.readUTF();
    take(2L * text.length());
    return text;
  }

  private float @Nullable [] floats() throws IOException, ModelImportException {
    int count = in.readInt();
    if (count == ImportProtocol.ABSENT) {
      return null;
    }
    check(count >= 0);
    take((long) Float.BYTES * count);
    float[] values = new float[count];
    for (int at = 0; at < count; at += CHUNK / Float.BYTES) {
      int part = Math.min(CHUNK / Float.BYTES, count - at);
      in.readFully(chunk, 0, part * Float.BYTES);
      ByteBuffer.wrap(chunk).asFloatBuffer().get(values, at, part);
    }
    return values;
  }

  private int[] ints() throws IOException, ModelImportException {
    int count = count(Integer.BYTES);
    int[] values = new int[count];
    for (int at = 0; at < count; at += CHUNK / Integer.BYTES) {
      int part = Math.min(CHUNK / Integer.BYTES, count - at);
      in.readFully(chunk, 0, part * Integer.BYTES);
      ByteBuffer.wrap(chunk).asIntBuffer().get(values, at, part);
    }
    return values;
  }

  private int count(int bytesEach) throws IOException, ModelImportException {
    int count = in.readInt();
    check(count >= 0);
    take((long) bytesEach * count);
    return count;
  }

  private void take(long bytes) throws ModelImportException {
    left -= bytes;
    if (left < 0) {
      throw new ModelImportException("the model has more vertices than the memory has room for");
    }
  }

  private static void check(boolean holds) throws IOException {
    if (!holds) {
      throw new IOException("the model reader's answer makes no sense");
    }
  }
}

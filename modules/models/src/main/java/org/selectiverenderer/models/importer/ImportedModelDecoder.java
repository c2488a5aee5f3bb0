package org.selectiverenderer.models.importer;

import java.io.DataInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.models.importer.ImportedModel.ImportedAnimation;
import org.selectiverenderer.models.importer.ImportedModel.ImportedBone;
import org.selectiverenderer.models.importer.ImportedModel.ImportedCamera;
import org.selectiverenderer.models.importer.ImportedModel.ImportedChannel;
import org.selectiverenderer.models.importer.ImportedModel.ImportedLight;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMaterial;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMesh;
import org.selectiverenderer.models.importer.ImportedModel.ImportedNode;
import org.selectiverenderer.models.importer.ImportedModel.ImportedTexture;
import org.selectiverenderer.models.importer.ImportedModel.LightKind;

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
  private int nodeCount;

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
      materials.add(
          new ImportedMaterial(color(), color(), color(), number(), number(), textureUrl()));
    }
    List<ImportedTexture> textures = list(this::texture);
    nodeCount = count(OBJECT_BYTES);
    List<ImportedNode> nodes = new ArrayList<>();
    for (int i = 0; i < nodeCount; i++) {
      nodes.add(node(i));
    }
    List<ImportedMesh> meshes = list(() -> mesh(materialCount));
    for (ImportedNode node : nodes) {
      check(Arrays.stream(node.meshes()).allMatch(mesh -> mesh >= 0 && mesh < meshes.size()));
    }
    return new ImportedModel(
        materials,
        meshes,
        textures,
        nodes,
        list(this::camera),
        list(this::light),
        list(this::animation));
  }

  /** Reads an element of a list. */
  @FunctionalInterface
  private interface Element<T> {
    T read() throws IOException, ModelImportException;
  }

  private <T> List<T> list(Element<T> element) throws IOException, ModelImportException {
    int count = count(OBJECT_BYTES);
    List<T> list = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      list.add(element.read());
    }
    return list;
  }

  private ImportedTexture texture() throws IOException, ModelImportException {
    byte[] bytes = in.readNBytes(count(1));
    return new ImportedTexture(bytes);
  }

  private ImportedNode node(int index) throws IOException, ModelImportException {
    String name = string();
    int parent = in.readInt();
    check(index == 0 ? parent == -1 : parent >= 0 && parent < index);
    return new ImportedNode(name, parent, floats(16), ints());
  }

  private int nodeIndex() throws IOException {
    int node = in.readInt();
    check(node >= 0 && node < nodeCount);
    return node;
  }

  private ImportedCamera camera() throws IOException, ModelImportException {
    return new ImportedCamera(
        nodeIndex(),
        floats(3),
        floats(3),
        floats(3),
        in.readFloat(),
        in.readFloat(),
        in.readFloat());
  }

  private ImportedLight light() throws IOException, ModelImportException {
    int node = nodeIndex();
    int kind = in.readInt();
    check(kind >= 0 && kind < LightKind.values().length);
    return new ImportedLight(
        node, LightKind.values()[kind], floats(3), floats(3), floats(3), floats(3), floats(2));
  }

  private ImportedAnimation animation() throws IOException, ModelImportException {
    return new ImportedAnimation(string(), list(this::channel), in.readBoolean());
  }

  private ImportedChannel channel() throws IOException, ModelImportException {
    int node = nodeIndex();
    float[] translationTimes = present();
    float[] translations = floats(3L * translationTimes.length);
    float[] rotationTimes = present();
    float[] rotations = floats(4L * rotationTimes.length);
    float[] scaleTimes = present();
    float[] scales = floats(3L * scaleTimes.length);
    return new ImportedChannel(
        node, translationTimes, translations, rotationTimes, rotations, scaleTimes, scales);
  }

  private ImportedBone bone(int vertices) throws IOException, ModelImportException {
    int node = nodeIndex();
    float[] inverse = floats(16);
    int[] moved = ints();
    check(Arrays.stream(moved).allMatch(vertex -> vertex >= 0 && vertex < vertices));
    return new ImportedBone(node, inverse, moved, floats(moved.length));
  }

  private float[] present() throws IOException, ModelImportException {
    float[] values = floats();
    check(values != null);
    return values;
  }

  private float[] floats(long count) throws IOException, ModelImportException {
    float[] values = present();
    check(values.length == count);
    return values;
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
    List<ImportedBone> bones = list(() -> bone(vertices));
    return new ImportedMesh(
        name, material, positions, normals, texCoords, colors, triangles, bones);
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

  private @Nullable String textureUrl() throws IOException, ModelImportException {
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

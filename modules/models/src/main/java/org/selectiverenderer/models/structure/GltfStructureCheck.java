package org.selectiverenderer.models.structure;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.models.structure.GltfStructure.Part;

/**
 * Checks the structure of a glTF file, in JSON or binary: how deeply it is nested, that its nodes
 * are a tree, and that its arrays of numbers lie inside of its buffers, those of glTF 1.0 at least:
 * of 2.0 only what shows an array outside is left out.
 */
final class GltfStructureCheck {
  /** The maximum nesting depth of nodes, as that of an X3D model's. */
  static final int MAX_NODE_DEPTH = 500;

  /** The maximum size of arrays that the file does not contain, which consist of zeros. */
  private static final long MAX_ZEROS = 64L << 20;

  private static final int MAGIC = 0x46546C67;
  private static final int CHUNK_OF_JSON = 0x4E4F534A;

  /** The padding of a chunk, by which the last buffer may be shorter. */
  private static final int PADDING = 3;

  private final long maxBytes;
  private final GltfStructure found;

  /** Whether it is glTF 2.0, of which a reader of this program checks each array that it reads. */
  private final boolean second;

  private GltfStructureCheck(long maxBytes, GltfStructure found, boolean second) {
    this.maxBytes = maxBytes;
    this.found = found;
    this.second = second;
  }

  /**
   * Checks a file.
   *
   * @param maxBytes the size of all arrays of numbers together
   * @param size the number of bytes of the stream
   */
  static void check(InputStream in, long size, long maxBytes)
      throws IOException, ModelStructureException {
    byte[] header = in.readNBytes(20);
    ByteBuffer numbers = ByteBuffer.wrap(header).order(ByteOrder.LITTLE_ENDIAN);
    if (header.length < 20 || numbers.getInt(0) != MAGIC) {
      InputStream whole = new SequenceInputStream(new ByteArrayInputStream(header), in);
      GltfStructure found = GltfStructureReader.read(whole);
      new GltfStructureCheck(maxBytes, found, found.isSecond()).checkParts(-1);
      return;
    }
    long length = Integer.toUnsignedLong(numbers.getInt(8));
    long first = Integer.toUnsignedLong(numbers.getInt(12));
    if (length > size || first > size - header.length) {
      throw new ModelStructureException(GltfStructureReader.DAMAGED);
    }
    // In version 1 the rest is the only buffer; in version 2 each chunk has a kind.
    int version = numbers.getInt(4);
    boolean chunks = version == 2;
    if (version != 1 && !chunks || chunks && numbers.getInt(16) != CHUNK_OF_JSON) {
      throw new ModelStructureException(GltfStructureReader.DAMAGED);
    }
    byte[] text = in.readNBytes((int) Math.min(first, Integer.MAX_VALUE - 8));
    GltfStructure found = GltfStructureReader.read(new ByteArrayInputStream(text));
    long left = size - header.length - first;
    if (chunks && left >= 8) {
      left -= 8;
      byte[] second = in.readNBytes(8);
      long stated =
          Integer.toUnsignedLong(ByteBuffer.wrap(second).order(ByteOrder.LITTLE_ENDIAN).getInt(0));
      if (second.length < 8 || stated > left) {
        throw new ModelStructureException(GltfStructureReader.DAMAGED);
      }
    }
    new GltfStructureCheck(maxBytes, found, found.isSecond() && chunks).checkParts(left);
  }

  /**
   * @param binary the bytes after the text; -1 for a file of text only
   */
  private void checkParts(long binary) throws ModelStructureException {
    long zeros = checkBuffers(binary);
    for (Map.Entry<String, Part> entry : found.accessors().entrySet()) {
      zeros += checkAccessor(entry.getKey(), entry.getValue());
    }
    if (zeros > MAX_ZEROS) {
      throw new ModelStructureException(
          "the file announces %d MiB of numbers that it does not contain, where %d are the limit; "
                  .formatted(zeros >> 20, MAX_ZEROS >> 20)
              + "nothing is read");
    }
    checkTree();
    long all = found.otherArrays().stream().mapToLong(this::size).sum();
    Map<String, Long> sizes = new HashMap<>();
    found
        .arraysOfMeshes()
        .forEach((id, arrays) -> sizes.put(id, arrays.stream().mapToLong(this::size).sum()));
    for (List<String> shown : found.meshesOfNodes().values()) {
      for (String mesh : shown) {
        all += sizes.getOrDefault(mesh, 0L);
        if (all > maxBytes) {
          throw new ModelStructureException(
              "the model has more than %d MiB of vertices, which is the limit; nothing is read"
                  .formatted(maxBytes >> 20));
        }
      }
    }
  }

  private long checkBuffers(long binary) throws ModelStructureException {
    long zeros = 0;
    for (Map.Entry<String, Part> entry : found.buffers().entrySet()) {
      long length = entry.getValue().number("byteLength");
      boolean inFile = binary >= 0 && Set.of("0", "binary_glTF").contains(entry.getKey());
      if (!entry.getValue().has("uri") && inFile && length > binary + PADDING) {
        throw new ModelStructureException(
            "the buffer in the file should have %d bytes, but has %d; it is damaged or cut off"
                .formatted(length, binary));
      }
      zeros += entry.getValue().has("uri") || inFile ? 0 : length;
    }
    Map<String, Part> checked = second ? Map.of() : found.views();
    for (Map.Entry<String, Part> entry : checked.entrySet()) {
      Part view = entry.getValue();
      Part buffer = found.buffers().get(view.references().getOrDefault("buffer", ""));
      if (buffer == null
          || view.number("byteOffset") + view.number("byteLength") > buffer.number("byteLength")) {
        throw new ModelStructureException(
            "bufferView %s lies outside of its buffer; the file is damaged"
                .formatted(entry.getKey()));
      }
    }
    return zeros;
  }

  /** Checks an accessor and returns the bytes of it that are not in the file. */
  private long checkAccessor(String id, Part accessor) throws ModelStructureException {
    long count = accessor.number("count");
    if (!accessor.has("bufferView")) {
      return size(accessor);
    }
    if (second) {
      return 0;
    }
    Part view = found.views().get(accessor.references().get("bufferView"));
    long each = size(accessor) / Math.max(1, count);
    long stride =
        view == null ? each : Math.max(view.number("byteStride"), accessor.number("byteStride"));
    long needed = count == 0 ? 0 : (count - 1) * Math.max(stride, each) + each;
    if (view == null || accessor.number("byteOffset") + needed > view.number("byteLength")) {
      throw new ModelStructureException(
          "accessor %s lies outside of its bufferView; the file is damaged".formatted(id));
    }
    return 0;
  }

  private long size(String accessor) {
    Part part = found.accessors().get(accessor);
    return part == null ? 0 : size(part);
  }

  private static long size(Part accessor) {
    int component =
        switch ((int) accessor.number("componentType")) {
          case 5120, 5121 -> 1;
          case 5122, 5123 -> 2;
          default -> 4;
        };
    int components =
        switch (accessor.references().getOrDefault("type", "")) {
          case "SCALAR" -> 1;
          case "VEC2" -> 2;
          case "VEC3" -> 3;
          case "VEC4", "MAT2" -> 4;
          case "MAT3" -> 9;
          default -> 16;
        };
    return accessor.number("count") * component * components;
  }

  private void checkTree() throws ModelStructureException {
    Set<String> below = new HashSet<>();
    for (List<String> list : found.children().values()) {
      for (String child : list) {
        if (!below.add(child)) {
          throw twice(child);
        }
      }
    }
    for (List<String> roots : found.scenes()) {
      Set<String> known = new HashSet<>();
      for (String node : roots) {
        if (below.contains(node) || !known.add(node)) {
          throw twice(node);
        }
      }
    }
    Deque<String> level = new ArrayDeque<>();
    found.children().keySet().stream().filter(node -> !below.contains(node)).forEach(level::add);
    int visited = 0;
    for (int depth = 1; !level.isEmpty(); depth++) {
      if (depth > MAX_NODE_DEPTH) {
        throw new ModelStructureException(
            "nodes are nested more than %d deep; nothing is read".formatted(MAX_NODE_DEPTH));
      }
      for (int i = level.size(); i > 0; i--) {
        visited++;
        level.addAll(found.children().getOrDefault(level.remove(), List.of()));
      }
    }
    if (visited < found.children().size()) {
      throw new ModelStructureException("a node contains itself; the file is damaged");
    }
  }

  private static ModelStructureException twice(String node) {
    return new ModelStructureException(
        "node %s is in the tree of nodes twice; the file is damaged".formatted(node));
  }
}

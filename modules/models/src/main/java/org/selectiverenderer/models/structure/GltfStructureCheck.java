package org.selectiverenderer.models.structure;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.SequenceInputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Checks the structure of a glTF file, in JSON or binary: how deeply it is nested, that its nodes
 * are a tree, and that its arrays of numbers lie inside of its buffers, those of glTF 1.0 at least:
 * of 2.0 only what shows an array outside is left out. Parts refer to each other by the index in
 * their array, in glTF 1.0 by a name; an index is read as a name here.
 */
final class GltfStructureCheck {
  /** The maximum nesting depth of values; those of glTF itself are 10 deep. */
  static final int MAX_DEPTH = 250;

  /** The maximum nesting depth of nodes, as that of an X3D model's. */
  static final int MAX_NODE_DEPTH = 500;

  /** The maximum number of nodes, accessors and so on, and of references to them. */
  private static final int MAX_PARTS = 1_000_000;

  /** The maximum size of arrays that the file does not contain, which consist of zeros. */
  private static final long MAX_ZEROS = 64L << 20;

  private static final String DAMAGED =
      "this is not a glTF model, or it is damaged or cut off; nothing is read";

  private static final int MAGIC = 0x46546C67;
  private static final int CHUNK_OF_JSON = 0x4E4F534A;

  /** The padding of a chunk, by which the last buffer may be shorter. */
  private static final int PADDING = 3;

  /** Stands for larger numbers too; its square is still a long. */
  private static final long MAX_NUMBER = 1L << 31;

  private static final int BYTE_ORDER_MARK = 0xFEFF;

  /** A part's members that are numbers or references, by name. */
  private record Part(Map<String, Long> numbers, Map<String, String> references) {
    Part() {
      this(new HashMap<>(), new HashMap<>());
    }

    long number(String key) {
      return numbers.getOrDefault(key, 0L);
    }

    boolean has(String key) {
      return references.containsKey(key);
    }
  }

  private final long maxBytes;
  private final Map<String, Part> accessors = new HashMap<>();
  private final Map<String, Part> views = new HashMap<>();
  private final Map<String, Part> buffers = new HashMap<>();
  private final Map<String, List<String>> arraysOfMeshes = new HashMap<>();
  private final Map<String, List<String>> children = new HashMap<>();
  private final Map<String, List<String>> meshesOfNodes = new HashMap<>();
  private final List<List<String>> scenes = new ArrayList<>();
  private final List<String> otherArrays = new ArrayList<>();
  private boolean versioned;

  /** Whether it is glTF 2.0, of which a reader of this program checks each array that it reads. */
  private boolean second;

  private int parts;

  GltfStructureCheck(long maxBytes) {
    this.maxBytes = maxBytes;
  }

  void check(InputStream in, long size) throws IOException, ModelStructureException {
    byte[] header = in.readNBytes(20);
    ByteBuffer numbers = ByteBuffer.wrap(header).order(ByteOrder.LITTLE_ENDIAN);
    if (header.length < 20 || numbers.getInt(0) != MAGIC) {
      InputStream whole = new SequenceInputStream(new ByteArrayInputStream(header), in);
      json(whole);
      checkParts(-1);
      return;
    }
    long length = Integer.toUnsignedLong(numbers.getInt(8));
    long first = Integer.toUnsignedLong(numbers.getInt(12));
    if (length > size || first > size - header.length) {
      throw new ModelStructureException(DAMAGED);
    }
    // In version 1 the rest is the only buffer; in version 2 each chunk has a kind.
    int version = numbers.getInt(4);
    boolean chunks = version == 2;
    if (version != 1 && !chunks || chunks && numbers.getInt(16) != CHUNK_OF_JSON) {
      throw new ModelStructureException(DAMAGED);
    }
    byte[] text = in.readNBytes((int) Math.min(first, Integer.MAX_VALUE - 8));
    json(new ByteArrayInputStream(text));
    second &= chunks;
    long left = size - header.length - first;
    if (chunks && left >= 8) {
      left -= 8;
      byte[] second = in.readNBytes(8);
      long stated =
          Integer.toUnsignedLong(ByteBuffer.wrap(second).order(ByteOrder.LITTLE_ENDIAN).getInt(0));
      if (second.length < 8 || stated > left) {
        throw new ModelStructureException(DAMAGED);
      }
    }
    checkParts(left);
  }

  // --- Reading ----------------------------------------------------------------------------------

  private void json(InputStream in) throws IOException, ModelStructureException {
    JsonFactory factory =
        JsonFactory.builder()
            .streamReadConstraints(
                StreamReadConstraints.builder().maxNestingDepth(MAX_DEPTH).build())
            // Of a member that is there twice, other readers take the other.
            .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
            .disable(JsonFactory.Feature.INTERN_FIELD_NAMES)
            .disable(JsonFactory.Feature.CANONICALIZE_FIELD_NAMES)
            .build();
    try (JsonParser parser = factory.createParser(reader(in))) {
      if (parser.nextToken() != JsonToken.START_OBJECT) {
        throw new ModelStructureException(DAMAGED);
      }
      members(parser, key -> top(parser, key));
      if (parser.nextToken() != null || !versioned) {
        throw new ModelStructureException(DAMAGED);
      }
    } catch (StreamConstraintsException e) {
      throw new ModelStructureException(
          "values are nested more than %d deep, or a name or number is too long; nothing is read"
              .formatted(MAX_DEPTH));
    } catch (JsonProcessingException e) {
      throw new ModelStructureException(DAMAGED);
    }
  }

  /** Returns the text without a byte order mark. */
  private static Reader reader(InputStream in) throws IOException {
    Reader text = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
    text.mark(1);
    if (text.read() != BYTE_ORDER_MARK) {
      text.reset();
    }
    return text;
  }

  /** Reads the value of a member, or leaves it, which is then skipped. */
  @FunctionalInterface
  private interface ValueReader {
    void read(String key) throws IOException, ModelStructureException;
  }

  /** Reads the members of an object, or the elements of an array by their index. */
  private static void members(JsonParser parser, ValueReader value)
      throws IOException, ModelStructureException {
    JsonToken start = parser.currentToken();
    if (start != JsonToken.START_OBJECT && start != JsonToken.START_ARRAY) {
      return;
    }
    int index = 0;
    while (true) {
      JsonToken token = parser.nextToken();
      if (token == null || token == JsonToken.END_OBJECT || token == JsonToken.END_ARRAY) {
        return;
      }
      String key = start == JsonToken.START_ARRAY ? String.valueOf(index++) : parser.currentName();
      JsonToken at = start == JsonToken.START_ARRAY ? token : parser.nextToken();
      value.read(key);
      if (parser.currentToken() == at) {
        parser.skipChildren();
      }
    }
  }

  private void top(JsonParser parser, String key) throws IOException, ModelStructureException {
    switch (key) {
      case "asset" ->
          members(
              parser,
              member -> {
                if (member.equals("version")) {
                  String version = parser.getValueAsString("");
                  versioned = version.matches("[12]\\.\\d+");
                  second = version.startsWith("2.");
                }
              });
      case "nodes" -> members(parser, id -> node(parser, id));
      case "scenes" ->
          members(
              parser,
              id -> {
                List<String> roots = new ArrayList<>();
                scenes.add(roots);
                members(
                    parser,
                    member -> {
                      if (member.equals("nodes")) {
                        references(parser, roots);
                      }
                    });
              });
      case "meshes" ->
          members(
              parser,
              id -> {
                List<String> arrays = new ArrayList<>();
                arraysOfMeshes.put(id, arrays);
                arrays(parser, arrays);
              });
      case "animations", "skins" -> members(parser, id -> arrays(parser, otherArrays));
      case "accessors" -> members(parser, id -> part(parser, accessors, id));
      case "bufferViews" -> members(parser, id -> part(parser, views, id));
      case "buffers" -> members(parser, id -> part(parser, buffers, id));
      default -> {
        // not of interest
      }
    }
  }

  private void node(JsonParser parser, String id) throws IOException, ModelStructureException {
    List<String> below = new ArrayList<>();
    List<String> shown = new ArrayList<>();
    count();
    children.put(id, below);
    meshesOfNodes.put(id, shown);
    members(
        parser,
        member -> {
          switch (member) {
            case "children" -> references(parser, below);
            case "mesh", "meshes" -> references(parser, shown);
            default -> {
              // not of interest
            }
          }
        });
  }

  /** Reads a part's numbers and references, one level deep. */
  private void part(JsonParser parser, Map<String, Part> to, String id)
      throws IOException, ModelStructureException {
    Part part = new Part();
    count();
    to.put(id, part);
    members(
        parser,
        member -> {
          switch (member) {
            case "bufferView", "buffer", "type" ->
                part.references().put(member, parser.getValueAsString(""));
            case "uri" -> part.references().put(member, ""); // It may be long.
            case "count", "componentType", "byteOffset", "byteLength", "byteStride" ->
                part.numbers().put(member, number(parser));
            default -> {
              // not of interest
            }
          }
        });
  }

  /** Returns a number; one that is negative counts as very large, as which others may read it. */
  private static long number(JsonParser parser) throws IOException {
    double value = parser.getValueAsDouble(0);
    return value >= 0 ? (long) Math.min(value, MAX_NUMBER) : MAX_NUMBER;
  }

  /** Collects the accessors to which anything inside of a value refers. */
  private void arrays(JsonParser parser, List<String> to)
      throws IOException, ModelStructureException {
    members(
        parser,
        member -> {
          switch (member) {
            case "attributes" -> references(parser, to);
            case "indices", "input", "output", "inverseBindMatrices" -> references(parser, to);
            case "targets" -> members(parser, target -> references(parser, to));
            case "extras", "extensions" -> {
              // not of interest
            }
            default -> arrays(parser, to);
          }
        });
  }

  /** Collects a reference, or those in an array or object. */
  private void references(JsonParser parser, List<String> to)
      throws IOException, ModelStructureException {
    if (parser.currentToken().isScalarValue()) {
      count();
      to.add(parser.getValueAsString(""));
    } else {
      members(parser, element -> references(parser, to));
    }
  }

  private void count() throws ModelStructureException {
    if (++parts > MAX_PARTS) {
      throw new ModelStructureException(
          "the file has more than %d nodes, arrays and references, which is the limit; "
                  .formatted(MAX_PARTS)
              + "nothing is read");
    }
  }

  // --- Checks -----------------------------------------------------------------------------------

  /**
   * @param binary the bytes after the text; -1 for a file of text only
   */
  private void checkParts(long binary) throws ModelStructureException {
    long zeros = checkBuffers(binary);
    for (Map.Entry<String, Part> entry : accessors.entrySet()) {
      zeros += checkAccessor(entry.getKey(), entry.getValue());
    }
    if (zeros > MAX_ZEROS) {
      throw new ModelStructureException(
          "the file announces %d MiB of numbers that it does not contain, where %d are the limit; "
                  .formatted(zeros >> 20, MAX_ZEROS >> 20)
              + "nothing is read");
    }
    checkTree();
    long all = otherArrays.stream().mapToLong(this::size).sum();
    Map<String, Long> sizes = new HashMap<>();
    arraysOfMeshes.forEach(
        (id, arrays) -> sizes.put(id, arrays.stream().mapToLong(this::size).sum()));
    for (List<String> shown : meshesOfNodes.values()) {
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
    for (Map.Entry<String, Part> entry : buffers.entrySet()) {
      long length = entry.getValue().number("byteLength");
      boolean inFile = binary >= 0 && Set.of("0", "binary_glTF").contains(entry.getKey());
      if (!entry.getValue().has("uri") && inFile && length > binary + PADDING) {
        throw new ModelStructureException(
            "the buffer in the file should have %d bytes, but has %d; it is damaged or cut off"
                .formatted(length, binary));
      }
      zeros += entry.getValue().has("uri") || inFile ? 0 : length;
    }
    Map<String, Part> checked = second ? Map.of() : views;
    for (Map.Entry<String, Part> entry : checked.entrySet()) {
      Part view = entry.getValue();
      Part buffer = buffers.get(view.references().getOrDefault("buffer", ""));
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
    Part view = views.get(accessor.references().get("bufferView"));
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
    Part found = accessors.get(accessor);
    return found == null ? 0 : size(found);
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
    for (List<String> list : children.values()) {
      for (String child : list) {
        if (!below.add(child)) {
          throw twice(child);
        }
      }
    }
    for (List<String> roots : scenes) {
      Set<String> known = new HashSet<>();
      for (String node : roots) {
        if (below.contains(node) || !known.add(node)) {
          throw twice(node);
        }
      }
    }
    Deque<String> level = new ArrayDeque<>();
    children.keySet().stream().filter(node -> !below.contains(node)).forEach(level::add);
    int visited = 0;
    for (int depth = 1; !level.isEmpty(); depth++) {
      if (depth > MAX_NODE_DEPTH) {
        throw new ModelStructureException(
            "nodes are nested more than %d deep; nothing is read".formatted(MAX_NODE_DEPTH));
      }
      for (int i = level.size(); i > 0; i--) {
        visited++;
        level.addAll(children.getOrDefault(level.remove(), List.of()));
      }
    }
    if (visited < children.size()) {
      throw new ModelStructureException("a node contains itself; the file is damaged");
    }
  }

  private static ModelStructureException twice(String node) {
    return new ModelStructureException(
        "node %s is in the tree of nodes twice; the file is damaged".formatted(node));
  }
}

package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.Set;
import java.util.TreeSet;

/**
 * A glTF 2.0 document that is being built: its JSON and its one binary buffer (Khronos, glTF 2.0
 * Specification, 3.6 and 4.4).
 */
final class GltfDocument {
  /** Tells what a buffer view is for: GL's names of the two kinds of vertex data, or neither. */
  enum Target {
    VERTICES(34962),
    INDICES(34963),
    OTHER(0);

    private final int code;

    Target(int code) {
      this.code = code;
    }
  }

  /** The most bytes of JSON and of the buffer, wherever the program runs. */
  private static final long MOST = 1 << 30;

  /** The bytes that a node of a scene takes as JSON, with what belongs to it. */
  private static final int NODE = 1 << 10;

  /** The bytes that a value in JSON takes besides its characters. */
  private static final int VALUE = 1 << 6;

  /** The bytes of the buffer that are encoded at once; a multiple of three. */
  private static final int ENCODED_AT_ONCE = 3 << 14;

  private static final int FLOAT = 5126;
  private static final int UNSIGNED_INT = 5125;
  private static final String URL = "data:application/octet-stream;base64,";
  private static final int GLB_MAGIC = 0x46546C67;
  private static final int JSON_CHUNK = 0x4E4F534A;
  private static final int BINARY_CHUNK = 0x004E4942;

  private final JsonNodeFactory json = JsonNodeFactory.instance;
  private final ObjectNode root = json.objectNode();
  private final Set<String> extensions = new TreeSet<>();
  private final long maxText;
  private final int maxBytes;
  private long text;
  private byte[] buffer = new byte[1 << 16];
  private int size;

  /** Makes a document that fits into the memory of Java, of which the scene takes some already. */
  GltfDocument() {
    this(Runtime.getRuntime().maxMemory());
  }

  /**
   * @param memory the bytes of memory, of which a quarter is for JSON and a fifth for the buffer,
   *     since each is copied when it is written
   */
  GltfDocument(long memory) {
    maxText = Math.min(MOST, memory / 4);
    maxBytes = (int) Math.min(MOST, memory / 5);
    root.putObject("asset").put("version", "2.0").put("generator", "Selective Renderer");
  }

  /** Returns a new object, which is in no array yet. */
  ObjectNode object() {
    return json.objectNode();
  }

  ObjectNode root() {
    return root;
  }

  /** Adds an object to one of the top-level arrays and returns its index. */
  int add(String array, ObjectNode value) {
    ArrayNode list = root.withArray("/" + array);
    list.add(value);
    return list.size() - 1;
  }

  /** Returns an object of a top-level array. */
  ObjectNode get(String array, int index) {
    return (ObjectNode) root.get(array).get(index);
  }

  /** Returns the object of an extension in an object, and lists the extension as used. */
  ObjectNode extension(ObjectNode in, String name) {
    extensions.add(name);
    return in.withObject("/extensions").withObject("/" + name);
  }

  /**
   * Takes the memory for a node of the scene.
   *
   * @throws IOException if too many have been counted, as nested USEs multiply without bound
   */
  void countNode() throws IOException {
    count(NODE);
  }

  /**
   * Takes the memory for a value in JSON.
   *
   * @throws IOException if too many have been counted
   */
  void countValue(String value) throws IOException {
    // in the tree, in the text, and in its copy
    count(VALUE + 3L * value.length());
  }

  private void count(long bytes) throws IOException {
    text += bytes;
    if (text > maxText) {
      throw new IOException(
          "the scene contains itself, or its nodes, names and metadata need more than %d MiB in"
                  .formatted(maxText >> 20)
              + " glTF, which is the limit");
    }
  }

  /** Sets an array of numbers. */
  static void numbers(ObjectNode in, String name, double... values) {
    ArrayNode list = in.putArray(name);
    for (double value : values) {
      list.add(finite(value));
    }
  }

  /** Returns the value, or 0 for one that JSON cannot hold. */
  static double finite(double value) {
    return Double.isFinite(value) ? value : 0;
  }

  /**
   * Adds an accessor of tuples of floats.
   *
   * @param type {@code SCALAR}, {@code VEC2}, {@code VEC3} or {@code VEC4}
   * @param bounded whether the accessor tells the least and the largest values
   */
  int floats(float[] values, String type, boolean bounded, Target target) throws IOException {
    int components = type.equals("SCALAR") ? 1 : type.charAt(3) - '0';
    ByteBuffer bytes = reserve((long) Float.BYTES * values.length);
    bytes.asFloatBuffer().put(values);
    ObjectNode accessor = accessor(FLOAT, values.length / components, type, bytes, target);
    if (bounded) {
      double[] least = new double[components];
      double[] most = new double[components];
      Arrays.fill(least, Double.POSITIVE_INFINITY);
      Arrays.fill(most, Double.NEGATIVE_INFINITY);
      for (int i = 0; i < values.length; i++) {
        least[i % components] = Math.min(least[i % components], values[i]);
        most[i % components] = Math.max(most[i % components], values[i]);
      }
      numbers(accessor, "min", least);
      numbers(accessor, "max", most);
    }
    return add("accessors", accessor);
  }

  /** Adds an accessor of vertex indices. */
  int indices(int[] values) throws IOException {
    ByteBuffer bytes = reserve((long) Integer.BYTES * values.length);
    bytes.asIntBuffer().put(values);
    return add("accessors", accessor(UNSIGNED_INT, values.length, "SCALAR", bytes, Target.INDICES));
  }

  private ObjectNode accessor(int type, int count, String tuple, ByteBuffer bytes, Target target) {
    return object()
        .put("bufferView", view(bytes, target))
        .put("componentType", type)
        .put("count", count)
        .put("type", tuple);
  }

  /** Adds bytes, such as those of an image, and returns the index of their buffer view. */
  int bytes(byte[] content) throws IOException {
    return view(reserve(content.length).put(content).flip(), Target.OTHER);
  }

  private int view(ByteBuffer bytes, Target target) {
    ObjectNode view =
        object()
            .put("buffer", 0)
            .put("byteOffset", bytes.arrayOffset())
            .put("byteLength", bytes.limit());
    if (target != Target.OTHER) {
      view.put("target", target.code);
    }
    return add("bufferViews", view);
  }

  /** Returns the next bytes of the buffer, aligned to 4. */
  private ByteBuffer reserve(long count) throws IOException {
    long end = size + count;
    if (end + 3 > maxBytes) {
      throw new IOException(
          "the scene needs more than %d MiB of vertices and images in glTF, which is the limit"
              .formatted(maxBytes >> 20));
    }
    if (end + 3 > buffer.length) {
      buffer = Arrays.copyOf(buffer, (int) Math.min(maxBytes, 2 * (end + 3)));
    }
    ByteBuffer bytes =
        ByteBuffer.wrap(buffer, size, (int) count).slice().order(ByteOrder.LITTLE_ENDIAN);
    size = (int) (end + 3 & ~3L);
    return bytes;
  }

  /** Returns the binary form: a header, the JSON and the buffer. */
  byte[] glb() throws JsonProcessingException {
    finish("");
    byte[] text = new ObjectMapper().writeValueAsBytes(root);
    int textSize = text.length + 3 & ~3;
    int total = 12 + 8 + textSize + (size > 0 ? 8 + size : 0);
    ByteBuffer out = ByteBuffer.allocate(total).order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(GLB_MAGIC).putInt(2).putInt(total);
    out.putInt(textSize).putInt(JSON_CHUNK).put(text);
    while (out.position() < 20 + textSize) {
      out.put((byte) ' ');
    }
    if (size > 0) {
      out.putInt(size).putInt(BINARY_CHUNK).put(buffer, 0, size);
    }
    return out.array();
  }

  /** Returns the text form, with the buffer as a {@code data:} url. */
  byte[] gltf() throws JsonProcessingException {
    finish(URL);
    byte[] text = new ObjectMapper().writeValueAsBytes(root);
    int encoded = (size + 2) / 3 * 4;
    ByteBuffer out = ByteBuffer.allocate(text.length + encoded + 1);
    int split = size > 0 ? endOfUrl(text) : text.length;
    out.put(text, 0, split);
    for (int at = 0; at < size; at += ENCODED_AT_ONCE) {
      int end = Math.min(size, at + ENCODED_AT_ONCE);
      out.put(Base64.getEncoder().encode(Arrays.copyOfRange(buffer, at, end)));
    }
    return out.put(text, split, text.length - split).put((byte) '\n').array();
  }

  /**
   * Returns the index after the url of the buffer, whose quotes no string of the scene can have.
   */
  private static int endOfUrl(byte[] text) {
    byte[] url = ("\"uri\":\"" + URL).getBytes(StandardCharsets.US_ASCII);
    for (int at = text.length - url.length; at >= 0; at--) {
      if (Arrays.equals(text, at, at + url.length, url, 0, url.length)) {
        return at + url.length;
      }
    }
    throw new IllegalStateException("a document with a buffer has its url");
  }

  private void finish(String url) {
    if (size > 0) {
      ObjectNode only = object().put("byteLength", size);
      if (!url.isEmpty()) {
        only.put("uri", url);
      }
      root.putArray("buffers").add(only);
    }
    if (!extensions.isEmpty()) {
      ArrayNode used = root.putArray("extensionsUsed");
      extensions.forEach(used::add);
    }
  }
}

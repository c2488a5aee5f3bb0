package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.models.scene.NodeTransform;
import org.selectiverenderer.models.scene.XmlText;
import org.selectiverenderer.models.structure.ModelStructureCheck;
import org.selectiverenderer.models.structure.ModelStructureException;
import org.selectiverenderer.x3d.model.ModelFile;
import org.selectiverenderer.x3d.model.ModelFormat;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/** The JSON of a glTF file, and its buffers, which are read when they are first needed. */
final class GltfFile {
  private static final String MESHOPT = "EXT_meshopt_compression";
  private static final int HEADER = 12;
  private static final int CHUNK_HEADER = 8;

  private final ModelFile model;
  private final JsonNode root;
  private final ByteBuffer binary;
  private final Map<Integer, ByteBuffer> buffers = new HashMap<>();
  private final Map<Integer, ByteBuffer> unpacked = new HashMap<>();
  private long left;

  private GltfFile(ModelFile model, JsonNode root, ByteBuffer binary) {
    this.model = model;
    this.root = root;
    this.binary = binary;
    left = model.limits().maxBytes();
  }

  /**
   * Reads a file.
   *
   * @throws OldGltfException if it is glTF 1.0
   * @throws IOException if it is damaged or beyond a limit
   */
  static GltfFile of(ModelFile model) throws IOException {
    try {
      new ModelStructureCheck(model.limits().maxBytes())
          .check(
              ".gltf", new ByteArrayInputStream(model.bytes(), 0, model.length()), model.length());
    } catch (ModelStructureException e) {
      throw new IOException(e.getMessage(), e);
    }
    int start = 0;
    int end = model.length();
    ByteBuffer binary = ByteBuffer.allocate(0);
    if (model.format() == ModelFormat.GLB) {
      ByteBuffer all = ByteBuffer.wrap(model.bytes(), 0, model.length());
      all.order(ByteOrder.LITTLE_ENDIAN);
      if (all.getInt(4) != 2) {
        throw new OldGltfException();
      }
      start = HEADER + CHUNK_HEADER;
      end = start + all.getInt(HEADER); // the structure check has compared it with the length
      if (model.length() - end >= CHUNK_HEADER) {
        int size = Math.min(all.getInt(end), model.length() - end - CHUNK_HEADER);
        binary = all.slice(end + CHUNK_HEADER, Math.max(0, size));
      }
    } else if (model.length() > 2 && (model.bytes()[0] & 0xff) == 0xef) {
      start = 3; // a byte order mark
    }
    JsonNode root = mapper().readTree(model.bytes(), start, end - start);
    if (!root.path("asset").path("version").asText("").startsWith("2.")) {
      throw new OldGltfException();
    }
    return new GltfFile(model, root, binary.order(ByteOrder.LITTLE_ENDIAN));
  }

  private static ObjectMapper mapper() {
    StreamReadConstraints constraints =
        StreamReadConstraints.builder()
            .maxNestingDepth(250)
            .maxStringLength(Integer.MAX_VALUE) // data urls hold whole buffers
            .build();
    return new ObjectMapper(JsonFactory.builder().streamReadConstraints(constraints).build());
  }

  /** Returns the JSON of the file. */
  JsonNode root() {
    return root;
  }

  /**
   * Returns a part by its index in a list of the file, such as a mesh; missing if there is none.
   */
  JsonNode part(String list, int index) {
    JsonNode found = index < 0 ? MissingNode.getInstance() : root.path(list).path(index);
    return found.isObject() ? found : MissingNode.getInstance();
  }

  /** Returns the part to which a member refers; missing if it refers to none. */
  JsonNode referred(JsonNode from, String member, String list) {
    return part(list, index(from, member));
  }

  /** Returns the index that a member has; -1 if there is none. */
  static int index(JsonNode from, String member) {
    JsonNode index = from.path(member);
    return index.canConvertToInt() && index.isIntegralNumber()
        ? Math.max(-1, index.intValue())
        : -1;
  }

  /** Returns the text of a member, without characters that XML forbids (1.0, 2.2). */
  static String text(JsonNode from, String member) {
    return XmlText.of(from.path(member).asText(""));
  }

  /** Returns a number that a member has, if it is finite. */
  static double number(JsonNode from, String member, double otherwise) {
    double value = from.path(member).asDouble(otherwise);
    return Double.isFinite(value) ? value : otherwise;
  }

  /** Returns the numbers of an array; the default if it has not as many, or one is not finite. */
  static double[] numbers(JsonNode from, String member, double... otherwise) {
    JsonNode array = from.path(member);
    if (array.size() != otherwise.length) {
      return otherwise;
    }
    double[] numbers = new double[otherwise.length];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = array.path(i).asDouble(Double.NaN);
      if (!Double.isFinite(numbers[i])) {
        return otherwise;
      }
    }
    return numbers;
  }

  /** Returns the place of a node in its parent. */
  static NodeTransform transform(JsonNode node) {
    if (node.path("matrix").size() == 16) {
      double[] identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
      return NodeTransform.of(numbers(node, "matrix", identity));
    }
    return new NodeTransform(
        numbers(node, "translation", 0, 0, 0),
        NodeTransform.unit(numbers(node, "rotation", 0, 0, 0, 1)),
        numbers(node, "scale", 1, 1, 1),
        false);
  }

  /** Returns the bytes of a bufferView. */
  ByteBuffer view(int index) throws IOException {
    JsonNode view = part("bufferViews", index);
    JsonNode packed = view.path("extensions").path(MESHOPT);
    return packed.isObject() ? unpacked(index, packed) : slice(index, view);
  }

  private ByteBuffer unpacked(int index, JsonNode packed) throws IOException {
    ByteBuffer known = unpacked.get(index);
    if (known == null) {
      String path = "bufferViews[%d].extensions.%s".formatted(index, MESHOPT);
      known = new MeshoptDecoder(packed, path).decode(slice(index, packed), left);
      left -= known.capacity();
      unpacked.put(index, known);
    }
    return known.duplicate().order(ByteOrder.LITTLE_ENDIAN);
  }

  private ByteBuffer slice(int index, JsonNode view) throws IOException {
    ByteBuffer buffer = buffer(index(view, "buffer"));
    long offset = view.path("byteOffset").asLong(0);
    long length = view.path("byteLength").asLong(0);
    if (view.isMissingNode()
        || offset < 0
        || length < 0
        || length > buffer.limit() // a sum of more would be no long
        || offset > buffer.limit() - length) {
      throw new IOException(
          "bufferViews[%d] lies outside of its buffer; the file is damaged or cut off"
              .formatted(index));
    }
    return buffer.slice((int) offset, (int) length).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Returns a buffer. */
  ByteBuffer buffer(int index) throws IOException {
    ByteBuffer known = buffers.get(index);
    if (known == null) {
      known = read(index);
      buffers.put(index, known);
    }
    return known;
  }

  private ByteBuffer read(int index) throws IOException {
    JsonNode buffer = part("buffers", index);
    JsonNode uri = buffer.path("uri");
    if (!uri.isTextual()) {
      return index == 0 ? binary : ByteBuffer.allocate(0);
    }
    UrlContent content = content("buffers[%d].uri".formatted(index), uri.textValue());
    byte[] bytes;
    try {
      bytes = content.bytes((int) Math.min(left, Integer.MAX_VALUE - 16));
    } catch (IOException e) {
      throw new IOException("buffers[%d].uri %s".formatted(index, e.getMessage()), e);
    }
    left -= bytes.length;
    return ByteBuffer.wrap(bytes);
  }

  private Optional<UrlContent> inside(String path, String uri, String shown) throws IOException {
    try {
      return UrlContent.inside(uri, model.base());
    } catch (IOException e) {
      throw new IOException("%s '%s' %s".formatted(path, shown, e.getMessage()), e);
    }
  }

  private UrlContent content(String path, String uri) throws IOException {
    String shown = uri.length() > 80 ? uri.substring(0, 80) + "…" : uri;
    if (model.files().isEmpty()) {
      Optional<UrlContent> inside = inside(path, uri, shown);
      if (inside.isPresent()) {
        return inside.get();
      }
      throw new IOException(
          "%s '%s' is in another file, which is not read here".formatted(path, shown));
    }
    // glTF has no fragments
    UrlResolver.Target target = model.files().get().resolve(uri.replace("#", "%23"), model.base());
    if (target instanceof UrlResolver.Target.Found found) {
      return found.content();
    }
    throw new IOException(
        "%s '%s' %s; nothing is read"
            .formatted(path, shown, ((UrlResolver.Target.Refused) target).reason()));
  }
}

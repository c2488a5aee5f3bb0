package org.selectiverenderer.models.structure;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.models.structure.GltfStructure.Part;

/**
 * Reads the structure of a glTF file from its JSON, as a stream, so that a file of any size takes
 * bounded memory.
 */
final class GltfStructureReader {
  /** The maximum nesting depth of values; those of glTF itself are 10 deep. */
  static final int MAX_DEPTH = 250;

  /** The maximum number of nodes, accessors and so on, and of references to them. */
  private static final int MAX_PARTS = 1_000_000;

  static final String DAMAGED =
      "this is not a glTF model, or it is damaged or cut off; nothing is read";

  /** Stands for larger numbers too; its square is still a long. */
  private static final long MAX_NUMBER = 1L << 31;

  private static final int BYTE_ORDER_MARK = 0xFEFF;

  private final GltfStructure found = new GltfStructure();
  private String version = "";
  private int parts;

  private GltfStructureReader() {}

  /**
   * Reads a text to its end.
   *
   * @throws IOException if it cannot be read
   * @throws ModelStructureException if it is not the JSON of a glTF model, or too large
   */
  static GltfStructure read(InputStream in) throws IOException, ModelStructureException {
    GltfStructureReader reader = new GltfStructureReader();
    reader.json(in);
    return reader.found.of(reader.version);
  }

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
      if (parser.nextToken() != null || !version.matches("[12]\\.\\d+")) {
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
                  version = parser.getValueAsString("");
                }
              });
      case "nodes" -> members(parser, id -> node(parser, id));
      case "scenes" ->
          members(
              parser,
              id -> {
                List<String> roots = new ArrayList<>();
                found.scenes().add(roots);
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
                found.arraysOfMeshes().put(id, arrays);
                arrays(parser, arrays);
              });
      case "animations", "skins" -> members(parser, id -> arrays(parser, found.otherArrays()));
      case "accessors" -> members(parser, id -> part(parser, found.accessors(), id));
      case "bufferViews" -> members(parser, id -> part(parser, found.views(), id));
      case "buffers" -> members(parser, id -> part(parser, found.buffers(), id));
      default -> {
        // not of interest
      }
    }
  }

  private void node(JsonParser parser, String id) throws IOException, ModelStructureException {
    List<String> below = new ArrayList<>();
    List<String> shown = new ArrayList<>();
    count();
    found.children().put(id, below);
    found.meshesOfNodes().put(id, shown);
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
}

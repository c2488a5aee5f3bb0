package org.selectiverenderer.base.json;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import org.selectiverenderer.base.files.InputFile;

/** JSON that programs write for programs, as trees. */
public final class JsonTree {
  static final ObjectMapper MAPPER = new ObjectMapper();

  private JsonTree() {}

  /** A new object to be filled. */
  public static ObjectNode object() {
    return JsonNodeFactory.instance.objectNode();
  }

  /** A text, number or truth value, or a list or map of such, as a tree. */
  public static JsonNode of(Object value) {
    return MAPPER.valueToTree(value);
  }

  /** What is wrong with a text, without the parser's own places. */
  public static String sentence(JsonProcessingException e) {
    return JsonFault.sentence(e);
  }

  /** Reads a text. */
  public static JsonNode parse(String text) throws JsonProcessingException {
    return MAPPER.readTree(text);
  }

  /**
   * Reads a file that is to hold an object.
   *
   * @throws IOException if it cannot be read or holds none, with a message of one line
   */
  public static JsonNode read(Path file) throws IOException {
    try {
      JsonNode json = MAPPER.readTree(InputFile.bytes(file));
      if (!json.isObject()) {
        throw new IOException(file + ": a JSON object {...} is needed");
      }
      return json;
    } catch (JsonProcessingException e) {
      throw new IOException(
          JsonFault.place(file.toString(), e.getLocation())
              + ": is not valid JSON: "
              + JsonFault.sentence(e),
          e);
    }
  }
}

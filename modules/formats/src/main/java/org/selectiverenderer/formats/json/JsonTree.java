package org.selectiverenderer.formats.json;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import org.selectiverenderer.base.files.InputFileReader;

/** Reads and builds JSON trees, for files that programs exchange. */
public final class JsonTree {
  static final ObjectMapper MAPPER = new ObjectMapper();

  private static final ObjectMapper SETTINGS =
      JsonMapper.builder()
          .enable(JsonReadFeature.ALLOW_JAVA_COMMENTS)
          .enable(JsonReadFeature.ALLOW_TRAILING_COMMA)
          .build();

  private JsonTree() {}

  /** Returns a new empty object. */
  public static ObjectNode object() {
    return JsonNodeFactory.instance.objectNode();
  }

  /** Converts a string, number or boolean, or a list or map of these, to a tree. */
  public static JsonNode of(Object value) {
    return MAPPER.valueToTree(value);
  }

  /** Returns the parser's error message without the locations in it. */
  public static String sentence(JsonProcessingException e) {
    return JsonErrorReporter.sentence(e);
  }

  /** Parses a text. */
  public static JsonNode parse(String text) throws JsonProcessingException {
    return MAPPER.readTree(text);
  }

  /** Parses the text of a settings file, which may have comments and last commas. */
  public static JsonNode parseSettings(String text) throws JsonProcessingException {
    return SETTINGS.readTree(text);
  }

  /**
   * Reads a file that should hold a JSON object.
   *
   * @throws IOException if it cannot be read or holds no object, with a one-line message
   */
  public static JsonNode read(Path file) throws IOException {
    try {
      JsonNode json = MAPPER.readTree(InputFileReader.bytes(file));
      if (!json.isObject()) {
        throw new IOException(file + ": a JSON object {...} is needed");
      }
      return json;
    } catch (JsonProcessingException e) {
      throw new IOException(
          JsonErrorReporter.place(file.toString(), e.getLocation())
              + ": is not valid JSON: "
              + JsonErrorReporter.sentence(e),
          e);
    }
  }
}

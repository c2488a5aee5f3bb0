package org.selectiverenderer.validation;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads the JSON files that a user names. */
final class JsonFile {
  private JsonFile() {}

  /**
   * Reads a file.
   *
   * @throws IOException if it cannot be read or is no JSON, with a message of one line
   */
  static JsonNode read(Path file) throws IOException {
    byte[] bytes = Files.readAllBytes(file);
    try {
      JsonNode json = JsonMapper.builder().build().readTree(bytes);
      if (!json.isObject()) {
        throw new IOException(file + ": a JSON object {...} is needed");
      }
      return json;
    } catch (JsonProcessingException e) {
      throw new IOException(
          "%s:%d:%d: is no JSON: %s"
              .formatted(
                  file,
                  e.getLocation() == null ? 1 : e.getLocation().getLineNr(),
                  e.getLocation() == null ? 1 : e.getLocation().getColumnNr(),
                  e.getOriginalMessage()),
          e);
    }
  }
}

package org.selectiverenderer.formats.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class JsonWriterTest {
  @TempDir Path folder;

  private static ObjectNode tree() {
    ObjectNode tree = JsonTree.object();
    tree.put("t", 0.1).put("none", (String) null).putArray("list").add(1).add("ä\n");
    tree.putObject("empty");
    return tree;
  }

  @Test
  void aTreeHasItsListsInLines() {
    assertThat(JsonWriter.of(tree()))
        .isEqualTo(
            """
            {
              "t" : 0.1,
              "none" : null,
              "list" : [ 1, "ä\\n" ],
              "empty" : { }
            }
            """);
  }

  @Test
  void whatIsTooLongForATreeHasALineForEachValue() {
    assertThat(
            JsonWriter.of(
                json -> {
                  json.writeStartArray();
                  json.writeNumber(1);
                  json.writeNumber(2);
                  json.writeEndArray();
                }))
        .isEqualTo("[\n  1,\n  2\n]\n");
  }

  @Test
  void whatAProgramWroteIsReadWhateverElseItSays() throws IOException {
    Path file = Files.writeString(folder.resolve("a.json"), JsonWriter.of(tree()));

    assertThat(JsonTree.read(file)).isEqualTo(JsonTree.parse(tree().toString()));
  }

  @Test
  void aFileThatIsNoJsonIsToldInOneLine() throws IOException {
    Path file = Files.writeString(folder.resolve("a.json"), "{\n \"a\": [");

    assertThatThrownBy(() -> JsonTree.read(file))
        .hasMessageStartingWith(file + ":2:")
        .hasMessageContaining("is not valid JSON: Unexpected end-of-input")
        .hasMessageNotContaining("Source");
    Files.writeString(file, "[]");
    assertThatThrownBy(() -> JsonTree.read(file))
        .hasMessage(file + ": a JSON object {...} is needed");
  }
}

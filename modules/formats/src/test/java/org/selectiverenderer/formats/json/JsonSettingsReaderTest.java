package org.selectiverenderer.formats.json;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;

/** The policy for every file that a person writes. */
class JsonSettingsReaderTest {
  private static final JsonSettingsReader ROOM =
      new JsonSettingsReader("a room", "the room is not used");

  @TempDir Path folder;
  private final ProblemCollector problems = new ProblemCollector();

  private record Room(String name, double height, List<String> doors) {}

  private static Room room(JsonObjectReader room) {
    double height =
        room.object("size", "the size", size -> size.number("height", 1, 9, 2.5)).orElse(0.0);
    return new Room(room.text("name"), height, room.texts("doors"));
  }

  private Optional<Room> parse(String text) {
    return ROOM.parse("room.json", text, problems, JsonSettingsReaderTest::room);
  }

  private List<String> faults(String text) {
    assertThat(parse(text)).isEmpty();
    return problems.list().stream().map(Problem::toString).toList();
  }

  @Test
  void commentsACommaTooManyAndAMarkAtTheBeginningDoNoHarm() {
    assertThat(
            parse(
                """
                \uFEFF{ // ours
                  "$schema": "room.schema.json", "name": "Office", /* metres */
                  "size": {"height": 3}, "doors": ["a", "b",],
                }\
                """))
        .contains(new Room("Office", 3, List.of("a", "b")));
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void nullIsAsIfTheKeyWereLeftOut() {
    assertThat(parse("{\"name\": \"Office\", \"size\": {\"height\": null}, \"doors\": null}"))
        .contains(new Room("Office", 2.5, List.of()));
  }

  @Test
  void allFaultsAreToldAtOnceEachAtItsPlace() {
    assertThat(
            faults(
                """
                {"nmae": "Office",
                 "size": {"height": "tall", "depth": 1},
                 "doors": ["a", 2]}\
                """))
        .containsExactly(
            "room.json:2:21: \"height\" must be a number from 1 to 9; the room is not used",
            "room.json:2:29: the size has no \"depth\" (known keys: height); the room is not used",
            "room.json:1:1: a room needs \"name\"; the room is not used",
            "room.json:3:17: \"doors\" must be a list of texts in quotes; the room "
                + "is not used",
            "room.json:1:2: a room has no \"nmae\"; did you mean \"name\"? The room is not used");
  }

  @Test
  void whatIsNoJsonIsToldWithoutTheParsersInnerLife() {
    assertThat(faults("{\"name\": [")).hasSize(1);
    assertThat(problems.list().get(0).toString())
        .startsWith("room.json:1:11: this is not valid JSON: Unexpected end-of-input")
        .doesNotContain("Source", "start marker");
  }

  @Test
  void aTextAfterTheEndIsAFault() {
    assertThat(faults("{\"name\": \"Office\"}\n}"))
        .containsExactly(
            "room.json:2:1: this is not valid JSON: Unexpected close marker '}': no "
                + "open Object to close; the room is not used");
  }

  @Test
  void twoObjectsAreAFault() {
    assertThat(faults("{\"name\": \"Office\"} {}"))
        .containsExactly(
            "room.json:1:20: there is text after the end of a room; the room is not used");
  }

  @Test
  void aKeyThatIsThereTwiceIsAFault() {
    assertThat(faults("{\"name\": \"a\",\n \"name\": \"b\"}"))
        .singleElement()
        .asString()
        .startsWith("room.json:2:")
        .contains("Duplicate field 'name'");
  }

  @Test
  void anEmptyFileAndAListAreFaults() {
    assertThat(faults("")).containsExactly("room.json: the file is empty; the room is not used");
    assertThat(faults("[]"))
        .contains("room.json:1:1: a room must be an object in braces; the room is not used");
  }

  @Test
  void anotherEncodingIsAFault() throws IOException {
    Path file = folder.resolve("room.json");
    Files.writeString(file, "{\"name\": \"Büro\"}", StandardCharsets.ISO_8859_1);

    assertThat(ROOM.read(file, problems, JsonSettingsReaderTest::room)).isEmpty();

    assertThat(problems.list())
        .singleElement()
        .hasToString(file + ":1:1: the file is not UTF-8 text; the room is not used");
  }
}

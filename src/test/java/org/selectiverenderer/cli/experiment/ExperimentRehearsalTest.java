package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;

/** A study is checked, planned and previewed before anybody comes. */
class ExperimentRehearsalTest extends CommandTestCase {
  private static final String TRIALS =
      """
      {"name": "Changes", "scene": "room.x3d", "participants": 4, "seed": 3,
       "factors": [{"name": "quality", "varies": "within", "levels": [
         {"name": "full", "condition": "high"}, {"name": "reduced", "condition": "high-low"}]}],
       "blocks": [{"name": "main", "stimuli": "changes.csv", "order": "latin-square",
         "viewpoint": "Door",
         "trial": [{"show": "exposure", "seconds": 3, "choices": {"{object}": 1}},
                   {"show": "questions", "questionnaire": "what"}]}],
       "questionnaires": [{"file": "what.json", "when": "in-trials", "name": "what"}]}
      """;

  private static final String AREAS =
      """
      {"name": "Rooms", "scene": "room.x3d", "conditions": ["high", "selective"],
       "participants": 4,
       "areas": [{"name": "hall", "viewpoint": "Door", "seconds": 60}],
       "questionnaires": [{"kind": "recognition", "items": "items.csv"}]}
      """;

  @TempDir Path folder;

  @BeforeEach
  void files() throws IOException {
    write(
        "room.x3d",
        "<X3D><Scene><Viewpoint DEF='Door'/><Inline url='\"lamps.x3d\"'/>"
            + "<Switch DEF='Lamp'><Shape><Box/></Shape><Shape><Sphere/></Shape></Switch>"
            + "</Scene></X3D>");
    write("lamps.x3d", "<X3D><Scene><Group DEF='Candle'/><Viewpoint DEF='Window'/></Scene></X3D>");
    write("changes.csv", "object,kind\nLamp,near\nLamp,far\n");
    write(
        "what.json",
        """
        {"name": "what", "pages": [{"questions": [
          {"id": "saw", "kind": "yes-no", "text": "Did something change?"}]}]}
        """);
    write(
        "items.csv",
        "area,object,consistency,present,scene_object,en\n"
            + "hall,candle,consistent,yes,Candle,candle\n"
            + "hall,violin,inconsistent,no,,violin\n");
    write("study.json", TRIALS);
  }

  private void write(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  private String study() {
    return folder.resolve("study.json").toString();
  }

  private String file(String name) {
    return folder.resolve(name).toString();
  }

  @Test
  void aSoundStudyIsSound() {
    assertThat(execute("experiment", "check", study())).as(messages()).isZero();
    assertThat(printed())
        .contains("the study is sound", "balanced over the places", "place 1 is next")
        .contains("main, high, room.x3d, from Door, Lamp = 1");
    assertThat(messages()).isEmpty();
  }

  @Test
  void audioThatIsMissingOrCannotBePlayedIsFoundInEachLanguage() throws IOException {
    write(
        "study.json",
        """
        {"name": "Heard", "conditions": ["high"], "participants": 2, "scene": "room.x3d",
         "languages": ["en", "el"], "blocks": [{"name": "b", "trial": [
          {"show": "instruction", "text": {"en": "Look.", "el": "Κοιτάξτε."},
           "audio": {"en": "look.wav", "el": "look-el.wav"}}]}],
         "questionnaires": [{"file": "heard.json"}]}
        """);
    write(
        "heard.json",
        "{\"name\": \"heard\", \"pages\": [{\"text\": \"Listen.\", \"audio\": \"page.mp3\"}]}");
    write("look.wav", "no sound");
    assertThat(execute("experiment", "check", study())).isEqualTo(1);
    assertThat(messages())
        .contains("study.json:4:", "there is no file 'look-el.wav' relative to the study file")
        .contains("heard.json:1:", "there is no file 'page.mp3' relative to the questionnaire");
    write("look-el.wav", "no sound");
    write("page.mp3", "no sound");
    assertThat(execute("experiment", "check", study())).isEqualTo(1);
    assertThat(messages())
        .contains(
            file("look.wav") + ": the audio has a format that cannot be played",
            file("look-el.wav") + ": the audio has",
            file("page.mp3") + ": the audio has");
    write("heard.json", "{\"name\": \"h\", \"pages\": [{\"text\": \"a\", \"audio\": \"a.txt\"}]}");
    assertThat(execute("experiment", "check", study())).isEqualTo(1);
    assertThat(messages()).contains("an audio must be a WAV, AIFF, AU or MP3 file");
  }

  @Test
  void aSwitchThatIsNotThereIsFoundWithTheLineOfItsStimulus() throws IOException {
    write("changes.csv", "object,kind\nLamp,near\n\"Lamp's\",far\n");
    assertThat(execute("experiment", "check", study())).isEqualTo(1);
    assertThat(messages()).contains("'Lamp's'");
  }

  @Test
  void aChoiceThatASwitchDoesNotHaveIsFoundWithItsPlace() throws IOException {
    write("study.json", TRIALS.replace("\"{object}\": 1", "\"{object}\": 2"));
    assertThat(execute("experiment", "check", study())).isEqualTo(1);
    assertThat(messages()).contains("changes.csv:2:1: the Switch Lamp").contains("sets 2");
  }

  @Test
  void objectsOfMemoryListsAreThereOrNotAsTheListSays() throws IOException {
    write("study.json", AREAS);
    assertThat(execute("experiment", "check", study())).as(messages()).isZero();

    write(
        "items.csv",
        "area,object,consistency,present,scene_object,en\n"
            + "hall,candle,consistent,yes,Candel,candle\nhall,lamp,neutral,no,Lamp,lamp\n");
    assertThat(execute("experiment", "check", study())).isEqualTo(1);
    assertThat(messages())
        .contains("items.csv:2:", "no node with the DEF 'Candel'; did you mean 'Candle'?")
        .contains("items.csv:3:", "lamp is listed as absent, but the scene has the object Lamp");
  }

  @Test
  void aMissingInlineIsFound() throws IOException {
    Files.delete(folder.resolve("lamps.x3d"));
    assertThat(execute("experiment", "check", study())).isEqualTo(1);
    assertThat(messages()).contains("room.x3d:1:", "lamps.x3d");
  }

  @Test
  void findingsAreJsonAndAPage() throws IOException {
    write("study.json", TRIALS.replace("\"participants\": 4", "\"participants\": \"four\""));
    assertThat(
            execute("experiment", "check", study(), "--format", "json", "--output", file("c.html")))
        .isEqualTo(1);
    assertThat(printed()).contains("\"sound\" : false", "\"line\" : 1");
    assertThat(Files.readString(folder.resolve("c.html"))).contains("study.json:1:");
  }

  @Test
  void aStudyThatIsNotThereIsAFailure() {
    assertThat(execute("experiment", "check", file("none.json"))).isEqualTo(2);
  }

  @Test
  void thePlanHasTheOrderOfEachParticipantAndIsTheSameAgain() throws IOException {
    assertThat(execute("experiment", "plan", study(), "--format", "csv")).isZero();
    String first = printed();
    assertThat(first.lines()).hasSize(1 + 4 * 4);
    assertThat(first).contains("\n1,,yes,all,main,1,").contains("quality=full");
    execute("experiment", "plan", study(), "--format", "csv");
    assertThat(printed()).isEqualTo(first);
  }

  @Test
  void whoHasAPlaceIsNamedAndTheNextOneFollows() throws IOException {
    write(
        "participants.tsv",
        "participant_id\tcondition\tplace\tassigned_by\tinstead_of\tage\tsimulated\n"
            + "sub-007\tall\t1\tschedule\tn/a\tn/a\tfalse\n");
    assertThat(execute("experiment", "plan", study(), "--participants", "2")).isZero();
    assertThat(printed()).contains("place 2 is next", "sub-007");
  }

  @Test
  void thePictureOfThePlanIsInItsPage() throws IOException {
    assertThat(execute("experiment", "plan", study(), "--format", "html")).isZero();
    assertThat(printed()).contains("<svg", ">full<", ">reduced<", "directly after");
  }

  @Test
  void thePreviewHasAllScreensAndWritesNothingElse() throws IOException {
    Path out = folder.resolveSibling(folder.getFileName() + "-preview");
    assertThat(execute("experiment", "preview", study(), "--output", out.toString())).isZero();
    assertThat(Files.readString(out.resolve("index.html")))
        .contains("PREVIEW", "Did something change?", "Lamp = 1", "<h2>form</h2>");
    try (var files = Files.list(folder)) {
      assertThat(files.filter(Files::isDirectory)).isEmpty();
    }
  }

  @Test
  void aStepThatIsNotThereIsWrongUsage() {
    assertThat(execute("experiment", "preview", study())).isEqualTo(2);
    assertThat(messages()).contains("--output");
    assertThat(execute("experiment", "preview", study(), "--from", "x", "--open")).isEqualTo(2);
  }
}

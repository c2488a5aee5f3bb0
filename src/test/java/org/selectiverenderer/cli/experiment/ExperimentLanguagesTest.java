package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.testing.ShowsWindows;

/** Two participants of one study in two languages. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class ExperimentLanguagesTest extends CommandTestCase {
  @TempDir Path folder;
  private String study = "";

  @BeforeEach
  void write() throws IOException {
    Files.writeString(
        folder.resolve("mood.json"),
        """
        {"name": "mood", "pages": [{"questions": [
          {"id": "calm", "kind": "scale", "from": 1, "to": 3,
           "text": {"en": "How calm are you?", "el": "Πόσο ήρεμος είστε;"}}]}]}
        """);
    Files.writeString(
        folder.resolve("white.x3d"),
        """
        <X3D version='4.0' profile='Immersive'><Scene>
        <Viewpoint DEF='Here'/><Shape><Sphere radius='0.1'/></Shape>
        </Scene></X3D>
        """);
    Path file = folder.resolve("study.json");
    Files.writeString(
        file,
        """
        {"name": "Two", "conditions": ["high"], "participants": 2, "scene": "white.x3d", "languages": ["en", "el"],
         "blocks": [{"name": "b", "trial": [
           {"show": "instruction", "text": {"en": "Look.", "el": "Κοιτάξτε."}},
           {"show": "blank", "seconds": 0.01}]}],
         "questionnaires": [{"file": "mood.json"}]}
        """);
    study = file.toString();
  }

  private int run(String... more) {
    String[] all = new String[more.length + 4];
    all[0] = "experiment";
    all[1] = "run";
    all[2] = study;
    all[3] = "--unattended";
    System.arraycopy(more, 0, all, 4, more.length);
    return execute(all);
  }

  private String journal(String participant) throws IOException {
    return Files.readString(folder.resolve("sub-" + participant + "/ses-01/events.jsonl"));
  }

  @Test
  void eachParticipantHasALanguageThatIsKeptAndStored() throws IOException {
    assertThat(run("--participant", "1")).as(messages()).isZero();
    assertThat(run("--participant", "2", "--language", "el")).as(messages()).isZero();
    assertThat(journal("1")).contains("\"language\":\"en\"").doesNotContain("\"language\":\"el\"");
    assertThat(journal("2")).contains("\"language\":\"el\"").doesNotContain("\"language\":\"en\"");
    // A further session is in the participant's language without being told.
    assertThat(run("--participant", "2", "--session", "2")).as(messages()).isZero();
    assertThat(Files.readString(folder.resolve("sub-2/ses-02/events.jsonl")))
        .contains("\"language\":\"el\"");
    Path tables = folder.resolve("tables");
    execute("experiment", "export", study, "--output", tables.toString());
    assertThat(Files.readString(tables.resolve("sessions.csv")).lines().toList())
        .satisfies(
            lines -> {
              assertThat(lines.get(0)).contains(",condition,language,outcome,");
              assertThat(lines.get(1)).contains(",high,en,finished,");
              assertThat(lines.get(2)).contains(",high,el,finished,");
            });
    assertThat(run("--participant", "1", "--session", "2", "--language", "fr")).isEqualTo(1);
    assertThat(messages()).contains("the study has no language 'fr', only en, el");
    assertThat(folder.resolve("sub-1/ses-02")).doesNotExist();
  }

  @Test
  void trialsWithoutASceneAreRefusedBeforeAnythingBegins() throws IOException {
    Path file = Path.of(study);
    Files.writeString(file, Files.readString(file).replace("\"scene\": \"white.x3d\", ", ""));
    assertThat(execute("experiment", "check", study)).isEqualTo(1);
    assertThat(messages()).contains("the block b has trials without a scene");
    assertThat(run("--participant", "1")).isEqualTo(2);
    assertThat(messages()).contains("the block b has trials without a scene", "nothing has begun");
    assertThat(folder.resolve("sub-1")).doesNotExist();
  }

  @Test
  void previewAndPaperAreInTheLanguages() throws IOException {
    Path page = folder.resolve("out/index.html");
    assertThat(execute("experiment", "preview", study, "--output", page.getParent().toString()))
        .as(messages())
        .isZero();
    assertThat(Files.readString(page))
        .contains("<section id=\"en\"", "<section id=\"el\"", "Look.", "Κοιτάξτε.")
        .contains("How calm are you?", "Πόσο ήρεμος είστε;");
    assertThat(execute("experiment", "paper", study, "--participant", "2", "--language", "el"))
        .isZero();
    assertThat(text(out)).contains("Πόσο ήρεμος είστε;").doesNotContain("How calm are you?");
    assertThat(execute("experiment", "check", study)).as(messages()).isZero();
    assertThat(text(out)).contains("languages, the first unless --language: en, el");
  }
}

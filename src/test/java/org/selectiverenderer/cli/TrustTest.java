package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.files.SettingsFolder;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.base.trust.TrustStore;
import org.selectiverenderer.study.definition.StudyPermissions;
import org.selectiverenderer.study.definition.StudyReader;

/** What a study or a settings file of somebody else may do where nobody can be asked. */
class TrustTest extends CommandTestCase {
  private static final String SCENE =
      "<X3D version='4.0' profile='Immersive'><Scene><Viewpoint DEF='Here'/></Scene></X3D>";

  @TempDir private Path folder;
  private Path study;

  @BeforeEach
  void files() throws IOException {
    study = Files.createDirectories(folder.resolve("sent")).resolve("study.json");
    Files.writeString(folder.resolve("sent/a.x3d"), SCENE);
    Files.writeString(
        folder.resolve("form.json"),
        "{\"name\": \"secret\", \"pages\": [{\"text\": \"a secret\"}]}");
    study("\"form\": \"../form.json\"");
  }

  private void study(String keys) throws IOException {
    Files.writeString(
        study,
        """
        {"name": "Sent", "scene": "a.x3d", "conditions": ["high"], "participants": 4,
         "areas": [{"name": "hall", "viewpoint": "Here", "seconds": 1}], %s}
        """
            .formatted(keys));
  }

  private int paper(String... more) {
    String[] args = new String[5 + more.length];
    System.arraycopy(
        new String[] {"experiment", "paper", study.toString(), "--participant", "001"},
        0,
        args,
        0,
        5);
    System.arraycopy(more, 0, args, 5, more.length);
    return execute(args);
  }

  @Test
  void whereNobodyCanBeAskedTheLineToTypeIsSaid() throws IOException {
    assertThat(paper()).isEqualTo(2);
    assertThat(printed()).isEmpty();
    assertThat(messages().lines()).hasSize(1);
    assertThat(messages())
        .contains(
            "%s asks for more than its own folder: \"form\" reads %s"
                .formatted(study, folder.toRealPath().resolve("form.json")))
        .endsWith("experiment paper %s --participant 001 --trust\n".formatted(study));
    assertThat(paper("--trust")).isZero();
    assertThat(printed()).contains("a secret");
    assertThat(paper()).as("--trust holds once").isEqualTo(2);
  }

  @Test
  void whatTheUserHasAgreedToIsNotAskedAgainUntilItChanges() throws IOException {
    PermissionRequests asked =
        StudyPermissions.of(StudyReader.read(study, new ProblemCollector()).orElseThrow());
    new TrustStore(SettingsFolder.ofUser()).remember(asked);
    assertThat(paper()).as(messages()).isZero();
    study("\"fade\": 3, \"form\": \"../form.json\"");
    assertThat(paper()).as(messages()).isZero();
    study("\"allow\": [\"/\"], \"form\": \"../form.json\"");
    assertThat(paper()).isEqualTo(2);
    assertThat(messages())
        .contains("\"allow\" lets scenes read every file in and below " + folder.getRoot());
  }

  @Test
  void whatACommandDoesNotUseIsNotAskedFor() throws IOException {
    study("\"tracker\": \"tcp:10.0.0.1:25\", \"allowNet\": [\"example.org\"]");
    assertThat(paper()).as(messages()).isZero();
    assertThat(execute("experiment", "status", study.toString())).as(messages()).isZero();
  }

  @Test
  void anUnattendedSessionIsRefusedBeforeAnythingIsOpened() throws IOException {
    study("\"tracker\": \"tcp:127.0.0.1:9\", \"streams\": {\"lsl\": true}");
    int status = execute("experiment", "run", study.toString(), "--unattended");
    assertThat(status).isEqualTo(2);
    if (!messages().contains("a session needs windows")) {
      assertThat(messages())
          .contains("\"tracker\" connects to tcp:127.0.0.1:9", "\"lsl\" sends", "--trust");
    }
    assertThat(folder.resolve("sent/sub-001")).doesNotExist();
  }

  @Test
  void aNewStudyIsTheUsersOwn() throws IOException {
    Path scene = Files.writeString(folder.resolve("rooms.x3d"), SCENE);
    Files.writeString(folder.resolve("practice.x3d"), SCENE);
    for (String def : new String[] {"KitchenMiddle", "LoungeMiddle", "OfficeMiddle", "StartView"}) {
      for (Path each : new Path[] {scene, folder.resolve("practice.x3d")}) {
        Files.writeString(
            each,
            Files.readString(each).replace("</Scene>", "<Viewpoint DEF='" + def + "'/></Scene>"));
      }
    }
    Path mine = folder.resolve("mine");
    assertThat(execute("experiment", "new", mine.toString(), "--scene", scene.toString())).isZero();
    assertThat(execute("experiment", "status", mine.toString())).as(messages()).isZero();
    PermissionRequests asked =
        StudyPermissions.of(
            StudyReader.read(mine.resolve("study.json"), new ProblemCollector()).orElseThrow());
    assertThat(asked.lines()).isNotEmpty();
    assertThat(new TrustStore(SettingsFolder.ofUser()).remembers(asked)).isTrue();
  }

  @Test
  void theValidatorsSettingsOpenNothingOutsideUnasked() throws IOException {
    Path settings =
        Files.writeString(
            folder.resolve("sent/v.json"), "{\"allow\": [\"..\"], \"allowNet\": [\"a.org\"]}");
    String scene = folder.resolve("sent/a.x3d").toString();
    assertThat(execute("validate", scene, "--config", settings.toString())).isEqualTo(2);
    assertThat(messages())
        .contains(
            settings + " asks for more than its own folder: \"allow\" lets",
            "\"allowNet\" lets scenes fetch files from a.org")
        .endsWith("validate %s --config %s --trust\n".formatted(scene, settings));
    assertThat(execute("validate", scene, "--config", settings.toString(), "--trust"))
        .as(messages())
        .isZero();
    assertThat(execute("validate", "--config", settings.toString(), "--", scene)).isEqualTo(2);
    assertThat(messages()).endsWith("--config %s --trust -- %s\n".formatted(settings, scene));
  }
}

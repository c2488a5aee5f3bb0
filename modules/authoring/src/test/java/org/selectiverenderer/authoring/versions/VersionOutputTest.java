package org.selectiverenderer.authoring.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/** Files that another scene shows stay as they are when versions are written for one more. */
class VersionOutputTest extends VaseScene {
  private static final SimplificationTarget HALF = new SimplificationTarget.VertexPercent(50);
  private static final SimplificationTarget TENTH = new SimplificationTarget.VertexPercent(10);

  private void write(Path scene, String output, SimplificationTarget... goals) throws IOException {
    plan(new VersionsEdit.Request(
            scene, "Vase", List.of(goals), folder.resolve(output), "inlineNodes"))
        .orElseThrow()
        .write();
  }

  /** Everything that was there is as it was. */
  private void assertKept(Map<Path, String> before) throws IOException {
    assertThat(files()).containsAllEntriesOf(before);
  }

  @Test
  void anotherOutputGetsFilesOfItsOwnWhereTheScenesOwnWouldChange() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", HALF);
    Map<Path, String> before = files();

    write(scene, "other.x3d", TENTH);

    assertKept(before);
    assertThat(Files.readString(folder.resolve("other.x3d")))
        .contains("\"inlineNodes/Vase_v1.x3d\"", "\"inlineNodes/Vase2_v2.x3d\"")
        .doesNotContain("inlineNodes/Vase_v2");
    assertThat(polygons("inlineNodes/Vase2_v2.x3d"))
        .isLessThan(polygons("inlineNodes/Vase_v2.x3d"));
    assertThat(problems.list().toString()).contains("scene.x3d", "Vase2_v2.x3d");
  }

  @Test
  void anotherOutputHasTheSameFilesWhereTheirContentIsTheSame() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", HALF, TENTH);
    Map<Path, String> before = files();

    write(scene, "other.x3d", HALF, TENTH);

    assertKept(before);
    assertThat(files()).hasSize(before.size() + 1);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void twoOutputsOfASceneWithoutVersionsDoNotShareWhatDiffers() throws IOException {
    Path scene = scene(SCENE);
    write(scene, "half.x3d", HALF);
    Map<Path, String> before = files();

    write(scene, "tenth.x3d", TENTH);

    assertKept(before);
    assertThat(Files.readString(folder.resolve("tenth.x3d")))
        .contains("\"inlineNodes/Vase2_v1.x3d\"", "\"inlineNodes/Vase2_v2.x3d\"");
  }

  @Test
  void anOutputThatIsWrittenAgainKeepsItsNames() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", HALF);
    write(scene, "other.x3d", TENTH);
    int count = files().size();

    write(scene, "other.x3d", new SimplificationTarget.VertexPercent(20));

    assertThat(files()).hasSize(count);
    assertThat(Files.readString(folder.resolve("other.x3d"))).contains("inlineNodes/Vase2_v2.x3d");
  }

  @Test
  void aSceneChangedInPlaceLeavesWhatItsCopyShows() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", HALF);
    Files.copy(scene, folder.resolve("copy.x3d"));
    Map<Path, String> before = files();
    before.remove(scene);

    make(scene, "Vase", TENTH);

    assertKept(before);
    assertThat(Files.readString(scene)).contains("inlineNodes/Vase2_v2.x3d");
  }

  @Test
  void aCopyThatSpellsItsUrlsWithBackslashesKeepsItsFiles() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", HALF);
    Files.writeString(
        folder.resolve("copy.x3d"),
        Files.readString(scene).replace("inlineNodes/", "inlineNodes\\"));
    Map<Path, String> before = files();
    before.remove(scene);

    make(scene, "Vase", TENTH);

    assertKept(before);
  }

  @Test
  void anotherFolderIsNotWrittenOverEither() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", HALF);
    write(scene, "copy/one.x3d", HALF);
    Map<Path, String> before = files();

    write(scene, "copy/two.x3d", TENTH);

    assertKept(before);
    assertThat(Files.readString(folder.resolve("copy/two.x3d")))
        .contains("inlineNodes/Vase_v1.x3d", "inlineNodes/Vase2_v2.x3d");
  }

  @Test
  void whatIsCopiedByHandIntoAnotherFolderStays() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", HALF);
    Files.createDirectories(folder.resolve("copy/inlineNodes"));
    Path own = Files.writeString(folder.resolve("copy/inlineNodes/Vase_v2.x3d"), "<X3D/>");

    write(scene, "copy/one.x3d", TENTH);

    assertThat(own).hasContent("<X3D/>");
    assertThat(Files.readString(folder.resolve("copy/one.x3d")))
        .contains("inlineNodes/Vase2_v2.x3d");
  }

  @Test
  void undoingInTheEnricherRestoresTheFilesOfTheScene() throws IOException {
    Path scene = scene(SCENE);
    make(scene, "Vase", HALF);
    Map<Path, String> before = files();
    SceneDocument document = DocumentFile.open(scene).document();

    plan(scene, "Vase", TENTH).orElseThrow().apply(document);
    assertThat(files().get(folder.resolve("inlineNodes/Vase_v2.x3d")))
        .isNotEqualTo(before.get(folder.resolve("inlineNodes/Vase_v2.x3d")));
    document.history().undo();

    assertThat(files()).isEqualTo(before);
  }
}

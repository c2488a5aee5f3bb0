package org.selectiverenderer.authoring.versions;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/** Versions that an author made by hand, and the files of a step that is taken back. */
class KeptVersionsTest extends VaseScene {
  private static final String BY_HAND =
      "<X3D version='3.3'><Scene><Shape><Box/></Shape></Scene></X3D>\n";

  private Path scene;
  private Path second;
  private Path third;

  @BeforeEach
  void versionsOfWhichTheSecondIsMadeByHand() throws IOException {
    scene = scene(SCENE);
    make(scene, "Vase");
    second = folder.resolve("inlineNodes/Vase_v2.x3d");
    third = folder.resolve("inlineNodes/Vase_v3.x3d");
    Files.writeString(second, BY_HAND);
  }

  private VersionsEdit.Request request() {
    return new VersionsEdit.Request(
        scene,
        "Vase",
        List.of(
            new SimplificationTarget.VertexPercent(30), new SimplificationTarget.VertexPercent(5)),
        "inlineNodes");
  }

  private SceneDocument applied(VersionsEdit.Request request) throws IOException {
    SceneDocument document = DocumentFile.open(scene).document();
    VersionsEdit.plan(document.snapshot(), request, catalogue, problems)
        .orElseThrow()
        .apply(document);
    return document;
  }

  @Test
  void theVersionsThatAreThereAreKnown() throws IOException {
    assertThat(
            VersionsEdit.existing(
                DocumentFile.open(scene).document().snapshot(), request(), catalogue))
        .containsExactly(folder.resolve("inlineNodes/Vase_v1.x3d"), second, third);
  }

  @Test
  void keptVersionsStayAsTheyAreAndAreShownWithTheirOwnFigures() throws IOException {
    VersionsEdit plan = plan(request().keeping(Set.of(2))).orElseThrow();
    assertThat(plan.versions().get(1).polygons()).isEqualTo(12);
    assertThat(plan.versions().get(1).error()).isNaN();
    assertThat(plan.files()).extracting(PlannedFile::file).containsExactly(third);
    applied(request().keeping(Set.of(2)));
    assertThat(second).usingCharset(StandardCharsets.UTF_8).hasContent(BY_HAND);
    assertThat(scene).usingCharset(StandardCharsets.UTF_8).hasContent(CHANGED);
    assertThat(plan(request().keeping(Set.of(2, 3))).orElseThrow().isEmpty()).isTrue();
  }

  @Test
  void aVersionThatIsNotThereCannotBeKept() throws IOException {
    assertThat(plan(request().keeping(Set.of(4)))).isEmpty();
    assertThat(problems.list().get(0).message()).contains("version 4 of the object");
  }

  @Test
  void whatIsReplacedComesBackWithUndoAndGoesAgainWithRedo() throws IOException {
    Map<Path, String> before = files();
    SceneDocument document = applied(request());
    Map<Path, String> after = files();
    assertThat(after.get(second)).isNotEqualTo(BY_HAND);
    assertThat(folder.resolve("inlineNodes/Vase_v2.x3d.bak"))
        .usingCharset(StandardCharsets.UTF_8)
        .hasContent(BY_HAND);
    assertThat(document.history().names()).containsExactly("Make versions of Vase");
    document.history().undo();
    assertThat(files()).containsAllEntriesOf(before);
    document.history().redo();
    assertThat(files()).isEqualTo(after);
  }

  @Test
  void newFilesGoWithUndoAndTheirFolderToo() throws IOException {
    Path other = other("other.x3d", shape("Ball", "<Sphere/>"));
    Map<Path, String> before = files();
    SceneDocument document = DocumentFile.open(other).document();
    VersionsEdit.plan(
            document.snapshot(),
            new VersionsEdit.Request(other, "Ball", GOALS, "balls/new"),
            catalogue,
            problems)
        .orElseThrow()
        .apply(document);
    assertThat(folder.resolve("balls/new/Ball_v3.x3d")).exists();
    document.history().undo();
    assertThat(files()).isEqualTo(before);
    assertThat(folder.resolve("balls/new")).doesNotExist();
    document.history().redo();
    assertThat(folder.resolve("balls/new/Ball_v3.x3d")).exists();
  }

  @Test
  void whatAnotherProgramChangedMeanwhileIsNotOverwrittenUnasked() throws IOException {
    SceneDocument document = applied(request());
    String text = document.text().toString();
    Files.writeString(third, "theirs");
    assertThat(document.history().changedMeanwhile(true)).containsExactly(third);
    assertThatThrownBy(() -> document.history().undo())
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("Vase_v3.x3d: another program has changed the file");
    assertThat(third).usingCharset(StandardCharsets.UTF_8).hasContent("theirs");
    assertThat(document.text().toString()).isEqualTo(text);
    assertThat(document.history().undo(true)).isTrue();
    assertThat(second).usingCharset(StandardCharsets.UTF_8).hasContent(BY_HAND);
    assertThat(folder.resolve("inlineNodes/Vase_v3.x3d.bak"))
        .usingCharset(StandardCharsets.UTF_8)
        .hasContent("theirs");
  }

  @Test
  void versionsUnderAnotherNameLeaveTheFilesThatAreThere() throws IOException {
    Map<Path, String> before = files();
    SceneDocument document = applied(request().keeping(Set.of(3)).named("Slim Vase"));
    assertThat(document.text().toString())
        .isEqualTo(CHANGED.replace("inlineNodes/Vase_v2.x3d", "inlineNodes/Slim_Vase_v2.x3d"));
    assertThat(second).usingCharset(StandardCharsets.UTF_8).hasContent(BY_HAND);
    assertThat(folder.resolve("inlineNodes/Slim_Vase_v2.x3d")).exists();
    document.history().undo();
    assertThat(files()).isEqualTo(before);
  }

  @Test
  void aNameThatIsTakenIsRefusedWithItsFile() throws IOException {
    Path taken = Files.writeString(folder.resolve("inlineNodes/Slim_v2.x3d"), "theirs");
    assertThat(plan(request().named("Slim"))).isEmpty();
    assertThat(problems.list().get(0).toString()).contains("Slim_v2.x3d", "exists already");
    assertThat(taken).usingCharset(StandardCharsets.UTF_8).hasContent("theirs");
  }
}

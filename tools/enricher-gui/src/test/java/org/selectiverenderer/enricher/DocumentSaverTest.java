package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** What is asked before a scene is saved or left, and what is written. */
class DocumentSaverTest extends DocumentSaverFixture {
  @Test
  void savingElsewhereTakesTheScenesFilesAlong() throws Exception {
    Files.writeString(folder.resolve("Cup_v1.x3d"), "<X3D version='4.0'><Scene/></X3D>");
    Path inlined = Files.createDirectories(folder.resolve("other/inlineNodes"));
    answers.target = Path.of("other/room.x3d");
    answers.agree = false;
    answers.take = true;
    saving.saveAs(() -> done++);
    while (!session.tasks().running().isEmpty() || !results.isEmpty()) {
      result();
    }
    assertThat(done).isEqualTo(1);
    assertThat(folder.resolve("other/room.x3d")).exists();
    assertThat(folder.resolve("other/Cup_v1.x3d")).exists();
    assertThat(inlined).isEmptyDirectory();
    assertThat(answers.asked).contains("without 1"); // Cup_v2.x3d does not exist
    assertThat(session.file().path()).isEqualTo(folder.resolve("other/room.x3d"));
    assertThat(session.document().modified()).isFalse();
  }

  @Test
  void nothingIsAskedWhereNothingHasChanged() throws InterruptedException {
    assertThat(save(true)).isTrue();
    saving.leaving(true, () -> done++);
    assertThat(done).isEqualTo(2);
    assertThat(answers.asked).isEmpty();
  }

  @Test
  void changesAreReviewedThenSaved() throws IOException, InterruptedException {
    type();
    assertThat(save(true)).isTrue();
    assertThat(answers.asked).containsExactly("review");
    assertThat(onDisk()).startsWith("<!-- mine -->");
  }

  @Test
  void aReviewThatIsNotConfirmedLeavesTheFileAsItWas() throws IOException, InterruptedException {
    answers.agree = false;
    type();
    assertThat(save(true)).isFalse();
    assertThat(onDisk()).doesNotContain("mine");
    assertThat(session.document().modified()).isTrue();
  }

  @Test
  void leavingWithUnsavedWorkAsks() throws IOException, InterruptedException {
    type();
    saving.leaving(false, () -> done++);
    assertThat(done).as("cancelled").isZero();
    answers.unsaved = UserPrompts.Unsaved.SAVE;
    saving.leaving(false, () -> done++);
    assertThat(done).as("not before it is saved").isZero();
    result();
    assertThat(done).isEqualTo(1);
    assertThat(onDisk()).contains("mine");
  }

  @Test
  void whoLeavesWhileTheFileIsWrittenIsAskedAboutWhatWasTypedSince() throws Exception {
    type();
    saving.save(false, () -> {});
    type();
    saving.leaving(false, () -> done++);
    assertThat(answers.asked).isEmpty();
    result();
    assertThat(answers.asked).containsExactly("unsaved");
    assertThat(done).isZero();
  }

  @Test
  void savingUnderAnotherNameLeavesTheFirstFile() throws IOException, InterruptedException {
    Path first = session.file().path();
    type();
    saving.saveAs(() -> done++);
    result();
    assertThat(done).isEqualTo(1);
    assertThat(Files.readString(first)).doesNotContain("mine");
    assertThat(session.file().path()).hasFileName("other.x3d");
  }

  @Test
  void aTextThatIsNotWellFormedIsSavedOnlyWhenTheAuthorAgreesAndTheLastGoodCopyStays()
      throws IOException, InterruptedException {
    String good = onDisk();
    session.document().type(0, 0, "<");
    answers.agree = false;
    assertThat(save(true)).isFalse();
    assertThat(answers.asked)
        .singleElement()
        .asString()
        .startsWith("scene.x3d would not be well-formed XML: line 1, ");
    assertThat(onDisk()).isEqualTo(good);
    assertThat(session.document().modified()).isTrue();
    answers.agree = true;
    assertThat(save(false)).isTrue();
    String faulty = onDisk();
    session.document().type(0, 0, "<");
    assertThat(save(false)).isTrue();
    assertThat(session.file().backup()).hasContent(good);
    assertThat(session.file().faultyBackup()).hasContent(faulty);
    session.document().type(0, 2, "");
    assertThat(save(false)).isTrue();
    assertThat(onDisk()).isEqualTo(good);
    assertThat(session.file().backup()).hasContent(good);
  }

  @Test
  void aNameWithoutTheEndingOfASceneGetsItAndNothingUnderThatNameIsReplacedUnasked()
      throws IOException, InterruptedException {
    answers.target = Path.of("room.v2");
    type();
    saving.saveAs(() -> done++);
    result();
    assertThat(session.file().path()).hasFileName("room.v2.x3d");
    assertThat(folder.resolve("room.v2")).doesNotExist();
    Path other = Files.writeString(folder.resolve("hall.x3d"), "theirs");
    answers.target = Path.of("hall");
    answers.agree = false;
    saving.saveAs(() -> done++);
    assertThat(answers.asked).containsExactly("overwrite");
    assertThat(other).content().isEqualTo("theirs");
    answers.agree = true;
    saving.saveAs(() -> done++);
    result();
    assertThat(other).content().contains("mine");
    assertThat(folder.resolve("hall.x3d.faulty.bak")).content().isEqualTo("theirs");
  }

  @Test
  void savingWhereTheScenesFilesAreNotFoundIsAskedAboutFirst()
      throws IOException, InterruptedException {
    Path first = session.file().path().toAbsolutePath();
    Files.writeString(first.resolveSibling("cup.x3d"), "<X3D/>");
    int scene = session.document().text().toString().indexOf("</Scene>");
    session.document().type(scene, scene, "<Inline url='\"cup.x3d\"'/>");
    Path other = Files.createDirectories(first.resolveSibling("other"));
    answers.target = other.resolve("saved.x3d");
    answers.agree = false;
    saving.saveAs(() -> done++);
    assertThat(answers.asked)
        .singleElement()
        .asString()
        .contains(other + "", "cup.x3d", "would not find");
    assertThat(answers.target).doesNotExist();
    assertThat(session.file().path()).isEqualTo(first);
    answers.agree = true;
    saving.saveAs(() -> done++);
    result();
    assertThat(done).isEqualTo(1);
    assertThat(answers.target).content().contains("cup.x3d");
  }

  @Test
  void aFullDiskIsToldAndLosesNothing() throws IOException, InterruptedException {
    answers.target = Path.of("/dev/full");
    assumeTrue(Files.isWritable(answers.target));
    Path first = session.file().path();
    type();
    saving.saveAs(() -> done++);
    result();
    assertThat(done).isZero();
    assertThat(answers.asked)
        .containsExactly(
            "/dev/full: cannot be saved (No space left on device); file and document are as they"
                + " were. Save it under another name");
    assertThat(session.document().modified()).isTrue();
    assertThat(session.file().path()).isEqualTo(first);
    assertThat(save(false)).isTrue();
    assertThat(onDisk()).contains("mine");
  }
}

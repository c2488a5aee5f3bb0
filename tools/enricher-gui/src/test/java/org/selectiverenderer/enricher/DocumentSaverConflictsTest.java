package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.UndoableFileWrite;
import org.selectiverenderer.enricher.text.Texts;

/** What becomes of a file that another program has changed meanwhile. */
class DocumentSaverConflictsTest extends DocumentSaverFixture {
  @Test
  void whatAnotherProgramWroteIsOverwrittenOnlyWhenTheAuthorAgrees() throws Exception {
    type();
    Files.writeString(session.file().path(), "<X3D><!-- theirs --></X3D>");
    assertThat(save(false)).isFalse();
    assertThat(onDisk()).contains("theirs");
    answers.onDisk = UserPrompts.OnDisk.OVERWRITE;
    assertThat(save(false)).isTrue();
    assertThat(onDisk()).contains("mine");
    assertThat(session.file().backup()).content().contains("theirs");
  }

  @Test
  void anOutsideEditIsAskedAboutBeforeTheChangesAreShown() throws Exception {
    type();
    theirs();
    assertThat(save(true)).isFalse();
    assertThat(answers.asked).containsExactly("changed [KEEP, OVERWRITE, MERGE]");
    answers.asked.clear();
    answers.onDisk = UserPrompts.OnDisk.OVERWRITE;
    assertThat(save(true)).isTrue();
    assertThat(answers.asked).containsExactly("changed [KEEP, OVERWRITE, MERGE]", "review");
    assertThat(onDisk()).contains("mine").doesNotContain("theirs");
  }

  @Test
  void aFileThatWasMergedIsShownAndSaved() throws Exception {
    type();
    theirs();
    answers.onDisk = UserPrompts.OnDisk.MERGE;
    assertThat(save(true)).isTrue();
    assertThat(answers.asked)
        .containsExactly("changed [KEEP, OVERWRITE, MERGE]", "conflicts 0", "review");
    assertThat(onDisk()).contains("mine").contains("theirs");
  }

  @Test
  void aChangeOnTheDiskIsAskedAboutOnce() throws Exception {
    saving.lookAtDisk(() -> done++);
    result();
    Files.writeString(session.file().path(), "<X3D><!-- theirs --></X3D>");
    saving.lookAtDisk(() -> done++);
    result();
    saving.lookAtDisk(() -> done++);
    result();
    assertThat(answers.asked).containsExactly("changed [KEEP, TAKE, MERGE]");
  }

  /** Another program has added a comment behind the scene. */
  private String theirs() throws IOException {
    String theirs = onDisk() + "<!-- theirs -->\n";
    Files.writeString(session.file().path(), theirs);
    return theirs;
  }

  @Test
  void takingTheFileIsAStepThatCanBeUndone() throws Exception {
    type();
    String mine = session.document().text().toString();
    String theirs = theirs();
    answers.onDisk = UserPrompts.OnDisk.TAKE;
    saving.lookAtDisk(() -> done++);
    result();
    result();
    assertThat(answers.asked).containsExactly("changed [KEEP, TAKE, MERGE]");
    assertThat(session.document().text().toString()).isEqualTo(theirs);
    assertThat(session.document().modified()).isFalse();
    assertThat(done).as("reloaded").isZero();
    session.document().history().undo();
    assertThat(session.document().text().toString()).isEqualTo(mine);
  }

  @Test
  void whatBothHaveMadeOfTheFileIsPutTogetherAndSaved() throws Exception {
    session.document().type(0, 0, "<!-- mine -->\n");
    String theirs = theirs();
    answers.onDisk = UserPrompts.OnDisk.MERGE;
    assertThat(save(false)).isTrue();
    assertThat(answers.asked).containsExactly("changed [KEEP, OVERWRITE, MERGE]", "conflicts 0");
    assertThat(onDisk()).isEqualTo("<!-- mine -->\n" + theirs);
    assertThat(session.file().backup()).hasContent(theirs);
    assertThat(session.document().history().undoName()).contains(Texts.of("merge.step"));
  }

  @Test
  void aMergeThatTheAuthorThinksBetterOfChangesNothing() throws Exception {
    session.document().type(0, 5, "<X3D version='3.3'");
    String mine = session.document().text().toString();
    Files.writeString(session.file().path(), onDisk().replace("4.0", "3.2"));
    answers.agree = false;
    saving.merge();
    result();
    assertThat(answers.asked).containsExactly("conflicts 1");
    assertThat(session.document().text().toString()).isEqualTo(mine);
    assertThat(onDisk()).contains("3.2");
  }

  @Test
  void filesOfAStepThatAnotherProgramChangedAreReplacedOnlyWhenTheAuthorAgrees()
      throws IOException {
    Path file = folder.resolve("cup_v2.x3d");
    session
        .document()
        .perform(
            new Edit("Make", List.of()),
            List.of(new UndoableFileWrite(file, new byte[] {'a'}, false)));
    Files.writeString(file, "theirs");
    UndoController steps = new UndoController(session.document().history(), answers);
    answers.agree = false;
    assertThat(steps.go(true)).isFalse();
    assertThat(file).hasContent("theirs");
    answers.agree = true;
    assertThat(steps.go(true)).isTrue();
    assertThat(file).doesNotExist();
    assertThat(folder.resolve("cup_v2.x3d.bak")).hasContent("theirs");
    assertThat(steps.go(false)).isTrue();
    assertThat(file).hasContent("a");
    assertThat(answers.asked).containsExactly("overwrite", "overwrite");
  }

  @Test
  void revertingTakesTheSavedTextAsAStepThatCanBeUndone() throws Exception {
    String saved = onDisk();
    type();
    saving.revert(() -> done++);
    result();
    assertThat(answers.asked).containsExactly("revert");
    assertThat(session.document().text().toString()).isEqualTo(saved);
    assertThat(session.document().modified()).isFalse();
    session.document().history().undo();
    assertThat(session.document().text().toString()).startsWith("<!-- mine -->");
    assertThat(done).as("reloaded").isZero();
  }

  @Test
  void anAuthorWhoDoesNotRevertKeepsTheChanges() {
    type();
    answers.agree = false;
    saving.revert(() -> done++);
    assertThat(session.document().text().toString()).startsWith("<!-- mine -->");
  }

  @Test
  void aFileThatVanishedIsToldAndWrittenAgain() throws IOException, InterruptedException {
    Files.delete(session.file().path());
    saving.lookAtDisk(() -> done++);
    result();
    assertThat(done).isZero();
    type();
    assertThat(save(false)).isTrue();
    assertThat(onDisk()).contains("mine");
  }
}

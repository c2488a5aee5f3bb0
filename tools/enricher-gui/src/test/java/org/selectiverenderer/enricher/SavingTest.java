package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.document.Edit;
import org.selectiverenderer.document.StepFile;
import org.selectiverenderer.document.file.LineMerge;
import org.selectiverenderer.enricher.driving.Sessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.Tasks;
import org.selectiverenderer.enricher.text.Texts;

class SavingTest {
  @TempDir Path folder;
  private EnricherSession session;
  private Answers answers;
  private Saving saving;
  private final BlockingQueue<Runnable> results = new LinkedBlockingQueue<>();
  private int done;

  /** An author of fixed answers. */
  private static final class Answers implements Questions {
    private final List<String> asked = new ArrayList<>();
    private Unsaved unsaved = Unsaved.CANCEL;
    private boolean agree = true;
    private OnDisk onDisk = OnDisk.KEEP;
    private Path target = Path.of("other.x3d");

    @Override
    public Left left(String sentence) {
      throw new AssertionError("saving does not ask for that");
    }

    @Override
    public Unsaved unsaved(String name) {
      asked.add("unsaved");
      return unsaved;
    }

    @Override
    public boolean convert(String sentence) {
      throw new AssertionError(sentence);
    }

    @Override
    public boolean overwrite(String sentence) {
      asked.add("overwrite");
      return agree;
    }

    @Override
    public OnDisk changedOnDisk(String sentence, List<OnDisk> among) {
      asked.add("changed " + among);
      return onDisk;
    }

    @Override
    public Optional<List<LineMerge.Choice>> merge(LineMerge merge) {
      asked.add("conflicts " + merge.count(LineMerge.Kind.CONFLICT));
      return agree
          ? Optional.of(
              Collections.nCopies(
                  merge.count(LineMerge.Kind.CONFLICT), LineMerge.Choice.THEIRS_FIRST))
          : Optional.empty();
    }

    @Override
    public boolean leaveBehind(String sentence) {
      asked.add(sentence);
      return agree;
    }

    @Override
    public boolean saveFaulty(String sentence) {
      asked.add(sentence);
      return agree;
    }

    @Override
    public Optional<Path> fileToOpen(Optional<Path> near) {
      return Optional.empty();
    }

    @Override
    public Optional<Path> fileToSave(Path near) {
      return Optional.of(near.resolveSibling(target));
    }

    @Override
    public boolean review(EnricherSession session) {
      asked.add("review");
      return agree;
    }

    @Override
    public void tell(String sentence) {
      asked.add(sentence);
    }
  }

  @BeforeEach
  void open() throws IOException {
    Path path =
        Files.writeString(
            folder.resolve("scene.x3d"),
            "<X3D version='4.0'>\n<Scene>\n" + Sessions.object("Cup") + "</Scene>\n</X3D>\n");
    session = Sessions.open(path, new Tasks(results::add));
    answers = new Answers();
    saving = new Saving(session, answers);
  }

  /** Hands over one result of the background, as the event dispatch thread would. */
  private void result() throws InterruptedException {
    Runnable next = results.poll(30, TimeUnit.SECONDS);
    assertThat(next).isNotNull();
    next.run();
  }

  private boolean save(boolean review) throws InterruptedException {
    done = 0;
    saving.save(review, () -> done++);
    while (!session.tasks().running().isEmpty() || !results.isEmpty()) {
      result();
    }
    return done == 1;
  }

  private void type() {
    session.document().type(0, 0, "<!-- mine -->");
  }

  private String onDisk() throws IOException {
    return Files.readString(session.file().path());
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
    answers.unsaved = Questions.Unsaved.SAVE;
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
  void whatAnotherProgramWroteIsOverwrittenOnlyWhenTheAuthorAgrees() throws Exception {
    type();
    Files.writeString(session.file().path(), "<X3D><!-- theirs --></X3D>");
    assertThat(save(false)).isFalse();
    assertThat(onDisk()).contains("theirs");
    answers.onDisk = Questions.OnDisk.OVERWRITE;
    assertThat(save(false)).isTrue();
    assertThat(onDisk()).contains("mine");
    assertThat(session.file().backup()).content().contains("theirs");
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
    assertThat(answers.asked).containsExactly("changed [KEEP, TAKE]");
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
    answers.onDisk = Questions.OnDisk.TAKE;
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
    answers.onDisk = Questions.OnDisk.MERGE;
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
  void filesOfAStepThatAnotherProgramChangedAreReplacedOnlyWhenTheAuthorAgrees()
      throws IOException {
    Path file = folder.resolve("cup_v2.x3d");
    session
        .document()
        .perform(new Edit("Make", List.of()), List.of(new StepFile(file, new byte[] {'a'}, false)));
    Files.writeString(file, "theirs");
    Steps steps = new Steps(session.document().history(), answers);
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
    assertThat(answers.asked).singleElement().asString().contains(other + "", "cup.x3d", "missing");
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

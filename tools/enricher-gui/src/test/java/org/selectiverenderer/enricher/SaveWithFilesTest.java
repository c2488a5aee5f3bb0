package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.enricher.importing.PackageDialog;
import org.selectiverenderer.enricher.task.BackgroundTask;

/** Save As with files, and packages: each end of them, and what is on the disk then. */
class SaveWithFilesTest extends DocumentSaverFixture {
  private void begin(String target) throws IOException {
    Files.writeString(folder.resolve("sky.png"), "sky");
    if (!target.startsWith("bare")) {
      Files.writeString(folder.resolve("Cup_v1.x3d"), "<X3D version='4.0'><Scene/></X3D>");
    }
    int at = session.document().text().toString().indexOf("<Scene>") + "<Scene>".length();
    session.document().type(at, at, "<Background backUrl='\"sky.png\"'/>");
    answers.target = Path.of(target);
    answers.agree = false;
    answers.take = true;
    saving.saveAs(() -> done++);
  }

  /** Keeps the thread for writing busy, so that what follows can be cancelled in time. */
  private CountDownLatch hold() {
    CountDownLatch hold = new CountDownLatch(1);
    session
        .tasks()
        .runToEnd(
            "hold",
            () -> {
              hold.await();
              return true;
            },
            ended -> {},
            failed -> {});
    return hold;
  }

  private void end() throws InterruptedException {
    while (!session.tasks().running().isEmpty() || !results.isEmpty()) {
      result();
    }
  }

  private List<String> there(Path in) throws IOException {
    try (var all = Files.list(in)) {
      return all.map(path -> path.getFileName().toString()).sorted().toList();
    }
  }

  private void nothingIsHeldBack() throws InterruptedException {
    answers.unsaved = UserPrompts.Unsaved.DISCARD;
    int before = done;
    saving.leaving(false, () -> done++);
    end();
    assertThat(done).isEqualTo(before + 1);
  }

  @Test
  void itCanBeCancelledAndIsLeftOnlyAfterItsEnd() throws IOException, InterruptedException {
    Path other = Files.createDirectories(folder.resolve("other"));
    CountDownLatch hold = hold();
    begin("other/room.x3d");
    List<BackgroundTask> running = session.tasks().running();
    assertThat(running).hasSize(2);
    assertThat(running.get(1).stoppable()).isTrue();
    answers.unsaved = UserPrompts.Unsaved.DISCARD;
    int[] left = {0};
    saving.leaving(false, () -> left[0]++);
    assertThat(left[0]).as("not while it is written").isZero();
    running.get(1).cancel();
    hold.countDown();
    end();
    assertThat(left[0]).isOne();
    assertThat(done).isZero();
    assertThat(there(other)).isEmpty();
    assertThat(session.file().path()).isEqualTo(folder.resolve("scene.x3d"));
  }

  @Test
  void aFolderThatCannotBeWrittenIsToldAndNothingIsChanged()
      throws IOException, InterruptedException {
    Path locked = Files.writeString(folder.resolve("locked"), "a file, also for the administrator");
    begin("locked/room.x3d");
    end();
    assertThat(done).isZero();
    assertThat(answers.asked)
        .anyMatch(
            sentence ->
                sentence.contains(locked.toString())
                    && sentence.contains("(its folder does not exist)"));
    assertThat(session.file().path()).isEqualTo(folder.resolve("scene.x3d"));
    assertThat(locked).isRegularFile();
    nothingIsHeldBack();
  }

  @Test
  void aFolderInTheWayIsToldAndWhatWasWrittenIsRemoved() throws IOException, InterruptedException {
    Path other = Files.createDirectories(folder.resolve("other"));
    Files.createDirectories(other.resolve("Cup_v1.x3d/in"));
    begin("other/room.x3d");
    end();
    assertThat(done).isZero();
    assertThat(answers.asked).anyMatch(sentence -> sentence.contains("Cup_v1.x3d"));
    assertThat(there(other)).containsExactly("Cup_v1.x3d");
    nothingIsHeldBack();
  }

  @Test
  void thePictureOfABackgroundIsAskedAbout() throws IOException, InterruptedException {
    Path other = Files.createDirectories(folder.resolve("bare"));
    begin("bare/room.x3d");
    end();
    assertThat(done).isOne();
    assertThat(there(other)).containsExactly("room.x3d", "sky.png");
  }

  @Test
  void editsMeanwhileEndItAndItsFilesAreRemoved() throws IOException, InterruptedException {
    Path other = Files.createDirectories(folder.resolve("other"));
    begin("other/room.x3d");
    result(); // collected
    type();
    end();
    assertThat(done).isZero();
    assertThat(there(other)).isEmpty();
    nothingIsHeldBack();
  }

  @Test
  void aPackageInTheScenesOwnFolderIsAskedAboutAndKeepsItsFiles()
      throws IOException, InterruptedException {
    Files.writeString(folder.resolve("Cup_v1.x3d"), "mine");
    List<String> before = there(folder);
    new PackageCommands(answers).write(session, new PackageDialog.Target(folder, false));
    end();
    assertThat(there(folder)).isEqualTo(before);
    assertThat(folder.resolve("Cup_v1.x3d")).hasContent("mine");
    Path made = folder.resolve("made");
    CountDownLatch hold = hold();
    new PackageCommands(answers).write(session, new PackageDialog.Target(made, false));
    session.tasks().running().forEach(BackgroundTask::cancel);
    hold.countDown();
    end();
    assertThat(made).doesNotExist();
    new PackageCommands(answers).write(session, new PackageDialog.Target(made, false));
    end();
    assertThat(made.resolve("scene.x3d")).hasSameTextualContentAs(folder.resolve("scene.x3d"));
  }

  @Test
  void whatWasReplacedIsThereAgainAfterTypingMeanwhile() throws IOException, InterruptedException {
    Path other = Files.createDirectories(folder.resolve("other"));
    Files.writeString(other.resolve("sky.png"), "mine");
    begin("other/room.x3d");
    result(); // collected
    type();
    end();
    assertThat(done).isZero();
    assertThat(answers.asked).contains("replace 1");
    assertThat(there(other)).containsExactly("sky.png");
    assertThat(other.resolve("sky.png")).hasContent("mine");
    nothingIsHeldBack();
  }

  @Test
  void whatWasReplacedIsGoneOnlyAfterTheSceneIsSaved() throws IOException, InterruptedException {
    Path other = Files.createDirectories(folder.resolve("other"));
    Files.writeString(other.resolve("sky.png"), "mine");
    begin("other/room.x3d");
    end();
    assertThat(done).isOne();
    assertThat(there(other)).containsExactly("Cup_v1.x3d", "room.x3d", "sky.png");
    assertThat(other.resolve("sky.png")).hasContent("sky");
  }

  /** Takes con.png along, whose url becomes _con.png, to where the scene cannot be saved. */
  private Path beginWhereTheSceneCannotBeWritten() throws IOException, InterruptedException {
    Files.writeString(folder.resolve("con.png"), "con");
    int at = session.document().text().toString().indexOf("<Scene>") + "<Scene>".length();
    session.document().type(at, at, "<Background backUrl='\"con.png\"'/>");
    Path other = Files.createDirectories(folder.resolve("other"));
    Files.writeString(other.resolve("_con.png"), "mine");
    begin("other/room.x3d");
    result(); // collected
    result(); // compared
    // A folder appears where the scene is to be saved.
    Files.createDirectories(other.resolve("room.x3d/in"));
    return other;
  }

  @Test
  void aSceneThatCannotBeWrittenTakesItsFilesBack() throws IOException, InterruptedException {
    Path other = beginWhereTheSceneCannotBeWritten();
    String before = session.document().text().toString();
    end();
    assertThat(done).isZero();
    assertThat(session.document().text().toString()).isEqualTo(before);
    assertThat(there(other)).containsExactly("_con.png", "room.x3d");
    assertThat(other.resolve("_con.png")).hasContent("mine");
    nothingIsHeldBack();
  }

  @Test
  void typingWhileTheSceneFailsToBeWrittenIsNotTakenBack()
      throws IOException, InterruptedException {
    Path other = beginWhereTheSceneCannotBeWritten();
    result(); // copied; the scene is being written
    type();
    end();
    assertThat(session.document().text().toString())
        .startsWith("<!-- mine -->")
        .contains("_con.png");
    assertThat(answers.asked).anyMatch(sentence -> sentence.contains("Change the urls"));
    assertThat(there(other))
        .contains("_con.png", "Cup_v1.x3d", "sky.png")
        .doesNotContain(".package.part");
    nothingIsHeldBack();
  }

  @Test
  void workCancelledAtItsEndIsUndoneOnTheThreadForWriting() throws InterruptedException {
    BackgroundTask[] task = {null};
    CountDownLatch begun = new CountDownLatch(1);
    BlockingQueue<String> heard = new LinkedBlockingQueue<>();
    task[0] =
        session
            .tasks()
            .runWriting(
                "write",
                progress -> {
                  begun.await();
                  task[0].cancel();
                  return "written";
                },
                result -> heard.add("undone on " + Thread.currentThread().getName()),
                result -> heard.add("done"),
                failed -> heard.add("told " + failed.getClass().getSimpleName()));
    begun.countDown();
    end();
    assertThat(heard).containsExactly("undone on enricher-writer", "told CancellationException");
  }
}

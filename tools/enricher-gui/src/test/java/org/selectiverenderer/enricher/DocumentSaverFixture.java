package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

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
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.file.ThreeWayMerge;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.TaskExecutor;

/** A scene that is edited and saved, and an author who answers what is asked. */
abstract class DocumentSaverFixture {
  @TempDir Path folder;
  EnricherSession session;

  Answers answers;

  DocumentSaver saving;

  final BlockingQueue<Runnable> results = new LinkedBlockingQueue<>();

  int done;

  /** An author of fixed answers. */
  static final class Answers implements UserPrompts {
    final List<String> asked = new ArrayList<>();
    Unsaved unsaved = Unsaved.CANCEL;
    boolean agree = true;
    boolean take;
    OnDisk onDisk = OnDisk.KEEP;
    Path target = Path.of("other.x3d");

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
    public boolean revert(String sentence) {
      asked.add("revert");
      return agree;
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
    public Optional<List<ThreeWayMerge.Choice>> merge(ThreeWayMerge merge) {
      asked.add("conflicts " + merge.count(ThreeWayMerge.Kind.CONFLICT));
      return agree
          ? Optional.of(
              Collections.nCopies(
                  merge.count(ThreeWayMerge.Kind.CONFLICT), ThreeWayMerge.Choice.THEIRS_FIRST))
          : Optional.empty();
    }

    @Override
    public LeftBehind leaveBehind(String sentence) {
      asked.add(sentence);
      return agree ? LeftBehind.LEAVE : take ? LeftBehind.TAKE : LeftBehind.CANCEL;
    }

    @Override
    public boolean without(String sentence, List<String> lines) {
      asked.add("without " + lines.size());
      return true;
    }

    @Override
    public boolean replace(String sentence, List<String> lines) {
      asked.add("replace " + lines.size());
      return true;
    }

    @Override
    public Optional<Path> modelToImport(Path scene) {
      return Optional.empty();
    }

    @Override
    public boolean saveFaulty(String sentence) {
      asked.add(sentence);
      return agree;
    }

    @Override
    public boolean trust(String sentence, List<String> lines) {
      return false;
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
            "<X3D version='4.0'>\n<Scene>\n" + TestSessions.object("Cup") + "</Scene>\n</X3D>\n");
    session = TestSessions.open(path, new TaskExecutor(results::add));
    answers = new Answers();
    saving = new DocumentSaver(session, answers, other -> false);
  }

  /** Hands over one result of the background, as the event dispatch thread would. */
  void result() throws InterruptedException {
    Runnable next = results.poll(30, TimeUnit.SECONDS);
    assertThat(next).isNotNull();
    next.run();
  }

  boolean save(boolean review) throws InterruptedException {
    done = 0;
    saving.save(review, () -> done++);
    while (!session.tasks().running().isEmpty() || !results.isEmpty()) {
      result();
    }
    return done == 1;
  }

  void type() {
    session.document().type(0, 0, "<!-- mine -->");
  }

  String onDisk() throws IOException {
    return Files.readString(session.file().path());
  }
}

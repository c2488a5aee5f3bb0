package org.selectiverenderer.enricher.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.TaskExecutor;

/** Running the open document; the processes are the program's own. */
class SceneRunManagerTest {
  private static final long PATIENCE = 60;
  private static final Pose HERE =
      new Pose(new Vector3d(1, 2, 3), new Quaterniond().rotationY(Math.PI / 2), 0.5);

  @TempDir Path folder;
  private final List<List<String>> started = new CopyOnWriteArrayList<>();
  private final LinkedBlockingQueue<String> status = new LinkedBlockingQueue<>();
  private final LinkedBlockingQueue<String> messages = new LinkedBlockingQueue<>();

  private EnricherSession session() throws IOException {
    Path scene =
        Files.writeString(
            folder.resolve("room.x3d"),
            "<X3D version='4.0'><Scene>\n<!-- mine --><Group DEF='Room'/>\n</Scene></X3D>\n");
    return TestSessions.open(scene, new TaskExecutor(EventThread::edt));
  }

  private List<Path> files() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.sorted().toList();
    }
  }

  private String next(LinkedBlockingQueue<String> queue) throws InterruptedException {
    String said = queue.poll(PATIENCE, TimeUnit.SECONDS);
    assertThat(said).isNotNull();
    return said;
  }

  /** Instead of drawing, the program says its version, which is all that is needed here. */
  private SceneRunManager runs(List<String> instead) {
    return new SceneRunManager(
        messages::add,
        status::add,
        words -> {
          started.add(words);
          return ProcessLauncher.start(instead);
        });
  }

  @Test
  void aSavedSceneIsRunItselfAndItsMessagesAreHeard() throws Exception {
    EnricherSession session = session();
    SceneRunManager runs = runs(List.of("--version"));
    EventThread.edt(() -> runs.run(session, RunOptions.USUAL, Optional.of(HERE)));
    assertThat(next(status)).isEqualTo("Run 1: room.x3d, condition selective");
    assertThat(next(messages)).startsWith("[1] ");
    assertThat(next(status)).isEqualTo("Run 1: the walk has ended");
    assertThat(started)
        .containsExactly(
            List.of("run", folder.resolve("room.x3d").toString(), "--condition", "selective"));
    assertThat(files()).hasSize(1);
  }

  @Test
  void whatIsNotSavedIsRunFromACopyThatGoesWithIt() throws Exception {
    EnricherSession session = session();
    SceneDocument document = session.document();
    document.type(
        document.text().toString().indexOf("mine"),
        document.text().length(),
        "yours" + " --><Group DEF='Hall'/>\n</Scene></X3D>\n");
    List<String> seen = new ArrayList<>();
    SceneRunManager runs =
        new SceneRunManager(
            messages::add,
            status::add,
            words -> {
              started.add(words);
              seen.add(Files.readString(Path.of(words.get(1))));
              return ProcessLauncher.start(List.of("validate", words.get(1)));
            });
    EventThread.edt(() -> runs.run(session, new RunOptions("high", true), Optional.of(HERE)));
    next(status);
    assertThat(next(status)).startsWith("Run 1: the walk has ended");
    assertThat(seen.get(0))
        .contains("Hall")
        .contains(
            "--><Viewpoint DEF='Enricher_Here' description='Enricher_Here' position='1 2 3'"
                + " orientation='0 1 0 1.570796' fieldOfView='0.5'/><Group");
    assertThat(started.get(0)).endsWith("--condition", "high", "--viewpoint", "Enricher_Here");
    assertThat(Path.of(started.get(0).get(1)).getParent()).isEqualTo(folder);
    assertThat(files()).containsExactly(folder.resolve("room.x3d"));
  }

  @Test
  void runsEndWithTheWindowAndLeaveNothing() throws Exception {
    EnricherSession session = session();
    SceneRunManager runs =
        new SceneRunManager(
            messages::add,
            status::add,
            words -> {
              started.add(words);
              return ProcessLauncher.start(List.of("validate", "-")); // reads until it is ended
            });
    for (int i = 0; i < 2; i++) {
      EventThread.edt(() -> runs.run(session, new RunOptions("random", true), Optional.of(HERE)));
      next(status);
    }
    assertThat(EventThread.get(runs::running)).isEqualTo(2);
    assertThat(files()).hasSize(3);
    EventThread.edt(runs::close);
    assertThat(files()).hasSize(1);
    assertThat(EventThread.get(runs::running)).isZero();
  }

  @Test
  void whatCannotBeRunIsSaid() throws Exception {
    EnricherSession session = session();
    SceneRunManager runs = runs(List.of("--version"));
    EventThread.edt(() -> runs.run(session, new RunOptions("high", true), Optional.empty()));
    assertThat(next(status)).startsWith("The preview shows no scene");
    session.document().type(0, 1, "");
    EventThread.edt(() -> runs.run(session, RunOptions.USUAL, Optional.empty()));
    assertThat(next(status)).contains("not well formed");
    assertThat(started).isEmpty();
  }

  @Test
  void aRunThatEndsInASceneWithProblemsIsNoFailureButOneThatFailsIs() throws Exception {
    EnricherSession session = session();
    Path faulty = Files.writeString(folder.resolve("faulty.x3d"), "<X3D><Scene><Nothing/>");
    SceneRunManager problems = runs(List.of("validate", faulty.toString()));
    EventThread.edt(() -> problems.run(session, RunOptions.USUAL, Optional.of(HERE)));
    next(status);
    assertThat(next(status)).startsWith("Run 1: the walk has ended. The scene has problems");
    SceneRunManager failure = runs(List.of("no-such-command"));
    EventThread.edt(() -> failure.run(session, RunOptions.USUAL, Optional.of(HERE)));
    next(status);
    assertThat(next(status)).startsWith("Run 1 was broken off (code 2)");
  }

  @Test
  void theProgramIsThereUnderItsName() throws ClassNotFoundException {
    assertThat(Class.forName(ProcessLauncher.MAIN).getMethods())
        .anyMatch(method -> method.getName().equals("main"));
  }
}

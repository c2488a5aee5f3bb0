package org.selectiverenderer.enricher.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** The test hands over results itself, in place of the event dispatch thread. */
class VersionsUpdaterTest {
  private static final String SCENE =
      "<X3D version='4.0'><Scene><Shape DEF='Ball'><Sphere/></Shape></Scene></X3D>\n";

  @TempDir Path folder;
  private final BlockingQueue<Runnable> results = new LinkedBlockingQueue<>();
  private final VersionsModel model = new VersionsModel("Ball");
  private final List<String> failures = new ArrayList<>();

  private VersionsUpdater work() throws IOException {
    Path file = Files.writeString(folder.resolve("ball.x3d"), SCENE);
    return new VersionsUpdater(
        new EnricherSession(
            DocumentFile.open(file), NodeCatalogue.load(), new TaskExecutor(results::add), m -> {}),
        model,
        failures::add);
  }

  private void handOver() throws InterruptedException {
    Runnable result = results.poll(60, TimeUnit.SECONDS);
    assertThat(result).isNotNull();
    result.run();
  }

  @Test
  void whatIsWorkedOutArrives() throws IOException, InterruptedException {
    VersionsUpdater work = work();
    work.start();
    assertThat(work.busy()).isTrue();
    handOver();
    assertThat(model.applicable()).isTrue();
    assertThat(work.busy()).isFalse();
    assertThat(failures).isEmpty();
  }

  @Test
  void whatIsCancelledDoesNotArriveAndTheNextOneDoes() throws IOException, InterruptedException {
    VersionsUpdater work = work();
    work.start();
    work.cancel();
    assertThat(work.busy()).isFalse();
    model.add();
    work.start();
    handOver();
    if (model.result().isEmpty()) {
      handOver(); // the first one was ready before it was cancelled
    }
    assertThat(model.result().orElseThrow().versions()).hasSize(3);
  }

  @Test
  void afterTheDialogIsClosedNothingArrives() throws IOException, InterruptedException {
    VersionsUpdater work = work();
    work.start();
    work.close();
    model.add();
    assertThat(work.busy()).isFalse();
    assertThat(model.result()).isEmpty();
  }
}

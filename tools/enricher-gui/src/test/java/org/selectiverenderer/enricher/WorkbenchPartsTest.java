package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.testing.robot.GuiRobot.onEdt;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.file.CrashRecovery;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.base.trust.TrustStore;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.SettingsTrust;
import org.selectiverenderer.enricher.settings.WindowLook;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** While the views of a scene are made, the window goes on answering. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class WorkbenchPartsTest {
  @TempDir Path folder;
  private final TaskExecutor tasks = new TaskExecutor(EventQueue::invokeLater);
  private WorkbenchParts parts;

  @BeforeEach
  void open() throws IOException {
    Path scene =
        Files.writeString(
            folder.resolve("a.x3d"),
            "<X3D version='4.0'><Scene><Shape><Box/></Shape></Scene></X3D>");
    DocumentFile file = DocumentFile.open(scene);
    onEdt(
        () -> {
          WindowLook.apply(folder.resolve("settings"));
          return true;
        });
    parts =
        onEdt(
            () ->
                new WorkbenchParts(
                    new EnricherSession(file, NodeCatalogue.load(), tasks, said -> {}),
                    new EnricherSettings(folder.resolve("settings")),
                    new CrashRecovery(folder.resolve("recovery")),
                    new SettingsTrust(
                        new TrustStore(folder.resolve("settings")), (said, lines, answer) -> {})));
  }

  @AfterEach
  void end() {
    tasks.close();
  }

  private boolean dispose() {
    return onEdt(
        () -> {
          parts.dispose();
          return true;
        });
  }

  private static boolean previewing() {
    return Stream.of(threads()).anyMatch(thread -> thread.getName().startsWith("enricher-preview"));
  }

  private static Thread[] threads() {
    return Thread.getAllStackTraces().keySet().toArray(Thread[]::new);
  }

  /** Counts the events that come in between. */
  private static final class Ticks implements Runnable {
    final AtomicInteger count = new AtomicInteger();
    volatile boolean ended;

    @Override
    public void run() {
      if (!ended) {
        count.incrementAndGet();
        EventQueue.invokeLater(this);
      }
    }
  }

  @Test
  void otherEventsComeBetweenTwoViews() throws Exception {
    Ticks ticks = new Ticks();
    CompletableFuture<Integer> made = new CompletableFuture<>();
    onEdt(
        () -> {
          parts.make(() -> made.complete(ticks.count.get()));
          EventQueue.invokeLater(ticks);
          return true;
        });

    assertThat(made.get()).isGreaterThanOrEqualTo(9);
    ticks.ended = true;
    dispose();
    Eventually.await("the end of the preview", () -> !previewing());
  }

  @Test
  void whatIsDisposedOfMeanwhileIsNotMadeAndEndsItsThreads() {
    AtomicInteger made = new AtomicInteger();
    onEdt(
        () -> {
          parts.make(made::incrementAndGet);
          return true;
        });
    onEdt(() -> true); // The preview has been made.
    assertThat(previewing()).isTrue();
    dispose();

    Eventually.await("the end of the preview", () -> !previewing());
    onEdt(() -> true);
    assertThat(made).hasValue(0);
  }
}

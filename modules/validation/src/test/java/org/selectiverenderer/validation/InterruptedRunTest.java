package org.selectiverenderer.validation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;

/** An edit ends the running check of the text before it, which would slow down the window. */
class InterruptedRunTest {
  @TempDir Path folder;

  @Test
  @Timeout(60)
  void anInterruptedRunEndsBeforeItsNextCheck() throws Exception {
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch over = new CountDownLatch(1);
    CountDownLatch never = new CountDownLatch(1);
    AtomicBoolean nextRan = new AtomicBoolean();
    RuleGroup slow =
        new RuleGroup(
            "",
            List.of(),
            List.of(
                (file, findings) -> {
                  begun.countDown();
                  try {
                    never.await();
                  } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                  } finally {
                    over.countDown();
                  }
                },
                (file, findings) -> nextRan.set(true)),
            List.of());
    Path scene = Files.writeString(folder.resolve("a.x3d"), "<X3D><Scene/></X3D>");
    FutureTask<ValidationReport> run =
        new FutureTask<>(
            () ->
                new Validator(
                        new RuleCatalogue(List.of(slow)), ValidationSettings.standard(), folder)
                    .validate(List.of(SourceFile.of(scene, folder))));
    Thread caller = new Thread(run, "caller");
    caller.setDaemon(true);
    caller.start();
    begun.await();

    caller.interrupt();

    assertThatThrownBy(run::get).hasCauseInstanceOf(CancellationException.class);
    over.await();
    caller.join();
    assertThat(nextRan).isFalse();
  }
}

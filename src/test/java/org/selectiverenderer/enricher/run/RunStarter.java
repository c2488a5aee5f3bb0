package org.selectiverenderer.enricher.run;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/** A process that starts a run as the enricher does, says which process that is, and stays. */
public final class RunStarter {
  private RunStarter() {}

  public static void main(String[] words) throws IOException, InterruptedException {
    Process run = ProcessLauncher.start(List.of(words));
    System.out.println(run.pid());
    run.getInputStream().transferTo(System.err);
    new CountDownLatch(1).await(10, TimeUnit.MINUTES);
  }
}

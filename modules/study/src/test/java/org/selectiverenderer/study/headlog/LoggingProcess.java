package org.selectiverenderer.study.headlog;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/** A process that logs until it is killed, and says on its output what it handed over last. */
final class LoggingProcess {
  private LoggingProcess() {}

  public static void main(String[] args) throws Exception {
    HeadLogWriter writer =
        HeadLogWriter.open(
            HeadLogFiles.claim(Path.of(args[0]), false), HeadLogMetadata.UNKNOWN, problem -> {});
    long begun = System.nanoTime();
    ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor();
    clock.scheduleAtFixedRate(() -> add(writer, begun), 0, 4, TimeUnit.MILLISECONDS).get();
  }

  private static void add(HeadLogWriter writer, long begun) {
    double t = (System.nanoTime() - begun) * 1e-9;
    writer.add(
        new HeadSample(
            t,
            0,
            0,
            0,
            0,
            0,
            0,
            false,
            "A",
            1,
            0,
            List.of(),
            List.of(),
            4,
            HeadSample.Moment.UNTOLD,
            null));
    System.out.println(t);
  }
}

package org.selectiverenderer.study.headlog;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.locks.LockSupport;

/** A process that logs until it is killed, and says on its output what it handed over last. */
final class LoggingProcess {
  private LoggingProcess() {}

  public static void main(String[] args) throws IOException {
    HeadLogWriter writer =
        HeadLogWriter.open(
            HeadLogFiles.claim(Path.of(args[0]), false), HeadLogDescription.UNKNOWN, problem -> {});
    long begun = System.nanoTime();
    while (true) {
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
      LockSupport.parkNanos(4_000_000);
    }
  }
}

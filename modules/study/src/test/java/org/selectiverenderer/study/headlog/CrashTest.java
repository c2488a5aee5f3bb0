package org.selectiverenderer.study.headlog;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
class CrashTest {
  @TempDir private Path folder;

  @Test
  void aSessionThatIsKilledLosesAtMostTheLastSecond() throws IOException, InterruptedException {
    Path file = folder.resolve("killed.csv");
    Process process =
        new ProcessBuilder(
                ProcessHandle.current().info().command().orElse("java"),
                "-cp",
                System.getProperty("java.class.path"),
                LoggingProcess.class.getName(),
                file.toString())
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    double added = 0;
    try (BufferedReader told = process.inputReader(StandardCharsets.UTF_8)) {
      while (added < 3) {
        added = Double.parseDouble(told.readLine());
      }
      // Not Process.destroyForcibly(), which also throws away what was not read yet.
      process.toHandle().destroyForcibly();
      process.waitFor();
      // What it still said before it died.
      for (String line = told.readLine(); line != null; line = told.readLine()) {
        added = line.length() < 5 ? added : Double.parseDouble(line);
      }
    }
    List<HeadSample> samples =
        HeadLogReader.read(file, new ProblemCollector()).orElseThrow().samples();
    assertThat(samples.get(samples.size() - 1).t()).isBetween(added - 1, added + 1);
    assertThat(samples).isSortedAccordingTo((a, b) -> Double.compare(a.t(), b.t()));
  }
}

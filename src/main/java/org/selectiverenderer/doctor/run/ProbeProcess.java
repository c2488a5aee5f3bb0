package org.selectiverenderer.doctor.run;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import org.selectiverenderer.base.platform.ChildProcessCommand;
import org.selectiverenderer.base.platform.ParentProcessWatcher;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.doctor.Probe;

/** Runs a probe in a child process, and reports a crash or timeout of the process. */
public final class ProbeProcess {
  /** The prefix of a child's own lines; all other lines are output of libraries. */
  public static final String MARK = "doctor-line ";

  /** The largest number of library lines that are kept; a driver may print endlessly. */
  private static final int MOST_LINES = 200;

  /** The JVM's heading of the function that crashed. */
  private static final String FRAME = "Problematic frame:";

  private static final long LAST_WORDS_MS = 2000;

  private final BiFunction<String, List<String>, List<String>> command;

  ProbeProcess(BiFunction<String, List<String>, List<String>> command) {
    this.command = command;
  }

  /**
   * Creates a starter whose children run this program.
   *
   * @param mainClass main class of the program
   * @param arguments arguments to run one probe; the probe's name follows
   */
  public static ProbeProcess of(String mainClass, List<String> arguments) {
    return new ProbeProcess(
        (probe, flags) ->
            ChildProcessCommand.of(
                mainClass, flags, Stream.concat(arguments.stream(), Stream.of(probe)).toList()));
  }

  /** Runs a probe and returns its results; a failure is the last one. */
  List<Diagnosis> run(Probe probe) throws InterruptedException {
    try {
      // Java writes its log of a crash through a link that others may have put at its name.
      Path crashes = Files.createTempDirectory("selective-renderer-doctor-" + probe.name() + "-");
      try {
        return run(probe, crashes.resolve("crash.log"));
      } finally {
        if (Files.notExists(crashes.resolve("crash.log"))) {
          Files.deleteIfExists(crashes);
        }
      }
    } catch (IOException e) {
      return List.of(Doctor.failed(probe, "no folder can be made: " + e.getMessage(), ""));
    }
  }

  private List<Diagnosis> run(Probe probe, Path log) throws InterruptedException {
    List<String> flags =
        List.of(
            ParentProcessWatcher.flag(),
            "-XX:-CreateCoredumpOnCrash",
            "-XX:ErrorFile=" + log.toString().replace("%", "%%"));
    Process process;
    try {
      process =
          new ProcessBuilder(command.apply(probe.name(), flags)).redirectErrorStream(true).start();
      process.getOutputStream().close();
    } catch (IOException e) {
      return List.of(Doctor.failed(probe, "no process can be started: " + e.getMessage(), ""));
    }
    Output output = new Output();
    Thread reader = new Thread(() -> output.read(process), "doctor-" + probe.name() + "-output");
    reader.setDaemon(true);
    reader.start();
    boolean ended = false;
    try {
      ended = process.waitFor(probe.limit().toMillis(), TimeUnit.MILLISECONDS);
    } finally {
      process.descendants().forEach(ProcessHandle::destroyForcibly);
      process.toHandle().destroyForcibly(); // The process itself would drop what is still unread.
    }
    reader.join(LAST_WORDS_MS);
    List<Diagnosis> lines = output.lines();
    if (!ended) {
      lines.add(Doctor.late(probe));
    } else if (process.exitValue() != 0) {
      lines.add(dead(probe, process.exitValue(), output, log));
    } else if (lines.isEmpty()) {
      lines.add(Doctor.failed(probe, "no answer" + output.reason(), ""));
    }
    return lines;
  }

  private static Diagnosis dead(Probe probe, int status, Output output, Path log) {
    return Doctor.failed(
        probe,
        "the process of this check ended with status %d%s".formatted(status, output.reason()),
        Files.exists(log)
            ? "install another version of this driver or library; attach " + log + " to a report"
            : "install another version of this driver or library");
  }

  /** The output of a child process; written by one thread, read by another. */
  private static final class Output {
    private final List<Diagnosis> lines = new ArrayList<>();
    private final List<String> others = new ArrayList<>();

    void read(Process process) {
      try (BufferedReader text =
          new BufferedReader(
              new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
        for (String line = text.readLine(); line != null; line = text.readLine()) {
          take(line);
        }
      } catch (IOException e) {
        // The process was killed while it wrote; what it wrote before is kept.
      }
    }

    private synchronized void take(String line) {
      Optional<Diagnosis> own =
          line.startsWith(MARK) ? Diagnosis.read(line.substring(MARK.length())) : Optional.empty();
      own.ifPresent(lines::add);
      if (own.isEmpty() && others.size() < MOST_LINES) {
        others.add(line);
      }
    }

    synchronized List<Diagnosis> lines() {
      return new ArrayList<>(lines);
    }

    /** Returns the function that crashed, else the last line, after a colon. */
    synchronized String reason() {
      for (int at = 0; at + 1 < others.size(); at++) {
        if (others.get(at).contains(FRAME)) {
          return ": crashed in " + others.get(at + 1).replaceFirst("^#\\s*", "");
        }
      }
      return others.stream()
          .filter(line -> !line.isBlank())
          .reduce((first, last) -> last)
          .map(line -> ": " + line.strip())
          .orElse("");
    }
  }
}

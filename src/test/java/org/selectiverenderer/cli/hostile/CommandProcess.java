package org.selectiverenderer.cli.hostile;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;

/** Commands in a process of their own, with limits of time and memory. */
final class CommandProcess implements AutoCloseable {
  /** A command that ended. */
  record Result(int status, String out, String err) {}

  private final Path folder;
  private final int seconds;
  private final ExecutorService reading =
      Executors.newSingleThreadExecutor(
          task -> {
            Thread thread = new Thread(task, "hostile-results");
            thread.setDaemon(true);
            return thread;
          });
  private @Nullable Process process;

  /**
   * Starts no process yet.
   *
   * @param folder where the process works
   * @param seconds the most that a command may take
   */
  CommandProcess(Path folder, int seconds) {
    this.folder = folder;
    this.seconds = seconds;
  }

  /**
   * Runs a command.
   *
   * @throws IOException if it ended the process, or took too long, after which the process is ended
   */
  Result run(List<String> command) throws IOException, InterruptedException {
    Process running = running();
    try {
      Writer commands = new OutputStreamWriter(running.getOutputStream(), StandardCharsets.UTF_8);
      commands.write(String.join("\t", command) + "\n");
      commands.flush();
      BufferedReader results = running.inputReader(StandardCharsets.US_ASCII);
      String line = reading.submit(results::readLine).get(seconds, TimeUnit.SECONDS);
      if (line == null) {
        running.waitFor();
        throw new IOException("the process ended with " + running.exitValue());
      }
      String[] result = line.split(" ");
      return new Result(Integer.parseInt(result[0]), text(result[1]), text(result[2]));
    } catch (TimeoutException e) {
      String stack = stack(running);
      close();
      throw new IOException("it takes more than " + seconds + " s" + stack, e);
    } catch (ExecutionException | IOException e) {
      close();
      throw new IOException(e.getMessage(), e);
    }
  }

  private Process running() throws IOException {
    if (process == null || !process.isAlive()) {
      ProcessBuilder builder =
          new ProcessBuilder(
              ProcessHandle.current().info().command().orElseThrow(),
              "-Xmx512m",
              "-XX:+UseSerialGC",
              "-XX:TieredStopAtLevel=1",
              "-Djava.awt.headless=true",
              "-Djava.io.tmpdir=" + folder.resolve("tmp"),
              "-Duser.home=" + folder.resolve("home"),
              "-cp",
              System.getProperty("java.class.path"),
              CommandLoop.class.getName());
      builder.environment().put("HOME", folder.resolve("home").toString());
      builder.environment().keySet().removeIf(name -> name.startsWith("XDG_"));
      builder.directory(folder.toFile());
      builder.redirectError(ProcessBuilder.Redirect.DISCARD);
      Files.createDirectories(folder.resolve("tmp"));
      Files.createDirectories(folder.resolve("home"));
      process = builder.start();
    }
    return process;
  }

  private static String text(String base64) {
    return new String(Base64.getDecoder().decode(base64.substring(1)), StandardCharsets.UTF_8);
  }

  /** Returns where the command is, if the JDK's tool says so; else nothing. */
  private static String stack(Process running) {
    try {
      Path jstack = Path.of(System.getProperty("java.home"), "bin", "jstack");
      Process tool =
          new ProcessBuilder(jstack.toString(), Long.toString(running.pid()))
              .redirectErrorStream(true)
              .start();
      String all = new String(tool.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      return all.lines()
          .filter(line -> line.contains("org.selectiverenderer"))
          .limit(12)
          .reduce("", (before, line) -> before + "\n" + line);
    } catch (IOException e) {
      return "";
    }
  }

  @Override
  public void close() {
    if (process != null) {
      process.destroyForcibly();
      process = null;
    }
  }
}

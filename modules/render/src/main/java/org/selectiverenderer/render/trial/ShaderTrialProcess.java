package org.selectiverenderer.render.trial;

import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.platform.ChildProcessCommand;
import org.selectiverenderer.base.platform.ChildProcessWatchdog;
import org.selectiverenderer.render.glsl.GlslTranslator;

/**
 * Tries shader programs in a child process, one after another, and tells which of them the graphics
 * driver cannot compile and run within limits. The process is started when it is first needed, ends
 * when nothing is tried for some seconds, and is then started again. Not thread-safe.
 */
public final class ShaderTrialProcess implements AutoCloseable {
  /** The first byte of each program that the child is given. */
  static final int PROGRAM = 1;

  // The child's answers are bytes that no text in UTF-8 has, since drivers may print beside them.

  /** The child's answer when it can try programs. */
  static final int READY = 0xfd;

  /** The child's answer when it has tried a program, whatever the compiler said. */
  static final int TRIED = 0xfe;

  /** The child's answer, before a text, when it cannot try programs. */
  static final int UNABLE = 0xff;

  /**
   * The time without a program after which the process is replaced, as it ends itself. Long, since
   * scripts may bring in programs while the scene runs, which then waits for a start.
   */
  static final Duration IDLE = Duration.ofMinutes(5);

  private static final int BUFFER = 1 << 16;

  /** A driver may take two minutes to begin on a busy machine. */
  private static final Duration START = Duration.ofMinutes(2);

  private static final String CHILD =
      "the graphics driver, which tried it in a process of its own,";

  private final List<String> command;
  private final Duration time;
  private final Duration all;
  private final long memory;
  private @Nullable Process process;
  private long used;
  private long spent;
  private @Nullable String unable;

  /**
   * Creates a trial of 10 seconds and 2 GiB for each program, and 30 seconds for all. Starts no
   * process yet.
   */
  public ShaderTrialProcess() {
    this(
        ChildProcessCommand.contained(
            ShaderTrialMain.class.getName(),
            List.of("jogl.", "jogamp.common.", "newt.", "nativewindow.")),
        Duration.ofSeconds(10),
        Duration.ofSeconds(30),
        2L << 30);
  }

  ShaderTrialProcess(List<String> command, Duration time, Duration all, long memory) {
    this.command = command;
    this.time = time;
    this.all = all;
    this.memory = memory;
  }

  /**
   * Tries a program. Blocks until it has been compiled and has drawn a point, or the limits end it.
   *
   * @param units the translated texts of its stages
   * @param attributes the locations of its vertex attributes by name
   * @return what is wrong with it, a clause; empty if it is safe to compile, which may still fail
   *     with a message of the compiler
   */
  public Optional<String> refusal(
      List<GlslTranslator.Unit> units, Map<String, Integer> attributes) {
    if (unable != null) {
      return Optional.of(unable);
    }
    if (spent > all.toNanos()) {
      return Optional.of(
          "the scene's shaders together took more than %d s to try".formatted(all.toSeconds()));
    }
    Process child;
    try {
      child = running();
    } catch (IOException e) {
      close();
      unable = "the process that tries it cannot be started: " + e.getMessage();
      return Optional.of(unable);
    }
    long start = System.nanoTime();
    try {
      return answer(child, units, attributes);
    } finally {
      used = System.nanoTime();
      spent += used - start;
    }
  }

  private Optional<String> answer(
      Process child, List<GlslTranslator.Unit> units, Map<String, Integer> attributes) {
    try (ChildProcessWatchdog watchdog = new ChildProcessWatchdog(child, CHILD, time, memory)) {
      try {
        write(
            new DataOutputStream(new BufferedOutputStream(child.getOutputStream(), BUFFER)),
            units,
            attributes);
        if (answer(child.getInputStream()) == TRIED) {
          return Optional.empty();
        }
      } catch (IOException e) {
        // The process has ended, of itself or by the watchdog.
      }
      close();
      return Optional.of(watchdog.verdict().orElse(CHILD + " ended unexpectedly"));
    }
  }

  /** Returns the child's next answer; -1 when it has ended. */
  private static int answer(InputStream in) throws IOException {
    int answer = in.read();
    while (answer >= 0 && answer < READY) {
      answer = in.read(); // Something that the driver printed.
    }
    return answer;
  }

  private Process running() throws IOException {
    Process child = process;
    if (child != null && child.isAlive() && System.nanoTime() - used < IDLE.toNanos()) {
      return child;
    }
    close();
    child = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
    process = child;
    try (ChildProcessWatchdog watchdog = new ChildProcessWatchdog(child, "it", START, memory)) {
      DataInputStream in = new DataInputStream(child.getInputStream());
      int answer = answer(in);
      if (answer == UNABLE) {
        throw new IOException(in.readUTF());
      }
      if (answer != READY) {
        throw new IOException(watchdog.verdict().orElse("it ended unexpectedly"));
      }
    }
    used = System.nanoTime();
    return child;
  }

  private static void write(
      DataOutputStream out, List<GlslTranslator.Unit> units, Map<String, Integer> attributes)
      throws IOException {
    out.writeByte(PROGRAM);
    out.writeInt(attributes.size());
    for (Map.Entry<String, Integer> attribute : attributes.entrySet()) {
      write(out, attribute.getKey());
      out.writeInt(attribute.getValue());
    }
    out.writeInt(units.size());
    for (GlslTranslator.Unit unit : units) {
      out.writeByte(unit.stage().ordinal());
      write(out, unit.text());
    }
    out.flush();
  }

  private static void write(DataOutputStream out, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    out.writeInt(bytes.length);
    out.write(bytes);
  }

  /** Ends the process, if it runs. */
  @Override
  public void close() {
    if (process != null) {
      process.destroyForcibly();
      process = null;
    }
  }
}

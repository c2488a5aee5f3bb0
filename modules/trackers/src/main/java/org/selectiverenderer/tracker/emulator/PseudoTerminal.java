package org.selectiverenderer.tracker.emulator;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.tracker.TrackerException;

/**
 * A pseudo-terminal: a device file that a program opens like a serial port, with the other end as
 * two streams. The program may close and reopen it; {@link #close} is like unplugging the cable.
 */
public final class PseudoTerminal implements AutoCloseable {
  /** Programs that create pseudo-terminals, the preferred one first. */
  public enum Maker {
    /** The program socat, made for this. */
    SOCAT("socat"),
    /** The program script of util-linux, made to record terminal sessions. */
    SCRIPT("script");

    private final String command;

    Maker(String command) {
      this.command = command;
    }

    /** Returns whether the program is installed. */
    public boolean installed() {
      String path = Optional.ofNullable(System.getenv("PATH")).orElse("");
      return Stream.of(path.split(File.pathSeparator))
          .filter(folder -> !folder.isEmpty())
          .anyMatch(folder -> Files.isExecutable(Path.of(folder, command)));
    }
  }

  private final Path link;
  private final Process maker;

  private PseudoTerminal(Path link, Process maker) {
    this.link = link;
    this.maker = maker;
  }

  /**
   * Creates a terminal with the first program that is installed.
   *
   * @param link path of the symbolic link to the terminal; an existing link is replaced
   * @throws TrackerException if there is no such program
   * @throws IOException if the terminal or the link cannot be created
   */
  public static PseudoTerminal open(Path link) throws IOException {
    Maker maker =
        Stream.of(Maker.values())
            .filter(Maker::installed)
            .findFirst()
            .orElseThrow(() -> new TrackerException(noMaker(System.getProperty("os.name", ""))));
    return open(link, maker);
  }

  /**
   * Returns what to do where no program makes a pseudo-terminal.
   *
   * @param system the name of the operating system, as in {@code os.name}
   */
  static String noMaker(String system) {
    return system.toLowerCase(Locale.ROOT).startsWith("windows")
        ? "Windows has no pseudo-terminals for an emulated tracker: play a recording instead"
            + " (replay:FILE.csv), or emulate on Linux or macOS"
        : "a pseudo-terminal needs the program socat or script; install socat (on Debian and"
            + " Ubuntu: sudo apt install socat)";
  }

  /** Creates a terminal with the given program. */
  public static PseudoTerminal open(Path link, Maker maker) throws IOException {
    if (Files.exists(link, LinkOption.NOFOLLOW_LINKS) && !Files.isSymbolicLink(link)) {
      throw new TrackerException(link + " exists and is not a link; it is not replaced");
    }
    Process process =
        new ProcessBuilder(command(maker, holding(ProcessHandle.current().pid())))
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      String device = line(process.getInputStream());
      Files.deleteIfExists(link);
      Files.createSymbolicLink(link, Path.of(device));
      return new PseudoTerminal(link, process);
    } catch (IOException e) {
      process.destroyForcibly();
      throw e;
    }
  }

  /**
   * Returns a shell command that prints the terminal's name, holds the terminal open when the
   * program at its other end closes it, and ends with this program.
   */
  private static String holding(long pid) {
    return "stty raw -echo; tty; while kill -0 " + pid + " 2>/dev/null; do sleep 1; done";
  }

  private static List<String> command(Maker maker, String shell) {
    return switch (maker) {
      case SOCAT -> List.of("socat", "STDIO", "SYSTEM:" + shell + ",pty,setsid,ctty");
      case SCRIPT -> List.of("script", "-q", "-c", shell, "/dev/null");
    };
  }

  private static String line(InputStream from) throws IOException {
    StringBuilder line = new StringBuilder();
    int next = from.read();
    while (next >= 0 && next != '\n') {
      if (next != '\r') {
        line.append((char) next);
      }
      next = from.read();
    }
    if (next < 0) {
      throw new TrackerException("the pseudo-terminal could not be made");
    }
    return line.toString();
  }

  /** Returns the stream of the bytes that the program at the other end writes. */
  public InputStream input() {
    return maker.getInputStream();
  }

  /** Returns the stream to that program; it must be flushed. */
  public OutputStream output() {
    return maker.getOutputStream();
  }

  /**
   * Closes the terminal, also for the program at the other end, and removes the link.
   *
   * @throws IOException if the link cannot be removed
   */
  @Override
  public void close() throws IOException {
    maker.destroyForcibly();
    Files.deleteIfExists(link);
  }
}

package org.selectiverenderer.cli.bundle;

import java.awt.GraphicsEnvironment;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JOptionPane;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.platform.ChildProcessCommand;

/**
 * Adapts the program to a start from a desktop instead of a terminal: the arguments are only files,
 * and error messages are shown in a window, because standard error is invisible.
 */
public final class DesktopLauncherAdapter {
  /** The environment variable that Linux desktop entries set, whose command lines are complete. */
  private static final String VARIABLE = "SELECTIVE_RENDERER_DESKTOP";

  private static final String START = "start";

  private final @Nullable String command;
  private final boolean clicked;
  private final boolean unseen;
  private final TeeOutputBuffer heard = new TeeOutputBuffer();

  /**
   * @param command {@code run} or {@code enrich}, the command to execute with a file; null where
   *     the arguments contain the command
   * @param clicked whether the program itself was opened by a double click
   */
  DesktopLauncherAdapter(
      @Nullable String command, Map<String, String> environment, boolean clicked) {
    this.command = command;
    this.clicked = clicked;
    this.unseen = command != null || clicked || environment.containsKey(VARIABLE);
  }

  /** Detects how this process was started. */
  public static DesktopLauncherAdapter ofProcess() {
    return new DesktopLauncherAdapter(
        System.getProperty(ChildProcessCommand.DESKTOP), System.getenv(), DoubleClick.started());
  }

  /**
   * Returns the program's arguments: the command is put before a file. Without a file the enricher
   * opens empty, and in the viewer's place, which shows nothing without one, the start window.
   */
  public String[] arguments(String[] given) {
    if (command == null) {
      boolean nothing = given.length == 0 && clicked;
      boolean noScene = given.length == 1 && given[0].equals("run") && unseen;
      return nothing || noScene ? new String[] {START} : given;
    }
    if (given.length == 0) {
      return new String[] {command.equals("run") ? START : command};
    }
    return Stream.concat(Stream.of(command), Stream.of(given)).toArray(String[]::new);
  }

  /**
   * Returns the stream for messages: the given one, which is also recorded in memory where it is
   * invisible.
   */
  public OutputStream messages(OutputStream err) {
    return unseen ? heard.before(err) : err;
  }

  /** Returns the message to show when the program ends with a status; empty for none. */
  Optional<String> complaint(int status) {
    return Optional.of(heard.text().strip()).filter(text -> status != 0 && !text.isEmpty());
  }

  /**
   * Shows the error messages of a failed program that were invisible; the window outlives this
   * process.
   */
  public void tell(int status) {
    complaint(status).ifPresent(DesktopLauncherAdapter::show);
  }

  /** Shows a text in a separate process, because this Java process may already be headless. */
  private static void show(String text) {
    try {
      Process window =
          new ProcessBuilder(
                  ChildProcessCommand.of(DesktopErrorDialog.class.getName(), List.of(), List.of()))
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      try (OutputStream in = window.getOutputStream()) {
        in.write(text.getBytes(StandardCharsets.UTF_8));
      }
    } catch (IOException e) {
      // The text went to standard error too; there is no other place to report it.
    }
  }

  /** A program that shows the text of its standard input in a window until the user closes it. */
  private static final class DesktopErrorDialog {
    private static final int COLUMNS = 70;
    private static final int ROWS = 8;

    private DesktopErrorDialog() {}

    public static void main(String[] args) throws IOException {
      String text = new String(System.in.readAllBytes(), StandardCharsets.UTF_8);
      if (!GraphicsEnvironment.isHeadless()) {
        SwingUtilities.invokeLater(() -> show(text));
      }
    }

    /** Shows the text in a text area, so that the user can copy it. */
    private static void show(String text) {
      JTextArea area = new JTextArea(text, ROWS, COLUMNS);
      area.setEditable(false);
      area.setLineWrap(true);
      area.setWrapStyleWord(true);
      area.setCaretPosition(0);
      JOptionPane.showMessageDialog(
          null, new JScrollPane(area), "Selective Renderer", JOptionPane.ERROR_MESSAGE);
      System.exit(0);
    }
  }

  /** Records the last characters that are written to another stream. The class is thread-safe. */
  private static final class TeeOutputBuffer {
    private static final int KEPT = 4000;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    /** Returns a stream that records its data and passes it on. */
    OutputStream before(OutputStream next) {
      return new OutputStream() {
        @Override
        public void write(int one) throws IOException {
          write(new byte[] {(byte) one}, 0, 1);
        }

        /** Records the data first, because the other stream may be a missing console. */
        @Override
        public void write(byte[] from, int offset, int length) throws IOException {
          hear(from, offset, length);
          next.write(from, offset, length);
        }

        @Override
        public void flush() throws IOException {
          next.flush();
        }
      };
    }

    private synchronized void hear(byte[] from, int offset, int length) {
      bytes.write(from, offset, length);
      if (bytes.size() > 2 * KEPT) {
        byte[] all = bytes.toByteArray();
        bytes.reset();
        bytes.write(all, all.length - KEPT, KEPT);
      }
    }

    /** Returns the recorded text; if there was more, it starts at the beginning of a line. */
    synchronized String text() {
      String all = bytes.toString(StandardCharsets.UTF_8);
      return all.length() <= KEPT ? all : all.substring(all.indexOf('\n', all.length() - KEPT) + 1);
    }
  }
}

package org.selectiverenderer.enricher.robot;

import static org.selectiverenderer.enricher.EventThread.edt;
import static org.selectiverenderer.enricher.EventThread.get;

import java.awt.AWTException;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JTextField;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.robot.GuiRobot;

/**
 * Types without looking at the screen, with the keyboard at first in the field of a window. Openbox
 * manages the windows where it is installed, unless another window manager runs.
 */
public final class FastTypist implements AutoCloseable {
  private final GuiRobot hands = new GuiRobot();
  private final JFrame window = get(() -> new JFrame("Below"));
  private final JTextField below = get(JTextField::new);
  private final Optional<Process> manager;
  private final Robot robot;

  public FastTypist() throws AWTException, IOException {
    robot = new Robot();
    manager = manager();
    TestSessions.theme(false);
    edt(
        () -> {
          below.getAccessibleContext().setAccessibleName("Below");
          window.getContentPane().add(below);
          window.setBounds(20, 20, 500, 300);
        });
    hands.show(window);
    hands.click(below);
  }

  /** Starts openbox and waits until it manages the windows: keys typed before that are lost. */
  private static Optional<Process> manager() throws IOException {
    Path folder = Files.createTempDirectory("openbox");
    Path started = folder.resolve("started");
    try {
      Process openbox = new ProcessBuilder("openbox", "--startup", "mkdir " + started).start();
      // it ends where another one runs
      Eventually.await("openbox", () -> Files.exists(started) || !openbox.isAlive());
      return Optional.of(openbox);
    } catch (IOException e) {
      return Optional.empty(); // not installed
    } finally {
      Files.deleteIfExists(started);
      Files.delete(folder);
    }
  }

  /** The window over which dialogs open. */
  public JFrame window() {
    return window;
  }

  /** The field in the window. */
  public JTextField below() {
    return below;
  }

  /** Presses a key and lets it go. */
  public void stroke(int key) {
    robot.keyPress(key);
    robot.keyRelease(key);
  }

  /** Types small letters and digits. */
  public void type(String text) {
    text.chars().forEach(each -> stroke(KeyEvent.getExtendedKeyCodeForChar(each)));
  }

  /** Puts the keyboard back into the window's field. */
  public void goBack() {
    if (!GuiRobot.has(below::isFocusOwner)) {
      hands.click(below); // without a window manager nobody gives the keyboard back
    }
  }

  /** Closes all dialogs. */
  public static void closeDialogs() {
    edt(
        () -> {
          for (Window each : Window.getWindows()) {
            if (each instanceof JDialog) {
              each.dispose();
            }
          }
        });
  }

  @Override
  public void close() {
    edt(window::dispose);
    manager.ifPresent(
        process -> {
          process.destroy();
          process.onExit().join();
        });
  }
}

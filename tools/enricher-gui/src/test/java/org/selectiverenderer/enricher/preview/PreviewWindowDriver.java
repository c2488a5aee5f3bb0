package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.enricher.EventThread.edt;
import static org.selectiverenderer.enricher.EventThread.get;

import java.awt.AWTException;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import javax.imageio.ImageIO;
import javax.swing.JFrame;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.testing.robot.DisplaySettling;
import org.selectiverenderer.testing.robot.RobotEventSync;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** A window with a preview in it, driven by a robot; waits for frames, not for time. */
final class PreviewWindowDriver implements AutoCloseable {
  static final int WIDTH = 640;
  static final int HEIGHT = 480;
  private static final long PATIENCE = 60;

  final EnricherSession session;
  final PreviewPanel panel;
  final Robot robot;
  private final TaskExecutor tasks = new TaskExecutor(EventQueue::invokeLater);
  private final JFrame window;
  private final LinkedBlockingQueue<PreviewFrame> frames = new LinkedBlockingQueue<>();

  PreviewWindowDriver(Path scene) throws IOException, AWTException {
    DocumentFile file = DocumentFile.open(scene);
    session = get(() -> new EnricherSession(file, NodeCatalogue.load(), tasks, sentence -> {}));
    panel =
        get(
            () -> {
              PreviewPanel made = new PreviewPanel(session);
              made.onFrame(frames::add);
              return made;
            });
    window =
        get(
            () -> {
              JFrame made = new JFrame("Preview");
              made.add(panel);
              made.setBounds(20, 20, WIDTH, HEIGHT);
              made.setVisible(true);
              return made;
            });
    robot = new Robot();
    robot.setAutoDelay(5);
  }

  /** The next frame that is as wanted. */
  PreviewFrame await(Predicate<PreviewFrame> wanted) throws InterruptedException {
    PreviewFrame last = null;
    while (true) {
      PreviewFrame frame = frames.poll(PATIENCE, TimeUnit.SECONDS);
      assertThat(frame).as("a frame after %s", last).isNotNull();
      if (wanted.test(frame)) {
        return frame;
      }
      last = frame;
    }
  }

  /** A frame of the whole picture's size. */
  PreviewFrame awaitPicture() throws InterruptedException {
    return await(
        frame -> {
          int width = get(() -> panel.view().getWidth());
          return frame.image().getWidth() == width;
        });
  }

  /** Clicks at a place of the picture, in its pixels. */
  void click(int x, int y) {
    click(x, y, InputEvent.BUTTON1_DOWN_MASK);
  }

  /** The same with a button of the mouse. */
  void click(int x, int y, int button) {
    Point origin = get(() -> panel.view().getLocationOnScreen());
    RobotEventSync.of(
        MouseEvent.MOUSE_RELEASED,
        1,
        () -> {
          robot.mouseMove(origin.x + x, origin.y + y);
          robot.mousePress(button);
          robot.mouseRelease(button);
        });
  }

  /** Drags from a place of the picture to another one, in its pixels, without letting go. */
  void drag(int fromX, int fromY, int toX, int toY) {
    takeKeyboard(5, 5);
    Point origin = get(() -> panel.view().getLocationOnScreen());
    robot.mouseMove(origin.x + fromX, origin.y + fromY);
    RobotEventSync.of(
        MouseEvent.MOUSE_PRESSED, 1, () -> robot.mousePress(InputEvent.BUTTON1_DOWN_MASK));
    for (int share = 1; share <= 2; share++) {
      int x = origin.x + fromX + (toX - fromX) * share / 2;
      int y = origin.y + fromY + (toY - fromY) * share / 2;
      RobotEventSync.of(MouseEvent.MOUSE_DRAGGED, 1, () -> robot.mouseMove(x, y));
    }
  }

  /** Lets go. */
  void drop() {
    RobotEventSync.of(
        MouseEvent.MOUSE_RELEASED, 1, () -> robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK));
  }

  /** Lets what is done elsewhere arrive. */
  void settle() {
    DisplaySettling.awaitWindow();
  }

  /**
   * Clicks at a place of the picture until it has the keyboard: without a window manager a window
   * that has just come up may miss the first click.
   */
  void takeKeyboard(int x, int y) {
    for (int tries = 0; tries < 20; tries++) {
      edt(window::toFront);
      click(x, y);
      if (get(() -> panel.view().isFocusOwner())) {
        return;
      }
    }
    throw new AssertionError("the picture does not get the keyboard");
  }

  void screenshot(String name) throws IOException {
    BufferedImage image =
        get(
            () -> {
              BufferedImage made =
                  new BufferedImage(
                      window.getWidth(), window.getHeight(), BufferedImage.TYPE_INT_RGB);
              window.getContentPane().paint(made.getGraphics());
              return made;
            });
    ImageIO.write(image, "png", Path.of("target", name + ".png").toFile());
  }

  @Override
  public void close() {
    edt(
        () -> {
          panel.dispose();
          window.dispose();
          session.dispose();
          tasks.close();
        });
  }
}

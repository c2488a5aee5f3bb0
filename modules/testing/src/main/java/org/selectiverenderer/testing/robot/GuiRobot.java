package org.selectiverenderer.testing.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.selectiverenderer.testing.Eventually;

/** Mouse and keyboard on the components of a window, which are found by their accessible names. */
public final class GuiRobot {
  /** Milliseconds that the effect of a click takes at most on a busy machine. */
  private static final int EFFECT = 3_000;

  private static final int TRIES = 3;
  private final Robot robot;

  public GuiRobot() {
    try {
      robot = new Robot();
    } catch (AWTException e) {
      throw new AssertionError(e);
    }
    robot.setAutoDelay(5);
  }

  /** Does something on the event dispatch thread and gives its result. */
  public static <T> T onEdt(Callable<T> work) {
    FutureTask<T> task = new FutureTask<>(work);
    try {
      SwingUtilities.invokeAndWait(task);
      return task.get();
    } catch (InterruptedException | InvocationTargetException e) {
      throw new AssertionError(e);
    } catch (java.util.concurrent.ExecutionException e) {
      throw new AssertionError(e.getCause());
    }
  }

  /**
   * Shows a window; one that is modal is waited for until it is there. Without a window manager the
   * X server may put it elsewhere than AWT believes, until it is moved.
   */
  public void show(Window window) {
    SwingUtilities.invokeLater(() -> window.setVisible(true));
    await("the window", window::isShowing);
    DisplaySettling.awaitWindow();
    onEdt(
        () -> {
          Point wanted = window.getLocation();
          window.setLocation(wanted.x + 1, wanted.y + 1);
          window.setLocation(wanted);
          window.toFront();
          return true;
        });
    DisplaySettling.awaitWindow();
  }

  /** Waits until something is so. */
  public void await(String what, BooleanSupplier so) {
    Eventually.await(
        () -> {
          write(screen(), "screen-when-waited-in-vain");
          return what;
        },
        () -> onEdt(so::getAsBoolean));
  }

  /** Waits for a dialog to show and gives it. */
  public <T extends JDialog> T dialog(Class<T> type) {
    await("a dialog", () -> showing(type) != null);
    DisplaySettling.awaitWindow();
    T dialog = onEdt(() -> showing(type));
    assertThat(dialog).isNotNull();
    return dialog;
  }

  private static <T extends JDialog> @org.jspecify.annotations.Nullable T showing(Class<T> type) {
    for (Window window : Window.getWindows()) {
      if (type.isInstance(window) && window.isShowing()) {
        return type.cast(window);
      }
    }
    return null;
  }

  /**
   * Clicks the button of that text and waits for the dialog's end. Without a window manager AWT may
   * believe a dialog that has just come up to be elsewhere, until it is moved, or never give it the
   * keyboard: then clicks miss it. A button that the mouse could hit is pressed in the end without.
   */
  public void choose(JDialog dialog, String button) {
    JButton chosen = named(dialog, button, JButton.class);
    click(chosen);
    for (int tries = 0; tries < TRIES && !has(() -> !dialog.isShowing()); tries++) {
      int step = tries % 2 == 0 ? 1 : -1;
      onEdt(
          () -> {
            dialog.setLocation(dialog.getX() + step, dialog.getY() + step);
            dialog.toFront();
            return chosen.requestFocusInWindow();
          });
      DisplaySettling.awaitWindow();
      if (onEdt(dialog::isShowing)) {
        click(chosen);
      }
      if (!has(() -> !dialog.isShowing())) {
        press(KeyEvent.VK_SPACE);
      }
    }
    if (!has(() -> !dialog.isShowing())) {
      assertThat(onEdt(() -> reachable(dialog, chosen)))
          .as("the mouse can hit the button " + button)
          .isTrue();
      SwingUtilities.invokeLater(chosen::doClick);
    }
    await("the end of the dialog", () -> !dialog.isShowing());
  }

  /** Waits for the effect of a click and returns whether it came. */
  public static boolean has(BooleanSupplier so) {
    return Eventually.within(EFFECT, TimeUnit.MILLISECONDS, () -> onEdt(so::getAsBoolean));
  }

  /** Whether all of a button shows on the screen, enabled, with nothing of the dialog over it. */
  private static boolean reachable(JDialog dialog, JButton button) {
    Rectangle shown = button.getVisibleRect();
    Rectangle onScreen = new Rectangle(button.getLocationOnScreen(), button.getSize());
    Point middle =
        SwingUtilities.convertPoint(
            button, button.getWidth() / 2, button.getHeight() / 2, dialog.getContentPane());
    return button.isShowing()
        && button.isEnabled()
        && shown.getSize().equals(button.getSize())
        && dialog.getGraphicsConfiguration().getBounds().contains(onScreen)
        && SwingUtilities.getDeepestComponentAt(dialog.getContentPane(), middle.x, middle.y)
            == button;
  }

  /** The component of that accessible name. */
  public static <T extends Component> T named(Container in, String name, Class<T> type) {
    return onEdt(
        () -> {
          T found = find(in, name, type);
          if (found == null) {
            throw new AssertionError("no " + type.getSimpleName() + " is called " + name);
          }
          return found;
        });
  }

  private static <T extends Component> @org.jspecify.annotations.Nullable T find(
      Container in, String name, Class<T> type) {
    for (Component each : in.getComponents()) {
      boolean called =
          each.getAccessibleContext() != null
              && name.equals(each.getAccessibleContext().getAccessibleName());
      if (called && type.isInstance(each)) {
        return type.cast(each);
      }
      T within = each instanceof Container more ? find(more, name, type) : null;
      if (within != null) {
        return within;
      }
    }
    return null;
  }

  /**
   * Clicks a component. A text gets the keyboard by that, which is waited for: without a window
   * manager nobody has it for a while after a dialog has gone, and what is typed then is lost.
   */
  public void click(Component component) {
    click(component, onEdt(() -> inView(component)));
    if (!(component instanceof JTextComponent) || !component.isFocusable()) {
      return;
    }
    for (int tries = 0; tries < TRIES && !has(component::isFocusOwner); tries++) {
      onEdt(
          () -> {
            SwingUtilities.getWindowAncestor(component).toFront();
            return component.requestFocusInWindow();
          });
      DisplaySettling.awaitWindow();
      click(component, onEdt(() -> inView(component)));
    }
    await(
        "the keyboard in " + component.getAccessibleContext().getAccessibleName(),
        component::isFocusOwner);
  }

  /**
   * The part of a component that can be seen, after it is scrolled into view as a user would do it:
   * the middle of a large text is outside its window.
   */
  private static Rectangle inView(Component component) {
    if (component.getParent() instanceof JComponent around) {
      around.scrollRectToVisible(component.getBounds()); // text fields would scroll only their text
    }
    return component instanceof JComponent of && !of.getVisibleRect().isEmpty()
        ? of.getVisibleRect()
        : new Rectangle(component.getSize());
  }

  /** Clicks a cell of a table by its place on the screen. */
  public void click(JTable table, int row, int column) {
    Rectangle cell =
        onEdt(
            () -> {
              table.scrollRectToVisible(table.getCellRect(row, column, true));
              return table.getCellRect(row, column, true);
            });
    click(table, cell);
  }

  private void click(Component component, Rectangle area) {
    Point at = onEdt(component::getLocationOnScreen);
    RobotEventSync.of(
        MouseEvent.MOUSE_RELEASED,
        1,
        () -> {
          robot.mouseMove(at.x + area.x + area.width / 2, at.y + area.y + area.height / 2);
          robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
          robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        });
  }

  /** Presses keys, all at once, and lets them go. */
  public void press(int... keys) {
    RobotEventSync.of(
        KeyEvent.KEY_RELEASED,
        keys.length,
        () -> {
          for (int key : keys) {
            robot.keyPress(key);
          }
          for (int i = keys.length - 1; i >= 0; i--) {
            robot.keyRelease(keys[i]);
          }
        });
  }

  /** Drags over a part of a component, from one share of its width and height to another. */
  public void drag(Component component, double fromX, double fromY, double toX, double toY) {
    Rectangle on = onEdt(() -> new Rectangle(component.getLocationOnScreen(), component.getSize()));
    RobotEventSync.of(
        MouseEvent.MOUSE_RELEASED,
        1,
        () -> {
          robot.mouseMove(at(on.x, on.width, fromX), at(on.y, on.height, fromY));
          robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
          for (int i = 1; i <= 4; i++) {
            double share = i / 4.0;
            robot.mouseMove(
                at(on.x, on.width, fromX + share * (toX - fromX)),
                at(on.y, on.height, fromY + share * (toY - fromY)));
          }
          robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        });
  }

  private static int at(int start, int length, double share) {
    return start + (int) Math.round(share * length);
  }

  /** Writes letters without accents, digits, points, minus signs and underscores. */
  public void write(String text) {
    for (char each : text.toCharArray()) {
      int key =
          switch (each) {
            case '_', '-' -> KeyEvent.VK_MINUS;
            case '.' -> KeyEvent.VK_PERIOD;
            default -> Character.toUpperCase(each);
          };
      if (Character.isUpperCase(each) || each == '_') {
        press(KeyEvent.VK_SHIFT, key);
      } else {
        press(key);
      }
    }
  }

  /** Types digits and points. */
  public void type(String digits) {
    digits.chars().forEach(c -> press(c == '.' ? KeyEvent.VK_PERIOD : c));
  }

  /**
   * Paints a window's content into a PNG in {@code target/pictures}.
   *
   * @param scale 2 for how it looks on a screen of 200 %
   * @return the same
   */
  public static BufferedImage picture(Container content, String name, int scale) {
    BufferedImage image =
        onEdt(
            () -> {
              BufferedImage painted =
                  new BufferedImage(
                      content.getWidth() * scale,
                      content.getHeight() * scale,
                      BufferedImage.TYPE_INT_RGB);
              java.awt.Graphics2D graphics = painted.createGraphics();
              graphics.scale(scale, scale);
              content.paint(graphics);
              graphics.dispose();
              return painted;
            });
    write(image, name);
    return image;
  }

  private BufferedImage screen() {
    return robot.createScreenCapture(
        new Rectangle(java.awt.Toolkit.getDefaultToolkit().getScreenSize()));
  }

  private static void write(BufferedImage image, String name) {
    File file = new File("target/pictures/" + name + ".png");
    try {
      if (!file.getParentFile().isDirectory() && !file.getParentFile().mkdirs()) {
        throw new IOException("no folder " + file.getParent());
      }
      ImageIO.write(image, "png", file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}

package org.selectiverenderer.enricher.preview;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.selectiverenderer.apparatus.MouseButton;
import org.selectiverenderer.browser.navigation.KeyboardMouseControls;
import org.selectiverenderer.browser.navigation.NavigationKey;

/**
 * Handles mouse and keys in the preview. While the author looks, dragging orbits about the point
 * under the pointer, dragging with Shift or another button pans, the wheel zooms and a click
 * selects. While the author walks, it navigates as in {@code run}.
 */
final class PreviewInputController extends MouseAdapter implements KeyListener {
  /** Radians that the camera turns per unit dragged: a third of a degree. */
  private static final double TURN = Math.toRadians(1 / 3.0);

  /** Distance that the mouse may move during a click. */
  private static final int STILL = 4;

  private final PreviewCanvas view;
  private final PreviewThread thread;
  private final Clicks clicks;
  private int pressX;
  private int pressY;
  private int lastX;
  private int lastY;
  private boolean dragged;

  /** Whether the line of the comparison is being dragged. */
  private boolean line;

  /** What a click selects. */
  enum Picking {
    /** The object; its parent if it was clicked on before. */
    OBJECT,
    /** The innermost node: with Alt, or with Ctrl and Shift. */
    INNERMOST,
    /** The object in addition to what is selected, or no longer: with Ctrl or Shift. */
    ANOTHER;

    static Picking of(MouseEvent event) {
      boolean both = event.isControlDown() && event.isShiftDown();
      if (event.isAltDown() || both) {
        return INNERMOST;
      }
      return event.isControlDown() || event.isShiftDown() ? ANOTHER : OBJECT;
    }
  }

  /** Receives clicks on labels and on the scene. */
  interface Clicks {
    void label(PreviewFrame.Label label);

    /**
     * @param picking what the click selects, by the keys that were down
     */
    void scene(int pixelX, int pixelY, Picking picking);

    /** The right button was clicked, for the context menu of what is there. */
    void menu(MouseEvent event, int pixelX, int pixelY);
  }

  PreviewInputController(PreviewCanvas view, PreviewThread thread, Clicks clicks) {
    this.view = view;
    this.thread = thread;
    this.clicks = clicks;
    view.addMouseListener(this);
    view.addMouseMotionListener(this);
    view.addMouseWheelListener(this);
    view.addKeyListener(this);
    view.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            view.repaint();
          }

          @Override
          public void focusLost(FocusEvent event) {
            controls(KeyboardMouseControls::releaseAll);
            view.repaint();
          }
        });
  }

  private boolean walking() {
    return view.frame().map(PreviewFrame::walking).orElse(false);
  }

  private void controls(Consumer<KeyboardMouseControls> what) {
    thread.tell(stage -> what.accept(stage.controls()));
  }

  @Override
  public void mousePressed(MouseEvent event) {
    if (event.isConsumed()) {
      return; // by a handle of an area
    }
    view.requestFocusInWindow();
    pressX = event.getX();
    pressY = event.getY();
    lastX = pressX;
    lastY = pressY;
    dragged = false;
    line = !walking() && view.takesLine(pressX);
    if (line) {
      return;
    }
    if (walking()) {
      MouseButton button = NavigationKeyMap.button(event);
      controls(controls -> controls.buttonDown(button));
    } else {
      int x = view.toPixels(pressX);
      int y = view.toPixels(pressY);
      thread.tell(stage -> stage.grab(x, y));
    }
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    if (line) {
      view.line(event.getX() / (double) Math.max(1, view.getWidth()));
    }
    if (line || event.isConsumed()) {
      return;
    }
    int dx = event.getX() - lastX;
    int dy = event.getY() - lastY;
    dragged |= Math.hypot(event.getX() - pressX, event.getY() - pressY) > STILL;
    if (walking()) {
      lastX = event.getX();
      lastY = event.getY();
      controls(controls -> controls.drag(dx, dy));
    } else if (dragged) {
      lastX = event.getX();
      lastY = event.getY();
      if (SwingUtilities.isLeftMouseButton(event) && !event.isShiftDown()) {
        thread.tell(stage -> stage.orbit().turn(-dx * TURN, -dy * TURN));
      } else {
        double side = Math.max(1, Math.min(view.getWidth(), view.getHeight()));
        thread.tell(stage -> stage.orbit().pan(-dx / side, dy / side));
      }
    }
  }

  @Override
  public void mouseReleased(MouseEvent event) {
    if (event.isConsumed()) {
      return;
    }
    if (line) {
      line = false;
    } else if (walking()) {
      MouseButton button = NavigationKeyMap.button(event);
      int x = view.toPixels(event.getX());
      int y = view.toPixels(event.getY());
      thread.tell(
          stage -> {
            stage.point(x, y);
            stage.controls().buttonUp(button);
          });
    } else if (!dragged && SwingUtilities.isLeftMouseButton(event)) {
      click(event);
    } else if (!dragged && SwingUtilities.isRightMouseButton(event)) {
      clicks.menu(event, view.toPixels(event.getX()), view.toPixels(event.getY()));
    }
  }

  /** Sends a click to what is there: a label or the scene. */
  void click(MouseEvent event) {
    view.labelAt(event.getX(), event.getY())
        .ifPresentOrElse(
            clicks::label,
            () ->
                clicks.scene(
                    view.toPixels(event.getX()), view.toPixels(event.getY()), Picking.of(event)));
  }

  @Override
  public void mouseWheelMoved(MouseWheelEvent event) {
    double notches = -event.getPreciseWheelRotation();
    if (walking()) {
      controls(controls -> controls.wheel(notches));
    } else {
      int x = view.toPixels(event.getX());
      int y = view.toPixels(event.getY());
      thread.tell(
          stage -> {
            stage.grab(x, y);
            stage.orbit().zoom(notches);
          });
    }
  }

  /** Whether a key belongs to a command of the window, such as Ctrl+S. */
  private static boolean command(KeyEvent event) {
    return event.isControlDown() || event.isAltDown() || event.isMetaDown();
  }

  @Override
  public void keyPressed(KeyEvent event) {
    if (walking() && !command(event)) {
      NavigationKeyMap.key(event)
          .ifPresent(
              key -> {
                controls(controls -> controls.keyDown(key));
                event.consume();
              });
    }
  }

  @Override
  public void keyReleased(KeyEvent event) {
    NavigationKeyMap.key(event).ifPresent(key -> controls(controls -> controls.keyUp(key)));
  }

  @Override
  public void keyTyped(KeyEvent event) {
    // Navigation has no use for characters.
  }

  /** Maps Swing's keys and mouse buttons to those of navigation. */
  private static final class NavigationKeyMap {
    private static final Map<Integer, NavigationKey> KEYS =
        Map.ofEntries(
            Map.entry(KeyEvent.VK_UP, NavigationKey.UP),
            Map.entry(KeyEvent.VK_DOWN, NavigationKey.DOWN),
            Map.entry(KeyEvent.VK_LEFT, NavigationKey.LEFT),
            Map.entry(KeyEvent.VK_RIGHT, NavigationKey.RIGHT),
            Map.entry(KeyEvent.VK_W, NavigationKey.W),
            Map.entry(KeyEvent.VK_A, NavigationKey.A),
            Map.entry(KeyEvent.VK_S, NavigationKey.S),
            Map.entry(KeyEvent.VK_D, NavigationKey.D),
            Map.entry(KeyEvent.VK_E, NavigationKey.E),
            Map.entry(KeyEvent.VK_Q, NavigationKey.Q),
            Map.entry(KeyEvent.VK_SHIFT, NavigationKey.SHIFT),
            Map.entry(KeyEvent.VK_HOME, NavigationKey.HOME),
            Map.entry(KeyEvent.VK_END, NavigationKey.END),
            Map.entry(KeyEvent.VK_PAGE_UP, NavigationKey.PAGE_UP),
            Map.entry(KeyEvent.VK_PAGE_DOWN, NavigationKey.PAGE_DOWN),
            Map.entry(KeyEvent.VK_F2, NavigationKey.F2),
            Map.entry(KeyEvent.VK_F3, NavigationKey.F3),
            Map.entry(KeyEvent.VK_F5, NavigationKey.F5));

    private NavigationKeyMap() {}

    static Optional<NavigationKey> key(KeyEvent event) {
      return Optional.ofNullable(KEYS.get(event.getKeyCode()));
    }

    static MouseButton button(MouseEvent event) {
      if (SwingUtilities.isLeftMouseButton(event)) {
        return MouseButton.LEFT;
      }
      return SwingUtilities.isMiddleMouseButton(event) ? MouseButton.MIDDLE : MouseButton.RIGHT;
    }
  }
}

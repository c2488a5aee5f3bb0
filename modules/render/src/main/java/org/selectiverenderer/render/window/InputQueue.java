package org.selectiverenderer.render.window;

import com.jogamp.newt.event.KeyEvent;
import com.jogamp.newt.event.KeyListener;
import com.jogamp.newt.event.MouseEvent;
import com.jogamp.newt.event.MouseListener;
import com.jogamp.newt.event.WindowAdapter;
import com.jogamp.newt.event.WindowEvent;
import com.jogamp.newt.opengl.GLWindow;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentLinkedQueue;

/** Queues NEWT's input events, which come on NEWT's thread, for the render thread. */
final class InputQueue extends WindowAdapter implements KeyListener, MouseListener {
  private final ConcurrentLinkedQueue<InputEvent> events = new ConcurrentLinkedQueue<>();
  private final Map<Short, String> characters = new HashMap<>();
  private boolean inside;
  private int lastX;
  private int lastY;

  /** Delivers the events since the last call; render thread. */
  void drain(InputListener listener) {
    for (InputEvent event = events.poll(); event != null; event = events.poll()) {
      listener.input(event);
    }
  }

  @Override
  public void keyPressed(KeyEvent event) {
    key(event, true);
  }

  @Override
  public void keyReleased(KeyEvent event) {
    // NEWT reports a held key as repeatedly released and pressed.
    if (!event.isAutoRepeat()) {
      key(event, false);
    }
  }

  private void key(KeyEvent event, boolean pressed) {
    KeyboardKey key = KeyboardKey.of(event.getKeySymbol());
    short code = event.getKeyCode();
    String character =
        pressed ? KeyCharacters.of(key, event.getKeyChar()) : characters.getOrDefault(code, "");
    if (pressed) {
      characters.put(code, character); // Shift may be released first.
    } else {
      characters.remove(code);
    }
    events.add(new InputEvent.KeyInput(key, pressed, character));
  }

  @Override
  public void mousePressed(MouseEvent event) {
    button(event, true);
  }

  @Override
  public void mouseReleased(MouseEvent event) {
    button(event, false);
  }

  private void button(MouseEvent event, boolean pressed) {
    events.add(new InputEvent.ButtonInput(event.getButton(), pressed, event.getX(), event.getY()));
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    mouseMoved(event);
  }

  @Override
  public void mouseMoved(MouseEvent event) {
    float scale =
        event.getSource() instanceof GLWindow window ? NewtWindowFactory.scale(window) : 1;
    double dx = inside ? (event.getX() - lastX) / scale : 0;
    double dy = inside ? (event.getY() - lastY) / scale : 0;
    inside = true;
    lastX = event.getX();
    lastY = event.getY();
    events.add(new InputEvent.MotionInput(lastX, lastY, dx, dy));
  }

  @Override
  public void mouseExited(MouseEvent event) {
    inside = false;
  }

  @Override
  public void mouseWheelMoved(MouseEvent event) {
    events.add(new InputEvent.WheelInput(event.getRotation()[1]));
  }

  @Override
  public void windowLostFocus(WindowEvent event) {
    inside = false;
    characters.clear();
    events.add(new InputEvent.FocusLost());
  }

  @Override
  public void mouseClicked(MouseEvent event) {
    // Press and release are reported instead.
  }

  @Override
  public void mouseEntered(MouseEvent event) {
    inside = false;
  }

  /** The characters that keys produce, as KeySensor and StringSensor need them. */
  private static final class KeyCharacters {
    private KeyCharacters() {}

    /**
     * Returns the character of a key that is pressed; empty where it produces none.
     *
     * @param typed the character that the window system reports, a control character while Control
     *     is held
     */
    static String of(KeyboardKey key, char typed) {
      return switch (key) {
        case ENTER -> "\n";
        case TAB -> "\t";
        case BACKSPACE -> "\b";
        case DELETE -> "\u007f";
        case SPACE -> " ";
        default -> {
          if (key.special()) {
            yield "";
          }
          boolean produced = Character.isDefined(typed) && !Character.isISOControl(typed);
          yield produced ? String.valueOf(typed) : key.letter();
        }
      };
    }
  }
}

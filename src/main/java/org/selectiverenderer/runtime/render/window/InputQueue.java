package org.selectiverenderer.runtime.render.window;

import com.jogamp.newt.event.KeyEvent;
import com.jogamp.newt.event.KeyListener;
import com.jogamp.newt.event.MouseEvent;
import com.jogamp.newt.event.MouseListener;
import com.jogamp.newt.event.WindowAdapter;
import com.jogamp.newt.event.WindowEvent;
import java.util.concurrent.ConcurrentLinkedQueue;

/** Takes NEWT's events on NEWT's thread and keeps them for the render thread. */
final class InputQueue extends WindowAdapter implements KeyListener, MouseListener {
  private final ConcurrentLinkedQueue<InputEvent> events = new ConcurrentLinkedQueue<>();
  private boolean inside;
  private int lastX;
  private int lastY;

  /** Hands over what came since the last call; render thread. */
  void drain(InputListener listener) {
    for (InputEvent event = events.poll(); event != null; event = events.poll()) {
      listener.input(event);
    }
  }

  private static InputEvent.Modifiers modifiers(com.jogamp.newt.event.InputEvent event) {
    return new InputEvent.Modifiers(event.isShiftDown(), event.isControlDown(), event.isAltDown());
  }

  @Override
  public void keyPressed(KeyEvent event) {
    key(event, true);
  }

  @Override
  public void keyReleased(KeyEvent event) {
    // A held key is reported as released and pressed again and again.
    if (!event.isAutoRepeat()) {
      key(event, false);
    }
  }

  private void key(KeyEvent event, boolean pressed) {
    events.add(
        new InputEvent.KeyInput(
            Key.of(event.getKeySymbol()), pressed, event.isAutoRepeat(), modifiers(event)));
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
    events.add(
        new InputEvent.ButtonInput(
            event.getButton(), pressed, event.getX(), event.getY(), modifiers(event)));
  }

  @Override
  public void mouseMoved(MouseEvent event) {
    motion(event, 0);
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    motion(event, event.getButtonsDown().length == 0 ? 0 : event.getButtonsDown()[0]);
  }

  private void motion(MouseEvent event, int button) {
    int dx = inside ? event.getX() - lastX : 0;
    int dy = inside ? event.getY() - lastY : 0;
    inside = true;
    lastX = event.getX();
    lastY = event.getY();
    events.add(new InputEvent.MotionInput(lastX, lastY, dx, dy, button, modifiers(event)));
  }

  @Override
  public void mouseExited(MouseEvent event) {
    inside = false;
  }

  @Override
  public void mouseWheelMoved(MouseEvent event) {
    events.add(
        new InputEvent.WheelInput(
            event.getRotation()[1], event.getX(), event.getY(), modifiers(event)));
  }

  @Override
  public void windowLostFocus(WindowEvent event) {
    inside = false;
    events.add(new InputEvent.FocusLost());
  }

  @Override
  public void mouseClicked(MouseEvent event) {
    // Press and release say it all.
  }

  @Override
  public void mouseEntered(MouseEvent event) {
    inside = false;
  }
}

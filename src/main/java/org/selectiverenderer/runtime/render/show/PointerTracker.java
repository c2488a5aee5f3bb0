package org.selectiverenderer.runtime.render.show;

import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.runtime.Pointer;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.render.window.FrameSize;
import org.selectiverenderer.runtime.render.window.InputEvent;

/**
 * Forwards the mouse to the world: the view ray under the pointer, and whether the button is
 * pressed.
 */
final class PointerTracker {
  private static final int LEFT = 1;

  private boolean pressed;

  /** Handles an event of a window that the world's view of that size fills. */
  void input(InputEvent event, World world, FrameSize size) {
    if (event instanceof InputEvent.MotionInput motion) {
      point(world, size, motion.x(), motion.y());
    } else if (event instanceof InputEvent.ButtonInput button && button.button() == LEFT) {
      pressed = button.pressed();
      point(world, size, button.x(), button.y());
    } else if (event instanceof InputEvent.FocusLost) {
      pressed = false;
      world.point(Pointer.AWAY);
    }
  }

  private void point(World world, FrameSize size, int x, int y) {
    double half = Math.tan(world.viewer().fieldOfView() / 2);
    double smaller = Math.min(size.width(), size.height());
    double right = (2 * (x + 0.5) - size.width()) / smaller * half;
    double up = (size.height() - 2 * (y + 0.5)) / smaller * half;
    double aspect = size.width() / (double) size.height();
    world.point(new Pointer(Optional.of(new Vector3d(right, up, -1)), pressed, aspect));
  }
}

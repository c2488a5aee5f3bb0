package org.selectiverenderer.render.window;

/** Receives the user's input in the order in which it came, on the render thread, before a step. */
@FunctionalInterface
public interface InputListener {
  void input(InputEvent event);
}

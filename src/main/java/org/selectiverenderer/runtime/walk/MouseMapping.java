package org.selectiverenderer.runtime.walk;

/** Which mouse button walks which way. */
public enum MouseMapping {
  /** Left forward, right backward (thesis 4.3). */
  WALK(1, -1),
  /** Right forward, left backward (thesis 6.1.1). */
  EXPERIMENT(-1, 1),
  /** The mouse moves nothing, for a head tracker alone. */
  OFF(0, 0);

  private final int left;
  private final int right;

  MouseMapping(int left, int right) {
    this.left = left;
    this.right = right;
  }

  /** 1 forward, -1 backward, 0 not at all. */
  int forward(MouseButton button) {
    return switch (button) {
      case LEFT -> left;
      case MIDDLE -> 0;
      case RIGHT -> right;
    };
  }
}

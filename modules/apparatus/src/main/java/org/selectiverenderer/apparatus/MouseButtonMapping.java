package org.selectiverenderer.apparatus;

/** The walking direction of each mouse button. */
public enum MouseButtonMapping {
  /** Left forward, right backward (thesis 4.3). */
  WALK(1, -1),
  /** Right forward, left backward (thesis 6.1.1). */
  EXPERIMENT(-1, 1),
  /** No button walks, for use of a head tracker alone. */
  OFF(0, 0);

  private final int left;
  private final int right;

  MouseButtonMapping(int left, int right) {
    this.left = left;
    this.right = right;
  }

  /** Returns the direction of a button: 1 forward, -1 backward, 0 none. */
  public int forward(MouseButton button) {
    return switch (button) {
      case LEFT -> left;
      case MIDDLE -> 0;
      case RIGHT -> right;
    };
  }
}

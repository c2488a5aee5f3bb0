package org.selectiverenderer.authoring;

/**
 * Keeps what belongs to the steps of an {@link UndoHistory} beside the text, such as a selection.
 * It is called on the thread that makes the steps; typing is not told when it is made.
 */
public interface UndoListener {
  /** Says what is done with a step. */
  enum Move {
    MAKE,
    UNDO,
    REDO
  }

  /**
   * A step is about to be made, undone or redone.
   *
   * @param step the number of the step, by which it is known as long as the history lives
   */
  void begins(Move move, long step);

  /** A step has been made, undone or redone; all listeners of the document have heard of it. */
  void ended(Move move, long step);
}

package org.web3d.x3d.sai;

/**
 * There is no such node or node type, or the node has been disposed of, or it does not belong where
 * it was put.
 */
public class InvalidNodeException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidNodeException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidNodeException(String message) {
    super(message);
  }
}

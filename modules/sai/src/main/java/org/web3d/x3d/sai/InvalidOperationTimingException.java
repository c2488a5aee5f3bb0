package org.web3d.x3d.sai;

/**
 * The operation is not allowed at this time, such as setting an initializeOnly field of a realized
 * node.
 */
public class InvalidOperationTimingException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidOperationTimingException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidOperationTimingException(String message) {
    super(message);
  }
}

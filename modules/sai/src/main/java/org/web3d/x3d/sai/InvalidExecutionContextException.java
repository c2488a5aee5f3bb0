package org.web3d.x3d.sai;

/** The scene or other execution context has been disposed of. */
public class InvalidExecutionContextException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidExecutionContextException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidExecutionContextException(String message) {
    super(message);
  }
}

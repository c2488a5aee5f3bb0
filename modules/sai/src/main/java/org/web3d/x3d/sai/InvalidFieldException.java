package org.web3d.x3d.sai;

/** A node has no such field. */
public class InvalidFieldException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidFieldException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidFieldException(String message) {
    super(message);
  }
}

package org.web3d.x3d.sai;

/** The field cannot be written, or cannot be the end of a route. */
public class InvalidWritableFieldException extends InvalidFieldException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidWritableFieldException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidWritableFieldException(String message) {
    super(message);
  }
}

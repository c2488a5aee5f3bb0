package org.web3d.x3d.sai;

/** The field cannot be read, or cannot be the start of a route. */
public class InvalidReadableFieldException extends InvalidFieldException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidReadableFieldException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidReadableFieldException(String message) {
    super(message);
  }
}

package org.web3d.x3d.sai;

/** A value does not fit the field that it is meant for. */
public class InvalidFieldValueException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidFieldValueException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidFieldValueException(String message) {
    super(message);
  }
}

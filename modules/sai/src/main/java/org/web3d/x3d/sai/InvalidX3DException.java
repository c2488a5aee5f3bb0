package org.web3d.x3d.sai;

/** A file or text is no X3D. */
public class InvalidX3DException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidX3DException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidX3DException(String message) {
    super(message);
  }
}

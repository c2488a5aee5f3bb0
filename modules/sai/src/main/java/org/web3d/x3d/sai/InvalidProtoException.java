package org.web3d.x3d.sai;

/** There is no such prototype. */
public class InvalidProtoException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidProtoException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidProtoException(String message) {
    super(message);
  }
}

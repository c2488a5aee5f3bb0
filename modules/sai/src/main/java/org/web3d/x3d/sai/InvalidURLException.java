package org.web3d.x3d.sai;

/** None of the given addresses leads to anything that can be read. */
public class InvalidURLException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidURLException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidURLException(String message) {
    super(message);
  }
}

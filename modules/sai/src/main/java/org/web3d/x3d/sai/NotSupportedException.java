package org.web3d.x3d.sai;

/** The browser does not do what it is asked for. */
public class NotSupportedException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public NotSupportedException() {}

  /** An exception that says what is wrong in one sentence. */
  public NotSupportedException(String message) {
    super(message);
  }
}

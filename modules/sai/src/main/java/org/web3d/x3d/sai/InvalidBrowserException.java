package org.web3d.x3d.sai;

/** The browser has been disposed of; nothing can be done with it any more. */
public class InvalidBrowserException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidBrowserException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidBrowserException(String message) {
    super(message);
  }
}

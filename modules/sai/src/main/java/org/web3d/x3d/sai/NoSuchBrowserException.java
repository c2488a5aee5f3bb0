package org.web3d.x3d.sai;

/** There is no browser where one was asked for. */
public class NoSuchBrowserException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public NoSuchBrowserException() {}

  /** An exception that says what is wrong in one sentence. */
  public NoSuchBrowserException(String message) {
    super(message);
  }
}

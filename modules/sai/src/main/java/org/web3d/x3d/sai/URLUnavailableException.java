package org.web3d.x3d.sai;

/** An address cannot be reached. */
public class URLUnavailableException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public URLUnavailableException() {}

  /** An exception that says what is wrong in one sentence. */
  public URLUnavailableException(String message) {
    super(message);
  }
}

package org.web3d.x3d.sai;

/** The browser belongs to somebody else who does not share it. */
public class BrowserNotSharedException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public BrowserNotSharedException() {}

  /** An exception that says what is wrong in one sentence. */
  public BrowserNotSharedException(String message) {
    super(message);
  }
}
